#include "interpreter/units.hpp"

#include <charconv>
#include <cmath>
#include <string>

namespace mansard {
namespace {

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && (text.front() == ' ' || text.front() == '\t')) text.remove_prefix(1);
  while (!text.empty() && (text.back() == ' ' || text.back() == '\t')) text.remove_suffix(1);
  return text;
}

std::optional<double> metres_per(std::string_view unit) {
  if (unit.empty() || unit == "m" || unit == "metre" || unit == "metres" || unit == "meters")
    return 1;
  if (unit == "ft" || unit == "feet" || unit == "foot" || unit == "'") return 0.3048;
  if (unit == "in" || unit == "\"") return 0.0254;
  if (unit == "cm") return 0.01;
  if (unit == "km") return 1000;
  return std::nullopt;
}

/// Takes a number off the front of text.
std::optional<double> leading_number(std::string_view& text) {
  std::string digits(text.substr(0, text.find_first_not_of("+-0123456789.,eE")));
  if (const auto comma = digits.find(','); comma != std::string::npos) digits[comma] = '.';
  const char* const begin = digits.data() + (digits.starts_with('+') ? 1 : 0);
  double value = 0;
  const auto [end, error] = std::from_chars(begin, digits.data() + digits.size(), value);
  if (error != std::errc() || !std::isfinite(value)) return std::nullopt;
  text.remove_prefix(static_cast<std::size_t>(end - digits.data()));
  text = trimmed(text);
  return value;
}

}  // namespace

std::optional<double> read_number(std::string_view text) {
  text = trimmed(text);
  const auto first = leading_number(text);
  if (!first) return std::nullopt;
  if (text.starts_with('\'') && text.size() > 1) {  // 5'10"
    text = trimmed(text.substr(1));
    const auto inches = leading_number(text);
    if (!inches || text != "\"") return std::nullopt;
    return *first * 0.3048 + *inches * 0.0254;
  }
  const auto unit = metres_per(text);
  return unit ? std::optional(*first * *unit) : std::nullopt;
}

}  // namespace mansard
