// Splits that snap to planes: what subdiv, repeat and split share.
#pragma once

#include "interpreter/axes.hpp"
#include "interpreter/machine.hpp"

namespace mansard {

struct SnapOptions {
  std::optional<std::string_view> to;
  std::optional<double> tolerance;
};

/// Moves the boundaries between the parts whose lengths lie at machine.scratch_sizes[first...].
void snap_lengths(Context& c, Axis axis, std::size_t first, const SnapOptions& options);
/// Pushes the lines that divide the shape into intervals onto machine.scratch_sizes, ascending and
/// without its ends.
void push_snap_lines(Context& c, Axis axis, const SnapOptions& options);

}  // namespace mansard
