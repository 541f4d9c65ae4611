// The table of commands: from its rows come parsing, `mansard help` and the manual.
#pragma once

#include <span>
#include <string_view>

namespace mansard {

class Arguments;

struct Flag {
  std::string_view name;   ///< "--seed", or "-o,--output"
  std::string_view value;  ///< what it takes, "N"; empty for a switch
  std::string_view summary;
  bool repeatable = false;
};

struct Command {
  std::string_view name;
  std::string_view usage;  ///< what follows the name
  std::string_view summary;
  std::size_t least = 0, most = 0;  ///< how many positional arguments
  std::span<const Flag> flags;
  std::string_view examples;  ///< a command line each line
  int (*run)(const Arguments&) = nullptr;
};

/// Exit statuses.
enum Exit : int { exit_done = 0, exit_input = 1, exit_usage = 2, exit_internal = 3 };

std::span<const Command> commands();
const Command* find_command(std::string_view name);

int run_derive(const Arguments&);
int run_check(const Arguments&);
int run_format(const Arguments&);
int run_explain(const Arguments&);
int run_tree(const Arguments&);
int run_render(const Arguments&);
int run_vary(const Arguments&);
int run_stains(const Arguments&);
int run_lsp(const Arguments&);
int run_help(const Arguments&);

}  // namespace mansard
