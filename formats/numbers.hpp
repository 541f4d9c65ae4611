// Numbers as text, for formats that are mostly numbers.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>

namespace mansard {

static_assert(std::endian::native == std::endian::little);

/// Longest text of put_number and put_integer.
inline constexpr std::size_t number_length = 32;

/// A number below 1000 as text with all its zeros.
struct ThreeDigits {
  char text[3];
  uint8_t zeros_before : 4, zeros_behind : 4;  ///< 2 before and 3 behind for 0
};

inline constexpr auto three_digits = [] {
  std::array<ThreeDigits, 1000> all{};
  for (int i = 0; i < 1000; ++i) {
    const auto letter = [](int digit) { return static_cast<char>('0' + digit); };
    all[i] = {{letter(i / 100), letter(i / 10 % 10), letter(i % 10)}, 0, 0};
    all[i].zeros_before = i < 10 ? 2 : i < 100 ? 1 : 0;
    all[i].zeros_behind = i == 0 ? 3 : i % 100 == 0 ? 2 : i % 10 == 0 ? 1 : 0;
  }
  return all;
}();

/// `to` needs number_length bytes of room.
inline char* put_integer(char* to, uint64_t value) {
  if (value >= 1'000'000) return std::to_chars(to, to + number_length, value).ptr;
  if (value >= 1000) {
    to = put_integer(to, value / 1000);
    std::memcpy(to, three_digits[value % 1000].text, 3);
    return to + 3;
  }
  const ThreeDigits& digits = three_digits[value];
  uint32_t text;
  std::memcpy(&text, &digits, sizeof text);
  text >>= 8 * digits.zeros_before;
  std::memcpy(to, &text, sizeof text);
  return to + 3 - digits.zeros_before;
}

/// A number as text, for numbers that mostly come one after the other.
class CountedText {
 public:
  void set(uint64_t value) {
    if (value == value_) return;
    value_ = value;
    char text[number_length] = {};
    const std::ptrdiff_t length = put_integer(text, value) - text;
    before_length_ = std::max<std::ptrdiff_t>(length - counted, 0);
    length_ = length - before_length_;
    std::memcpy(before_, text, sizeof before_);
    std::memcpy(&text_, text + before_length_, sizeof text_);
  }
  void next() {
    const auto last = 8 * (length_ - 1);
    if ((text_ >> last & 0xff) == '9') return set(value_ + 1);
    ++value_;
    text_ += uint64_t(1) << last;
  }
  /// `to` needs number_length bytes of room.
  char* put(char* to) const {
    std::memcpy(to, before_, sizeof before_);
    std::memcpy(to + before_length_, &text_, sizeof text_);
    return to + before_length_ + length_;
  }

 private:
  static constexpr std::ptrdiff_t counted = 8;  ///< digits that change
  char before_[12] = {};                        ///< the digits before those
  std::ptrdiff_t before_length_ = 0, length_ = 1;
  uint64_t value_ = 0, text_ = '0';
};

/// The four digits of n < 10^4 without zeros at the end.
inline char* put_last_digits(char* to, uint32_t n) {
  const ThreeDigits &first = three_digits[n / 100], &last = three_digits[n % 100];
  std::memcpy(to, first.text + 1, 2);
  std::memcpy(to + 2, last.text + 1, 2);
  return to + 4 - (n % 100 == 0 ? 2 + first.zeros_behind : last.zeros_behind);
}

/// To the nearest tenth of a micrometre, without zeros at the end: 12.5, 0.3333333, -7, never -0.
/// Many times faster than to_chars of a double, which looks for the shortest exact digits; most
/// lengths have three digits or fewer on either side of the point.
inline char* put_number(char* to, double value) {
  constexpr int64_t unit = 10'000'000;
  const double scaled = value * unit;
  if (!(std::abs(scaled) < 9e15)) return std::to_chars(to, to + number_length, value).ptr;
  const auto n = static_cast<int64_t>(scaled + std::copysign(0.5, scaled));
  *to = '-';
  to += n < 0;
  const auto rounded = static_cast<uint64_t>(std::abs(n));
  to = put_integer(to, rounded / unit);
  const auto fraction = static_cast<uint32_t>(rounded % unit);
  if (fraction == 0) return to;
  const ThreeDigits& first = three_digits[fraction / 10'000];
  *to = '.';
  std::memcpy(to + 1, first.text, 3);
  if (fraction % 10'000 != 0) return put_last_digits(to + 4, fraction % 10'000);
  return to + 4 - first.zeros_behind;
}

}  // namespace mansard
