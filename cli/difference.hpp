// What changed between two texts, as `diff -u` and `git apply` write it.
#pragma once

#include <string>
#include <string_view>

namespace mansard {

/// A unified diff with three lines of context; empty when the texts are the same. The fewest lines
/// change that can; only texts that differ over many thousands of lines are replaced whole.
std::string difference(std::string_view name, std::string_view before, std::string_view after);

}  // namespace mansard
