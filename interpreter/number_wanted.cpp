#include "interpreter/number_wanted.hpp"

#include "styles/annotations.hpp"

namespace mansard {

bool holds_number(const VariableBinding& variable) {
  return variable.syntax->value && number_literal(*variable.syntax->value);
}

std::string number_help(std::string_view value) {
  constexpr std::string_view digits = "0123456789.";
  const std::size_t end = value.find_first_not_of(digits, value.starts_with('-') ? 1 : 0);
  const std::string number(value.substr(0, end));
  if (number.empty() || number == "-" || end == value.npos) return "write a number: 1.2";
  const std::string_view rest = value.substr(end);
  if (number.find("..") != number.npos || rest[0] == ':' || rest[0] == '-')
    return "a range belongs to mansard vary: --sweep NAME=from:to:step";
  if (rest[0] == ',') return "one number, whose decimals have a point: 1.2";
  const bool is_unit = (rest[0] | 0x20) >= 'a' && (rest[0] | 0x20) <= 'z';
  if (!is_unit && rest[0] != ' ' && static_cast<unsigned char>(rest[0]) < 0x80)
    return "write a number: 1.2";
  return "write " + number + ": lengths are in metres and angles in degrees, without a unit";
}

}  // namespace mansard
