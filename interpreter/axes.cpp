#include "interpreter/axes.hpp"

#include <algorithm>

namespace mansard {
namespace {

char capital(char c) { return static_cast<char>(c & ~0x20); }
bool is_axis(char letter) { return letter >= 'X' && letter <= 'Z'; }

/// "XZ" as the bit of y; 0 when it is no plane.
Normals normal_of(std::string_view word) {
  if (word.size() != 2) return 0;
  const char a = capital(word[0]), b = capital(word[1]);
  if (!is_axis(a) || !is_axis(b) || a == b) return 0;
  return static_cast<Normals>(7 & ~(1 << (a - 'X')) & ~(1 << (b - 'X')));
}

}  // namespace

std::optional<Axis> axis_named(std::string_view word) {
  if (word.size() != 1 && !is_snapping_axis(word)) return std::nullopt;
  const char letter = capital(word[0]);
  return is_axis(letter) ? std::optional(static_cast<Axis>(letter - 'X')) : std::nullopt;
}

bool is_snapping_axis(std::string_view word) {
  return word.size() == 2 && is_axis(capital(word[0])) && capital(word[1]) == 'S';
}

std::string wrong_axis(std::string_view word) {
  return "\"" + std::string(word) + "\" is not an axis";
}

std::string axis_help(std::string_view word) {
  if (word.find_first_of("sS") != word.npos)
    return "write \"XS\", \"YS\" or \"ZS\" to snap; an axis at an angle can not";
  return "write \"X\", \"Y\", \"Z\" or an angle";
}

std::optional<Normals> normals_named(std::string_view planes) {
  Normals all = 0;
  while (!planes.empty()) {
    const std::size_t end = std::min(planes.find_first_of(" ,"), planes.size());
    const Normals normal = normal_of(planes.substr(0, end));
    if (end > 0 && normal == 0) return std::nullopt;
    all |= normal;
    planes.remove_prefix(std::min(end + 1, planes.size()));
  }
  return all == 0 ? std::nullopt : std::optional(all);
}

std::string wrong_planes(std::string_view planes) {
  return "\"" + std::string(planes) + "\" names no plane";
}

}  // namespace mansard
