#include "formats/mesh_process.hpp"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <sstream>
#include <vector>

#include "formats/mesh_stream.hpp"
#include "formats/module.hpp"

extern char** environ;

namespace mansard {
namespace {

struct Pipe {
  std::array<int, 2> ends{-1, -1};
  bool open() { return pipe2(ends.data(), O_CLOEXEC) == 0; }
  void close(int end) {
    if (ends[end] >= 0) ::close(ends[end]);
    ends[end] = -1;
  }
  Pipe() = default;
  Pipe(const Pipe&) = delete;
  Pipe& operator=(const Pipe&) = delete;
  ~Pipe() {
    close(0);
    close(1);
  }
};

/// The process; 0 where it can not be started, which errno explains. Its output goes into the pipe,
/// what Assimp prints elsewhere nowhere.
pid_t started(std::vector<std::string> words, const Pipe& pipe) {
  std::vector<char*> arguments;
  arguments.reserve(words.size() + 1);
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, 0, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_adddup2(&actions, pipe.ends[1], 1);
  posix_spawn_file_actions_addopen(&actions, 2, "/dev/null", O_WRONLY, 0);
  pid_t process = 0;
  const int error =
      posix_spawn(&process, arguments[0], &actions, nullptr, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  errno = error;
  return error == 0 ? process : 0;
}

std::string all_of(int from) {
  std::string bytes;
  std::array<char, 1 << 16> buffer;
  for (;;) {
    const ssize_t count = read(from, buffer.data(), buffer.size());
    if (count > 0) bytes.append(buffer.data(), static_cast<std::size_t>(count));
    if (count == 0 || (count < 0 && errno != EINTR)) return bytes;
  }
}

std::string text_of(double number) {
  std::ostringstream text;
  text << number;
  return text.str();
}

std::string how_it_ended(pid_t process, const MeshLimits& limits) {
  int status = 0;
  while (waitpid(process, &status, 0) < 0 && errno == EINTR) continue;
  if (WIFSIGNALED(status) && WTERMSIG(status) == SIGPROF)
    return "it takes more than " + text_of(limits.seconds) + " seconds to read";
  return "it is broken: the reader stops in the middle of it";
}

}  // namespace

std::optional<Mesh> read_apart(const std::string& path, const MeshLimits& limits,
                               std::string& problem) {
  std::vector<std::string> words{program_beside("mansard_mesh_reader", problem), path,
                                 std::to_string(limits.megabytes), std::to_string(limits.memory),
                                 text_of(limits.seconds)};
  if (words[0].empty()) return {};
  words.insert(words.end(), limits.folders.begin(), limits.folders.end());
  Pipe pipe;
  const pid_t process = pipe.open() ? started(std::move(words), pipe) : 0;
  if (process == 0) {
    problem = std::string("the reader of meshes does not start: ") + std::strerror(errno);
    return {};
  }
  pipe.close(1);
  const std::string bytes = all_of(pipe.ends[0]);
  problem = how_it_ended(process, limits);
  return mesh_from_bytes(bytes, problem);
}

}  // namespace mansard
