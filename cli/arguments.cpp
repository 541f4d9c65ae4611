#include "cli/arguments.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>

#include "grammar/diagnostic.hpp"

namespace mansard {
namespace {

/// The long spelling of "-o,--output".
std::string key_of(const Flag& flag) {
  const auto comma = flag.name.find(',');
  return std::string(comma == std::string_view::npos ? flag.name : flag.name.substr(comma + 1));
}

std::string nearest_flag(const Command& command, std::string_view word) {
  std::vector<std::string> names;
  for (const Flag& flag : command.flags) names.push_back(key_of(flag));
  std::vector<std::string_view> views(names.begin(), names.end());
  if (word.starts_with("--seeds") && std::ranges::find(names, "--count") != names.end())
    return "; --count N draws N seeds";
  const auto meant = nearest(word.substr(0, word.find('=')), views);
  return meant ? "; did you mean '" + std::string(*meant) + "'?" : "";
}

/// A list that a space tore: `--styles House, Mine`.
std::string torn_list(const Command& command, int argc, const char* const* argv) {
  for (int i = 1; i + 2 < argc; ++i) {
    const std::string_view value = argv[i + 1];
    const bool is_flag = std::ranges::any_of(
        command.flags, [&](const Flag& flag) { return flag.name == std::string_view(argv[i]); });
    if (is_flag && value.ends_with(','))
      return "a space ends the list: write " + std::string(argv[i]) + " " + std::string(value) +
             std::string(argv[i + 2]);
  }
  return {};
}

}  // namespace

Arguments Arguments::parse(const Command& command, int argc, const char* const* argv) {
  Arguments result;
  CLI::App app;
  app.set_help_flag();
  app.allow_extras(false);
  std::map<std::string, std::vector<std::string>> values;
  std::map<std::string, CLI::Option*> options;
  for (const Flag& flag : command.flags) {
    const std::string key = key_of(flag), names(flag.name);
    CLI::Option* const option =
        flag.value.empty() ? app.add_flag(names) : app.add_option(names, values[key]);
    if (!flag.value.empty()) option->allow_extra_args(false);
    if (flag.repeatable) option->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
    options[key] = option;
  }
  std::vector<std::string> words;
  app.add_option("words", words);
  const auto fix = ": see 'mansard help " + std::string(command.name) + "'";
  try {
    app.parse(argc, argv);
  } catch (const CLI::ExtrasError&) {
    const auto rest = app.remaining();
    const std::string word = rest.empty() ? "" : rest.front();
    throw UsageError("unknown flag '" + word + "'" + nearest_flag(command, word) + fix);
  } catch (const CLI::ArgumentMismatch& error) {
    const std::string said = error.what();
    throw UsageError("'" + said.substr(0, said.find(':')) + "' takes a value" + fix);
  } catch (const CLI::ParseError& error) {
    throw UsageError(std::string(error.what()) + fix);
  }
  for (const auto& [key, option] : options) {
    if (option->count() > 0) result.values_[key] = values[key];
  }
  result.positional_ = std::move(words);
  const std::size_t given = result.positional_.size();
  if (given < command.least || given > command.most) {
    if (std::string help = torn_list(command, argc, argv); !help.empty()) throw UsageError(help);
    throw UsageError("write: mansard " + std::string(command.name) + " " +
                     std::string(command.usage));
  }
  return result;
}

std::optional<std::string> Arguments::value(std::string_view flag) const {
  const auto& all = values(flag);
  return all.empty() ? std::nullopt : std::optional(all.back());
}

const std::vector<std::string>& Arguments::values(std::string_view flag) const {
  static const std::vector<std::string> nothing;
  const auto it = values_.find(flag);
  return it == values_.end() ? nothing : it->second;
}

std::string Arguments::text(std::string_view flag, std::string_view fallback) const {
  return value(flag).value_or(std::string(fallback));
}

long long Arguments::number(std::string_view flag, long long fallback, long long low,
                            long long high) const {
  const auto text = value(flag);
  if (!text) return fallback;
  long long result = 0;
  const auto [end, error] = std::from_chars(text->data(), text->data() + text->size(), result);
  if (error != std::errc() || end != text->data() + text->size() || result < low || result > high) {
    throw UsageError(std::string(flag) + " takes a whole number from " + std::to_string(low) +
                     " to " + std::to_string(high) + ", not '" + *text + "'");
  }
  return result;
}

}  // namespace mansard
