// What expressions can read of a shape and of a building: one row each, for the compiler, help and
// editors.
#pragma once

#include <span>
#include <string_view>

#include "interpreter/program.hpp"

namespace mansard {

struct AttributeRow {
  std::string_view name;  ///< `W`, `split.index`
  Attribute attribute;
  std::string_view summary;  ///< one sentence
};
struct InputRow {
  std::string_view name;
  Input input;
  std::string_view summary;
};

std::span<const AttributeRow> attributes();
const AttributeRow* find_attribute(std::string_view name);
std::span<const InputRow> inputs();
const InputRow* find_input(std::string_view name);

}  // namespace mansard
