// snap, and the splits that go to its planes (Müller et al. 2006 §3.3).
#include <algorithm>

#include "interpreter/messages.hpp"
#include "interpreter/operations/functions.hpp"
#include "interpreter/operations/snapping.hpp"

namespace mansard {

namespace operation {

void snap(Context& c, std::string_view planes, std::optional<std::string_view> label) {
  const auto normals = normals_named(planes);
  if (!normals) c.fail(0, wrong_planes(planes), std::string(planes_help));
  if (!c.machine.program.snaps) return;  // nobody looks
  const uint64_t name = label ? hash_of(*label) : 0;
  c.machine.planes.record(c.shape.scope, *normals, name, c.machine.expanding);
}

}  // namespace operation

namespace {

double tolerance_of(Context& c, const SnapOptions& options) {
  if (options.tolerance && !is_tolerance(*options.tolerance)) {
    c.fail(c.call.operation->find_parameter("tolerance"), wrong_tolerance(*options.tolerance));
  }
  return options.tolerance.value_or(usual_tolerance);
}

/// For what is told at the end: which splits found nothing to snap to.
void count_split(Context& c, std::optional<uint64_t> to, std::size_t planes) {
  auto& splits = c.machine.building->snap_splits;
  const Span at = c.at(0);
  auto known = std::ranges::find(splits, at, &SnapSplit::at);
  if (known == splits.end()) {
    splits.push_back({at, c.machine.production->syntax->name.text, to});
    known = splits.end() - 1;
  }
  ++known->shapes;
  known->with_planes += planes > 0;
  known->with_lines += !c.machine.snap_lines.empty();
}

/// Into machine.snap_lines.
void find_lines(Context& c, Axis axis, const SnapOptions& options) {
  Machine& machine = c.machine;
  if (!machine.has_waited()) {
    const auto symbol = std::string(machine.production->syntax->name.text);
    c.fail(0, "this axis snaps, and '" + symbol + "' did not wait for planes to snap to",
           "the script has to say that it may: if attr(\"axis\", \"X\") == \"X\" then \"X\" else "
           "\"XS\"");
  }
  const auto to = options.to ? std::optional(hash_of(*options.to)) : std::nullopt;
  const std::size_t planes = machine.planes.lines(machine, c.shape, axis, to, machine.snap_lines);
  count_split(c, to, planes);
}

/// What `mansard tree --rounds` shows. A line at an end has a boundary anyway.
void note_lines(const Context& c, double whole) {
  Machine& machine = c.machine;
  if (!machine.keeps_tree || machine.building->rounds.empty()) return;
  Snapping now{
      machine.expanding, std::string(c.call.at.text()) + std::string(c.call.args_at.text()), {}};
  for (const SnapLine& line : machine.snap_lines) {
    const uint32_t symbol = machine.building->tree[line.by].shape.symbol;
    const bool at_end = line.at < same_line || line.at > whole - same_line;
    now.lines.push_back({line.at, line.used || at_end,
                         std::string(line.face ? "a face of " : "snap in ") +
                             std::string(machine.program.symbols[symbol]) + " (node " +
                             std::to_string(line.by) + ")"});
  }
  machine.building->rounds.back().snappings.push_back(std::move(now));
}

}  // namespace

void snap_lengths(Context& c, Axis axis, std::size_t first, const SnapOptions& options) {
  const double tolerance = tolerance_of(c, options);
  const double whole = along(c.shape.scope.size, axis);
  find_lines(c, axis, options);
  pull(std::span(c.machine.scratch_sizes).subspan(first), whole, c.machine.snap_lines, tolerance);
  note_lines(c, whole);
}

void push_snap_lines(Context& c, Axis axis, const SnapOptions& options) {
  const double tolerance = tolerance_of(c, options);
  const double whole = along(c.shape.scope.size, axis);
  find_lines(c, axis, options);
  keep_apart(c.machine.snap_lines, whole, tolerance);
  for (const SnapLine& line : c.machine.snap_lines) {
    if (line.used) c.machine.scratch_sizes.push_back(line.at);
  }
  note_lines(c, whole);
}

}  // namespace mansard
