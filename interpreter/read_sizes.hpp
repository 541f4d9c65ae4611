// The sizes of a split, as its rule wrote them.
#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "interpreter/axes.hpp"
#include "interpreter/machine.hpp"

namespace mansard {

/// Evaluates a size and appends it; a list gives several. A size ':' comes out as 0 metres, to be
/// measured. Throws Failure for what is no size.
void read_size(Machine& machine, const SizeExpr& size, const Env& env, std::vector<SizeValue>& out);

/// Appends the sizes of subdiv() to machine.size_values, measured. Throws Failure where there are
/// not as many as parts.
void read_sizes(Context& c, std::optional<Axis> axis);

/// Of subdiv, repeat and split: its sizes ':' alone, each group's once.
std::vector<SizeValue> measures_of(Context& c, std::optional<Axis> axis);

/// The size of repeat(), measured. Throws Failure where nothing says how long the part is.
SizeValue repeated_size(Context& c, std::optional<Axis> axis);

/// What is wrong with them, if anything: throws Failure.
void check_repeat(Context& c, const SizeValue& size, const std::optional<std::string_view>& mode);
void check_repeats(Context& c, const SizeValue& size, double count);

/// How many parts repeat() makes of a length, at least one; by a size ':' no more than have their
/// minimum, unless the mode is given.
double repeats(double length, const SizeValue& size, const std::optional<std::string_view>& mode);

/// For the tree: what came of the sizes ':', the lengths of all being scratch_sizes from `first`.
void note_measures(Context& c, std::span<const SizeValue> sizes, std::size_t first,
                   std::optional<Axis> axis);

void note_repeat(Context& c, const SizeValue& size, double got, std::optional<Axis> axis);

/// The size ':' of a part: how long what is derived from it is by itself, and 1r where nothing says
/// so (W028). `piece` is the shape that is split, with split_index and its like as the part will
/// have them. Without an axis, along a diagonal, it throws Failure.
SizeValue measured_size(Context& c, const SizeExpr& size, const CallPart& part, const Shape& piece,
                        std::optional<Axis> axis);

}  // namespace mansard
