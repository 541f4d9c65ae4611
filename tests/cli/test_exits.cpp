// Exit statuses, what is refused and where results go, start-up time.
#include <doctest/doctest.h>
#include <sys/resource.h>

#include <algorithm>

#include "tests/cli/run.hpp"

namespace {

namespace fs = std::filesystem;
using mansard::test::contents;
using mansard::test::files_in;
using mansard::test::Run;
using mansard::test::run;
using mansard::test::TemporaryFolder;
using mansard::test::written;

const std::string root = MANSARD_ROOT;
const std::string box = root + "/bench/facade_box.style";
const std::string listings = root + "/styles/library/listings.style";

}  // namespace

TEST_CASE("exit statuses: 0 done, 1 wrong input, 2 wrong usage") {
  const TemporaryFolder folder;
  const std::string bad =
      written(folder, "bad.style", "style A { Plot { FOOTPRINT -> extrud(3) A } }");
  CHECK(run({}).status == 0);
  CHECK(run({"help"}).status == 0);
  CHECK(run({"--version"}).status == 0);
  CHECK(run({"derive", "--help"}).status == 0);
  CHECK(run({"check", box}).status == 0);
  CHECK(run({"check", bad}).status == 1);
  CHECK(run({"check", folder / "none.style"}).status == 1);
  CHECK(run({"check"}).status == 2);
  CHECK(run({"chek", box}).status == 2);
  CHECK(run({"check", box, "--what"}).status == 2);
  CHECK(run({"derive", box}).status == 2);
  CHECK(run({"derive", box, "rect:10x8"}).status == 2);  // no -o
  CHECK(run({"derive", box, "rect:10x8", "-o", folder / "model.fbx"}).status == 2);
  CHECK(run({"derive", box, "rect:10x8", "-o", folder / "model.obj", "--up", "x"}).status == 2);
  CHECK(run({"derive", bad, "rect:10x8", "-o", folder / "model.obj"}).status == 1);
  CHECK(run({"tree", box, "rect:10by8"}).status == 1);
  CHECK(run({"tree", box, "rect:10x8", "--symbol", "NOTHING"}).status == 1);
  CHECK(run({"help", "nonsense"}).status != 0);
}

TEST_CASE("nothing that is read is written over, and no device replaced") {
  const TemporaryFolder folder;
  const char* const corners = "v 0 0 0\nv 0 0 9\nv 9 0 9\nv 9 0 0\nf 1 2 3 4\n";
  const std::string plot = written(folder, "plot.obj", corners);
  const std::string model = folder / "model.obj";
  CHECK(run({"derive", box, plot, "-o", plot}).status == 2);
  CHECK(run({"derive", box, plot, "-o", model, "--report", plot}).status == 2);
  CHECK(run({"derive", box, plot, "-o", model, "--report", model}).status == 2);
  CHECK(contents(plot) == corners);
  CHECK(files_in(folder) == 1);
  fs::create_symlink("/dev/full", folder / "full.json");
  const Run full = run({"derive", box, plot, "-o", model, "--report", folder / "full.json"});
  CHECK(full.status == 1);
  CHECK(full.err.find("No space left on device") != std::string::npos);
  CHECK(fs::is_character_file(folder / "full.json"));
  const std::string endless = written(
      folder, "endless.style", "style S { Plot { FOOTPRINT -> texture(\"/dev/zero\") PLOT } }");
  const Run zeros = run({"derive", endless, "rect:10x8", "-o", model});
  CHECK(zeros.status == 0);
  CHECK(zeros.err.find("W020") != std::string::npos);
}

TEST_CASE("variables that read others twice are checked at once and bounded where derived") {
  const auto doubling = [](const std::string& first) {
    std::string text = "style S { var v0 = " + first;
    for (int i = 1; i < 64; ++i) {
      const std::string before = "v" + std::to_string(i - 1);
      text += " var v" + std::to_string(i) + " = " + before + " + " + before;
    }
    return text + " Plot { FOOTPRINT -> extrude(v63 / 1e18) { MASS } } }";
  };
  const TemporaryFolder folder;
  const std::string once = written(folder, "once.style", doubling("1"));
  CHECK(run({"tree", once, "rect:10x8"}).status == 0);
  const std::string each = written(folder, "each.style", doubling("W"));
  CHECK(run({"check", each}).status == 0);
  const Run tree = run({"tree", each, "rect:10x8"});
  CHECK(tree.status == 1);
  CHECK(tree.err.find("more than 20 million calls") != std::string::npos);
}

TEST_CASE("what reaches beyond all measure is an error, not a model without numbers") {
  const TemporaryFolder folder;
  for (const char* const rule : {"s(1e200, 1e200, 1e200) sphere() BALL", "r(1e308, 1e308, 0) PLOT",
                                 "extrude(1e300) { MASS }", "t(1e300, 0, 0) PLOT"}) {
    const std::string text = std::string("style S { Plot { FOOTPRINT -> ") + rule + " } }";
    const std::string style = written(folder, "far.style", text);
    const Run far = run({"derive", style, "rect:10x8", "-o", folder / "far.obj"});
    CHECK_MESSAGE(far.status == 1, rule);
    CHECK_MESSAGE(far.err.find("reaches further than") != std::string::npos, far.err);
  }
}

TEST_CASE("results go where -o says and nowhere else") {
  const TemporaryFolder folder;
  const Run derive = run({"derive", box, "rect:10x8", "-o", folder / "model.obj"});
  CHECK(derive.status == 0);
  CHECK(derive.out.empty());
  CHECK(files_in(folder) == 2);  // and its .mtl
  CHECK(run({"derive", box, "rect:10x8", "-o", folder / "model.obj", "--quiet"}).err.empty());
}

TEST_CASE("an abstract style may hand arguments to what its heirs will give") {
  const Run check =
      run({"check", root + "/tests/golden/styles_run/abstract_with_parameters.style"});
  CHECK(check.status == 0);
}

TEST_CASE("a report that can not be written is said before the work") {
  const TemporaryFolder folder;
  const Run derive = run({"derive", box, "rect:10x8", "-o", folder / "model.obj", "--report",
                          folder / "none/report.json"});
  CHECK(derive.status == 1);
  CHECK(derive.err.find("none/report.json") != std::string::npos);
  CHECK(files_in(folder) == 0);
}

TEST_CASE("check takes 10 ms of the processor, three times that on a busy machine") {
  const auto spent = [] {
    rusage children{};
    getrusage(RUSAGE_CHILDREN, &children);
    const auto ms = [](timeval t) {
      return static_cast<double>(t.tv_sec) * 1e3 + static_cast<double>(t.tv_usec) / 1e3;
    };
    return ms(children.ru_utime) + ms(children.ru_stime);
  };
  std::vector<double> times;
  for (int i = 0; i < 9; ++i) {
    const double before = spent();
    CHECK(run({"check", listings}).status == 0);
    times.push_back(spent() - before);
  }
  std::ranges::sort(times);
  MESSAGE("median ", times[4], " ms");
#if !defined(__SANITIZE_ADDRESS__)
  CHECK(times[4] < 3 * 10);
#endif
}
