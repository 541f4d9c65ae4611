#include "tests/cli/run.hpp"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <fstream>
#include <iterator>
#include <stdexcept>

namespace mansard::test {

Run run(const std::vector<std::string>& arguments, const std::filesystem::path& folder,
        const std::string& input) {
  const TemporaryFolder streams;
  const std::string in = streams / "in", out = streams / "out", err = streams / "err";
  std::ofstream(in, std::ios::binary) << input;
  std::vector<char*> argv;
  std::string program = MANSARD_PROGRAM;
  argv.push_back(program.data());
  std::vector<std::string> words = arguments;
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  const pid_t child = fork();
  if (child == 0) {
    const auto replace = [](int stream, const std::string& path) {
      return dup2(open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600), stream);
    };
    if (dup2(open(in.c_str(), O_RDONLY), 0) < 0 || replace(1, out) < 0 || replace(2, err) < 0 ||
        chdir(folder.c_str()) != 0)
      _exit(99);
    execv(argv[0], argv.data());
    _exit(98);
  }
  if (child < 0) throw std::runtime_error("can not start a process");
  int how = 0;
  waitpid(child, &how, 0);
  return {WIFEXITED(how) ? WEXITSTATUS(how) : 128 + WTERMSIG(how), contents(out), contents(err)};
}

std::string contents(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

TemporaryFolder::TemporaryFolder() {
  std::string name = (std::filesystem::temp_directory_path() / "mansard-XXXXXX").string();
  if (!mkdtemp(name.data())) throw std::runtime_error("can not make " + name);
  path_ = name;
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

std::string written(const TemporaryFolder& folder, const std::string& name,
                    const std::string& text) {
  std::ofstream(folder / name, std::ios::binary) << text;
  return folder / name;
}

std::size_t files_in(const TemporaryFolder& folder) {
  return static_cast<std::size_t>(
      std::distance(std::filesystem::directory_iterator(folder.path()), {}));
}

}  // namespace mansard::test
