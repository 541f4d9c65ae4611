// mansard check
#include "cli/session.hpp"

namespace mansard {

int run_check(const Arguments& arguments) {
  bool good = true;
  for (const std::string& script : arguments.positional()) {
    Session session(arguments);
    CompileOptions options = compile_options(arguments);
    options.all_styles = true;
    const bool sound = session.compile(script, options);
    if (sound && !arguments.has("--json")) session.say(script + ": no errors");
    good = good && sound;
  }
  return good ? exit_done : exit_input;
}

}  // namespace mansard
