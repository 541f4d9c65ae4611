// mansard: buildings from footprints and .style scripts.
#include <malloc.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <exception>

#include "cli/arguments.hpp"
#include "cli/command.hpp"
#include "grammar/diagnostic.hpp"

namespace mansard {
namespace {

const Command& command_of(const char* word) {
  if (const Command* found = find_command(word)) return *found;
  if (std::string_view(word).ends_with(".style"))
    throw UsageError("a command stands first: mansard render " + std::string(word) +
                     " rect:10x8 -o picture.png");
  std::vector<std::string_view> names;
  for (const Command& c : commands()) names.push_back(c.name);
  const auto meant = nearest(word, names);
  throw UsageError("unknown command '" + std::string(word) + "'" +
                   (meant ? "; did you mean '" + std::string(*meant) + "'?" : "") +
                   ": see 'mansard help'");
}

/// Large blocks go back to the system when they are freed: else the C library keeps ever larger
/// ones, and memory grows with the largest buildings of a city.
void return_large_blocks() {
#ifdef M_MMAP_THRESHOLD
  constexpr int bytes = 256 * 1024;
  mallopt(M_MMAP_THRESHOLD, bytes);
#endif
}

int run(int argc, char** argv) {
  return_large_blocks();
  const char* word = argc > 1 ? argv[1] : "help";
  if (std::strcmp(word, "--help") == 0 || std::strcmp(word, "-h") == 0) word = "help";
  if (std::strcmp(word, "--version") == 0) {
    std::printf("mansard %s\n", MANSARD_VERSION);
    return exit_done;
  }
  const Command& command = command_of(word);
  for (int i = 2; i < argc; ++i) {
    if (std::strcmp(argv[i], "--help") == 0 || std::strcmp(argv[i], "-h") == 0) {
      const char* const topic[] = {"help", word};
      return run_help(Arguments::parse(*find_command("help"), 2, topic));
    }
  }
  // `mansard help --camera` asks about a flag.
  const bool asks = &command == find_command("help") && argc == 3 && argv[2][0] == '-';
  if (asks && std::strcmp(argv[2], "--json") != 0) {
    const char* const words[] = {"help", "--", argv[2]};
    return run_help(Arguments::parse(command, 3, words));
  }
  const int shift = argc > 1 ? 1 : 0;
  return command.run(Arguments::parse(command, argc - shift, argv + shift));
}

void print(const std::string& text) { std::fputs(text.c_str(), stderr); }

/// What was printed must have arrived: the disk may be full.
int checked(int status) {
  if (std::fflush(stdout) == 0 && std::ferror(stdout) == 0) return status;
  print("error: can not write to standard output: " + std::string(std::strerror(errno)) + "\n");
  return exit_input;
}

}  // namespace
}  // namespace mansard

int main(int argc, char** argv) {
  using namespace mansard;
  try {
    return checked(run(argc, argv));
  } catch (const UsageError& error) {
    print("error: " + error.text + "\n");
    return exit_usage;
  } catch (const Failure& failure) {
    print(to_text(failure.diagnostic));
    return exit_input;
  } catch (const std::bad_alloc&) {
    print("error: out of memory\n");
    return exit_internal;
  } catch (const std::exception& error) {
    print("internal error: " + std::string(error.what()) + "\n");
    return exit_internal;
  }
}
