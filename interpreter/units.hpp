// Reading lengths and numbers out of property texts.
#pragma once

#include <optional>
#include <string_view>

namespace mansard {

/// "12.5", "12.5 m", "12,5", "40'", "40 ft", "5'10\"", "3 km" as metres (a bare number as it is);
/// nothing for other text or what is not finite.
std::optional<double> read_number(std::string_view text);

}  // namespace mansard
