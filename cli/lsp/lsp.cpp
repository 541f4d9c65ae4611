// mansard lsp
#include <fcntl.h>
#include <unistd.h>

#include <csignal>

#include "cli/lsp/server.hpp"

namespace mansard {

/// Messages go where standard output went; whatever a library prints there must not get between
/// them, so that standard output becomes standard error.
int run_lsp(const Arguments& arguments) {
  std::signal(SIGPIPE, SIG_IGN);
  const int out = fcntl(STDOUT_FILENO, F_DUPFD_CLOEXEC, STDERR_FILENO + 1);
  if (out < 0 || dup2(STDERR_FILENO, STDOUT_FILENO) < 0)
    throw UsageError("'mansard lsp' speaks to an editor on standard input and output");
  return lsp::Server(STDIN_FILENO, out, style_path(arguments)).run();
}

}  // namespace mansard
