// The names that scripts read but can not declare.
#pragma once

#include <span>
#include <string_view>

namespace mansard {

/// Objects (`Shape`, `split`), attributes of the shape (`W`, `area`) and inputs of the building.
std::span<const std::string_view> reserved_names();

/// One of those, or a keyword of the grammar.
bool is_reserved(std::string_view name);

}  // namespace mansard
