// mansard format as users run it: what it prints, writes and answers.
#include <doctest/doctest.h>
#include <sys/stat.h>

#include <algorithm>
#include <fstream>
#include <sstream>

#include "tests/cli/run.hpp"

namespace {

namespace fs = std::filesystem;
using mansard::test::contents;
using mansard::test::files_in;
using mansard::test::Run;
using mansard::test::run;
using mansard::test::TemporaryFolder;
using mansard::test::written;

const std::string untidy = "class A\n{ Plot { FOOTPRINT->extrude( 3 ){A} }\n}\n";
const std::string tidy = "style A {\n    Plot { FOOTPRINT -> extrude(3) { A } }\n}\n";
const std::string wrong = "style A { Plot { FOOTPRINT -> } }\n";

}  // namespace

TEST_CASE("format prints the layout and leaves the file alone") {
  const TemporaryFolder folder;
  const std::string file = written(folder, "a.style", untidy);
  const Run once = run({"format", file});
  CHECK(once.status == 0);
  CHECK(once.out == tidy);
  CHECK(once.err.empty());
  CHECK(contents(file) == untidy);
  CHECK(run({"format", file, file}).out == tidy + tidy);
}

TEST_CASE("format reads standard input without a file, or for -") {
  for (const std::vector<std::string>& words :
       {std::vector<std::string>{"format"}, {"format", "-"}}) {
    const Run piped = run(words, ".", untidy);
    CHECK(piped.status == 0);
    CHECK(piped.out == tidy);
  }
  CHECK(run({"format", "--check"}, ".", tidy).status == 0);
  const Run check = run({"format", "--check"}, ".", untidy);
  CHECK(check.status == 1);
  CHECK(check.out == "<standard input>\n");
  CHECK(run({"format", "--write"}, ".", untidy).status == 2);
}

TEST_CASE("format --write changes what needs it, through links and with its permissions") {
  const TemporaryFolder folder;
  const std::string file = written(folder, "a.style", untidy);
  const std::string other = written(folder, "b.style", tidy);
  fs::create_symlink("a.style", folder / "link.style");
  chmod(file.c_str(), 0754);
  const auto before = fs::last_write_time(other);
  const Run once = run({"format", "--write", folder / "link.style", other});
  CHECK(once.status == 0);
  CHECK(once.out.empty());
  CHECK(once.err == "1 file changed\n");
  CHECK(contents(file) == tidy);
  CHECK(fs::is_symlink(folder / "link.style"));
  CHECK(static_cast<unsigned>(fs::status(file).permissions()) == 0754);
  CHECK(fs::last_write_time(other) == before);
  CHECK(files_in(folder) == 3);
  CHECK(run({"format", "--write", "--quiet", file}).err.empty());
}

TEST_CASE("format --check names what would change") {
  const TemporaryFolder folder;
  const std::string file = written(folder, "a.style", untidy);
  const std::string other = written(folder, "b.style", tidy);
  const Run check = run({"format", "--check", file, other});
  CHECK(check.status == 1);
  CHECK(check.out == file + "\n");
  CHECK(check.err == "1 file would change\n");
  CHECK(contents(file) == untidy);
  CHECK(run({"format", "--check", other}).status == 0);
}

TEST_CASE("format --diff can be applied") {
  const TemporaryFolder folder;
  const std::string file = written(folder, "a.style", untidy);
  const Run diff = run({"format", "--diff", "a.style"}, folder.path());
  CHECK(diff.status == 0);
  CHECK(diff.out ==
        "--- a.style\n+++ a.style\n@@ -1,3 +1,3 @@\n-class A\n-{ Plot { FOOTPRINT->extrude( 3 ){A} "
        "}\n"
        "+style A {\n+    Plot { FOOTPRINT -> extrude(3) { A } }\n }\n");
  CHECK(run({"format", "--diff", "--check", file}).status == 1);
  const std::string cut = written(folder, "b.style", tidy.substr(0, tidy.size() - 1));
  CHECK(run({"format", "--diff", cut})
            .out.ends_with(
                "@@ -1,3 +1,3 @@\n style A {\n     Plot { FOOTPRINT -> extrude(3) { A } }\n"
                "-}\n\\ No newline at end of file\n+}\n"));
  CHECK(run({"format", "--diff", "--write", file}).status == 2);
}

TEST_CASE("a script with errors stays as it is, the others are still formatted") {
  const TemporaryFolder folder;
  const std::string bad = written(folder, "bad.style", wrong);
  const std::string good = written(folder, "good.style", untidy);
  const Run all = run({"format", "--write", bad, folder / "none.style", good});
  CHECK(all.status == 1);
  CHECK(all.err.find("bad.style:1:") != std::string::npos);
  CHECK(all.err.find("none.style") != std::string::npos);
  CHECK(contents(bad) == wrong);
  CHECK(contents(good) == tidy);
  CHECK(run({"format", bad}).out.empty());
}

TEST_CASE("every example derives the same bytes however it is laid out") {
  const fs::path root = MANSARD_ROOT;
  const TemporaryFolder as_is, anew;
  std::size_t derived = 0;
  for (const TemporaryFolder* folder : {&as_is, &anew}) {
    fs::copy(root / "examples", folder->path() / "examples", fs::copy_options::recursive);
    fs::create_directory(folder->path() / "out");
  }
  for (const auto& entry : fs::recursive_directory_iterator(anew.path())) {
    if (entry.path().extension() != ".style") continue;
    // All on one line, but for the comments: then formatted.
    std::istringstream lines(contents(entry.path()));
    std::string text;
    for (std::string line; std::getline(lines, line);) {
      const bool comment = line.find("//") != std::string::npos;
      text += comment ? "\n" + line + "\n" : line + " ";
    }
    std::ofstream(entry.path(), std::ios::binary) << text;
    CHECK(run({"format", "--write", "--quiet", entry.path().string()}).status == 0);
  }
  for (const auto& entry : fs::recursive_directory_iterator(as_is.path() / "examples")) {
    if (entry.path().extension() != ".style") continue;
    std::istringstream words(
        contents(entry.path()).substr(contents(entry.path()).find("run:") + 4));
    std::vector<std::string> command;
    std::string word;
    for (words >> word; words >> word && word != "style" && !word.starts_with("/");) {
      command.push_back(word);
      if (word.starts_with("out/")) break;
    }
    if (command.empty() || command[0] != "derive" || !command.back().ends_with(".obj")) continue;
    CHECK(run(command, as_is.path()).status == 0);
    CHECK(run(command, anew.path()).status == 0);
    const std::string model = contents(as_is / command.back());
    CHECK(model.size() > 1000);
    CHECK_MESSAGE(model == contents(anew / command.back()), command.back());
    ++derived;
  }
  CHECK(derived >= 7);
}
