// stain(rate): how strongly rain stains the walls below.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace mansard {

/// Key among the values given by set(), of which no variable has it. The value is a list: the rate,
/// and the depth of the shape whose rule said it.
inline constexpr uint32_t stain_setting = 0xfffffffe;

constexpr bool is_stain_rate(double rate) { return rate >= 0 && rate <= 1; }
std::string wrong_stain_rate(double rate);
inline constexpr std::string_view stain_rate_help =
    "0 leaves the walls clean, 0.5 is an old house, 1 a sooty one";

}  // namespace mansard
