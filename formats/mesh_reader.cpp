// mansard_mesh_reader FILE MEGABYTES MEMORY SECONDS [FOLDER...]: reads a mesh by Assimp and writes
// its bytes, or what is wrong with it, to standard output. Started by read_apart().
#include <sys/resource.h>
#include <sys/time.h>
#include <unistd.h>

#include <cstdlib>
#include <new>

#include "formats/assimp_reader.hpp"
#include "formats/mesh_stream.hpp"

namespace {

using namespace mansard;

void limit(int what, rlim_t most) {
  const rlimit both{most, most};
  setrlimit(what, &both);
}

void limit_process(const MeshLimits& limits) {
  limit(RLIMIT_CORE, 0);
  const auto whole = static_cast<time_t>(limits.seconds);
  const auto rest = static_cast<suseconds_t>((limits.seconds - static_cast<double>(whole)) * 1e6);
  const itimerval once{{0, 0}, {whole, rest}};
  setitimer(ITIMER_PROF, &once, nullptr);  // SIGPROF ends the process
#ifndef __SANITIZE_ADDRESS__               // which reserves terabytes
  limit(RLIMIT_AS, limits.memory * 1024 * 1024);
#endif
}

std::string result(const std::string& path, const MeshLimits& limits) try {
  Mesh mesh;
  std::string problem;
  return read_by_assimp(path, limits, mesh, problem) ? to_bytes(mesh) : to_bytes(problem);
} catch (const std::bad_alloc&) {
  return to_bytes("it needs more than " + std::to_string(limits.memory) + " MB of memory");
} catch (const std::exception& e) {
  return to_bytes(e.what());
}

}  // namespace

int main(int count, char** words) {
  if (count < 5) return 2;
  MeshLimits limits;
  limits.megabytes = std::strtoull(words[2], nullptr, 10);
  limits.memory = std::strtoull(words[3], nullptr, 10);
  limits.seconds = std::strtod(words[4], nullptr);
  limits.folders.assign(words + 5, words + count);
  limit_process(limits);
  const std::string bytes = result(words[1], limits);
  for (std::size_t at = 0; at < bytes.size();) {
    const ssize_t written = write(STDOUT_FILENO, bytes.data() + at, bytes.size() - at);
    if (written <= 0) break;
    at += static_cast<std::size_t>(written);
  }
  _exit(0);  // what Assimp lost on the way goes with the process
}
