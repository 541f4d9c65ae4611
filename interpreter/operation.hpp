// The operation table: one row an operation, from which come the checker, the evaluator, the help,
// docs/operations.md and the tests that derive every example.
#pragma once

#include <array>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "interpreter/signature.hpp"

namespace mansard {

class Context;

enum class PartRule : uint8_t {
  without,  ///< takes no parts
  body,   ///< at most one part, whose shape is what the operation makes; without it the shape goes
          ///< on
  named,  ///< the parts of `parts`, in that order or by name
  sizes,  ///< one part for each size
  pattern,    ///< parts labelled with sizes, groups repeat
  selectors,  ///< parts labelled with selectors
  choices,    ///< any number of parts, of which one is taken
};

inline constexpr std::size_t most_part_names = 13;  ///< of PartRule::named

struct Operation {
  std::string_view name;
  std::string_view group;  ///< heading in help
  std::string_view args;   ///< names of the parameters
  PartRule rule = PartRule::without;
  std::string_view parts;    ///< "inside | border" for PartRule::named
  std::string_view summary;  ///< one sentence
  std::string_view example;  ///< successor that runs on a 10 x 8 footprint (symbol FOOTPRINT) or
                             ///< says which shape it starts from
  void (*invoke)(Context&) = nullptr;
  std::array<Parameter, max_parameters> parameters{};
  uint8_t count = 0, required = 0;
  bool variadic = false;  ///< parameter `rest` takes the arguments that the others leave
  uint8_t rest = 0;
  bool is_split = false;
  bool waits = false;  ///< its rule waits for a round

  std::string_view parameter_name(std::size_t i) const { return name_of(args, i); }
  /// The parameter that the argument number `slot` of a Call is for.
  std::size_t parameter_of(std::size_t slot) const { return slot < count ? slot : rest; }
  bool may_be_left_out(std::size_t i) const {
    return parameters[i].optional && !(variadic && i == rest);
  }
  /// How many arguments may be given without their names, and the parameter of the i-th of them.
  std::size_t places() const;
  std::size_t parameter_at(std::size_t place) const;
  /// The number of the parameter of this name; `count` if there is none.
  std::size_t find_parameter(std::string_view word) const;
  /// "axis, size": the names of those that are given by place.
  std::string names_by_place() const;
};

std::span<const Operation> operations();
const Operation* find_operation(std::string_view name);
/// Names that a later version brings: refused with a message that says so.
bool is_later_operation(std::string_view name);

/// How many parts "inside | border" names, and the name of part i.
constexpr std::size_t parts_in(std::string_view parts) {
  if (parts.empty()) return 0;
  std::size_t n = 1;
  for (const char c : parts) n += c == '|';
  return n;
}
constexpr std::string_view part_name(std::string_view parts, std::size_t i) {
  for (; i > 0; --i) parts.remove_prefix(parts.find('|') + 1);
  parts = parts.substr(0, parts.find('|'));
  while (!parts.empty() && parts.front() == ' ') parts.remove_prefix(1);
  while (!parts.empty() && parts.back() == ' ') parts.remove_suffix(1);
  return parts;
}

}  // namespace mansard
