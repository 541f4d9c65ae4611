// What every argument and every part of an operation is: unit, default and range in a few words.
// Names and types are in the operation table; a test compares the two.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "interpreter/operation.hpp"

namespace mansard {

/// A name of several operations that means the same in all has one row, with "*" for the operation.
struct ArgumentRow {
  std::string_view operation, name, summary;
};

std::span<const ArgumentRow> argument_rows();
std::span<const ArgumentRow> part_rows();
/// Empty when there is no row.
std::string_view argument_summary(const Operation& operation, std::string_view name);
std::string_view part_summary(const Operation& operation, std::string_view name);

}  // namespace mansard
