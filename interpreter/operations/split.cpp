// subdiv, repeat and split (Müller et al. 2006 §3.2).
#include <algorithm>
#include <cmath>

#include "geometry/clip.hpp"
#include "interpreter/component.hpp"
#include "interpreter/messages.hpp"
#include "interpreter/operations/functions.hpp"
#include "interpreter/operations/snapping.hpp"
#include "interpreter/pattern.hpp"
#include "interpreter/read_sizes.hpp"
#include "interpreter/slice.hpp"

namespace mansard {
namespace {

constexpr double touch = 1e-9;  ///< metres; less is no part

/// Along what a split runs: an axis of the scope, or a direction in the face's plane.
struct Direction {
  Axis axis = Axis::x;
  bool snaps = false;
  bool diagonal = false;
  Vec2 along;       ///< unit, diagonal only
  double from = 0;  ///< where the shape begins along the diagonal
  double whole = 0;
  Polygon outline;  ///< diagonal only

  std::optional<Axis> named() const { return diagonal ? std::nullopt : std::optional(axis); }
};

Direction direction_of(Context& c, const Value& axis) {
  Direction d;
  if (axis.type == Type::number) {
    d.diagonal = true;
    if (!is_angle(axis.number)) c.fail(0, wrong_angle(axis.number), "0 runs along the face, 90 up");
    const double angle = axis.number * 3.14159265358979323846 / 180;
    d.along = {std::cos(angle), std::sin(angle)};
    if (c.shape.form != Form::rectangle && c.shape.form != Form::polygon)
      c.fail(0, "only a flat shape can be split along an angle");
    d.outline = plan_of(c.machine, c.shape);
    double low = 1e300, high = -1e300;
    for (const Vec2 p : d.outline.points) {
      low = std::min(low, dot(p, d.along));
      high = std::max(high, dot(p, d.along));
    }
    d.from = low;
    d.whole = high - low;
    return d;
  }
  if (axis.type != Type::string) c.wrong_type(0, axis, "\"X\", \"Y\", \"Z\" or an angle");
  const auto named = axis_named(axis.string());
  if (!named) c.fail(0, wrong_axis(axis.string()), axis_help(axis.string()));
  d.axis = *named;
  d.snaps = axis.size == 2;
  const char letter = "XYZ"[static_cast<int>(d.axis)];
  d.whole = along(c.shape.scope.size, d.axis);
  if (d.whole < touch) {
    c.fail(
        0,
        "a shape of " + size_text(c.shape.scope.size) + " has no extent along " + letter +
            " to split",
        letter == 'Z' ? "a face lies in X and Y: its depth is 0" : "split it along another axis");
  }
  return d;
}

void mark(Shape& piece, const Direction& d, std::size_t i, std::size_t n, std::size_t round) {
  mark_part(piece, d.named(), i, n, round);
}

template <class F>
void cut_slice(Context& c, const Direction& d, const Stretch& stretch, F f) {
  if (!d.diagonal) return for_each_slice(c.machine, c.shape, d.axis, stretch, f);
  for (const Polygon& upto : clip(d.outline, d.along, d.from + stretch.high)) {
    for (Polygon& part : clip(upto, d.along * -1, -(d.from + stretch.low))) {
      Shape piece = c.shape;
      piece.form = Form::polygon;
      c.machine.adopt(piece, std::move(part));
      f(piece);
    }
  }
}

void report_leftover(Context& c, double left, double whole) {
  if (left > 1e-6 * std::max(1.0, whole)) {
    c.machine.warn(
        "W013", c.call.args_at,
        "the sizes leave " + number_text(left) + " m of " + number_text(whole) + " m empty",
        "end with a share: 1r");
  }
}

void count_cut(Context& c) {
  Building& building = *c.machine.building;
  ++building.parts_cut;
  c.machine.reads |= read_bits::aloud;
  const auto known = std::ranges::find(building.cuts, c.call.args_at, &CutSplit::at);
  if (known != building.cuts.end()) {
    ++known->parts;
  } else {
    building.cuts.push_back({c.call.args_at, c.machine.production->syntax->name.text, 1});
  }
}

/// Runs from 0 over the lengths at scratch_sizes[first...]; make(i, stretch) for each part there
/// is.
template <class F>
void lay_out(Context& c, std::size_t first, std::size_t n, double whole, F make) {
  double at = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const double size = c.machine.scratch_sizes[first + i];
    const double high = std::min(at + size, whole);
    if (size > touch && (at > whole - touch || at + size > whole + touch)) count_cut(c);
    // The last part ends exactly where the scope does.
    const double end =
        i + 1 == n && std::abs(whole - high) < 1e-9 * std::max(1.0, whole) ? whole : high;
    const bool whole_size = std::abs(end - at - size) < 1e-9 * std::max(1.0, whole);
    if (end - at > touch) make(i, Stretch{at, end, whole_size ? size : end - at});
    at = high;
  }
}

}  // namespace

namespace operation {

void subdiv(Context& c, Value axis, Sizes, Option<std::string_view> to, Option<double> tolerance) {
  const Direction d = direction_of(c, axis);
  c.count_apart();
  auto& values = c.machine.size_values;
  auto& lengths = c.machine.scratch_sizes;
  const std::size_t first_value = values.size(), first = lengths.size();
  read_sizes(c, d.named());
  const std::span<const SizeValue> sizes = std::span(values).subspan(first_value);
  const std::size_t n = sizes.size();
  report_leftover(c, solve_sizes(sizes, d.whole, lengths), d.whole);
  if (d.snaps) snap_lengths(c, d.axis, first, {to, tolerance});
  note_measures(c, sizes, first, d.named());
  values.resize(first_value);
  lay_out(c, first, n, d.whole, [&](std::size_t i, const Stretch& stretch) {
    cut_slice(c, d, stretch, [&](Shape& piece) {
      mark(piece, d, i, n, 0);
      c.part(i, piece);
    });
  });
  lengths.resize(first);
}

/// Between each line that it snaps to and the next for itself.
void repeat(Context& c, Value axis, double, std::optional<std::string_view> mode,
            Option<std::string_view> to, Option<double> tolerance) {
  const Direction d = direction_of(c, axis);
  c.count_apart();
  const SizeValue size = repeated_size(c, d.named());
  check_repeat(c, size, mode);
  auto& edges = c.machine.scratch_sizes;
  const std::size_t first = edges.size();
  edges.push_back(0);
  if (d.snaps) push_snap_lines(c, d.axis, {to, tolerance});
  edges.push_back(d.whole);
  const std::size_t last = edges.size() - 1;
  double count = 0;
  for (std::size_t k = first; k < last; ++k) count += repeats(edges[k + 1] - edges[k], size, mode);
  check_repeats(c, size, count);
  note_repeat(c, size, d.whole / count, d.named());
  std::size_t i = 0;
  for (std::size_t k = first; k < last; ++k) {
    const double from = edges[k], room = edges[k + 1] - from;
    const double n = repeats(room, size, mode);
    for (double j = 0; j < n; ++j, ++i) {
      const double low = from + room * (j / n);
      const double high = j + 1 == n ? edges[k + 1] : from + room * ((j + 1) / n);
      cut_slice(c, d, {low, high, room / n}, [&](Shape& piece) {
        mark(piece, d, i, static_cast<std::size_t>(count), i);
        c.part(i, piece);
      });
    }
  }
  edges.resize(first);
}

}  // namespace operation

namespace operation {

/// CGA's full pattern: groups repeat round(room / natural length) times and their floats stretch.
void split(Context& c, Value axis, Option<std::string_view> to, Option<double> tolerance) {
  const Direction d = direction_of(c, axis);
  c.count_apart();
  const Pattern pattern = pattern_of(c, d.named(), d.whole);
  auto& lengths = c.machine.scratch_sizes;
  const std::size_t first = lengths.size(), n = pattern.sizes.size();
  report_leftover(c, solve_sizes(pattern.sizes, d.whole, lengths), d.whole);
  if (d.snaps) snap_lengths(c, d.axis, first, {to, tolerance});
  note_measures(c, pattern.sizes, first, d.named());
  lay_out(c, first, n, d.whole, [&](std::size_t i, const Stretch& stretch) {
    cut_slice(c, d, stretch, [&](Shape& piece) {
      mark(piece, d, i, n, pattern.rounds[i]);
      c.go_on(*pattern.parts[i], i, piece);
    });
  });
  lengths.resize(first);
}

}  // namespace operation

namespace {

double fixed_length(Machine& machine, const SizeExpr& size, const Env& env, double whole) {
  if (size.kind != syntax::SizeKind::absolute && size.kind != syntax::SizeKind::percent) return 0;
  auto& values = machine.size_values;
  const std::size_t first = values.size();
  read_size(machine, size, env, values);
  double sum = 0;
  for (std::size_t i = first; i < values.size(); ++i) {
    const double value = values[i].value;
    sum += size.kind == syntax::SizeKind::percent ? value / 100 * whole : value;
  }
  values.resize(first);
  return sum;
}

double fixed_length(Machine& machine, const std::vector<CallPart>& parts, const Env& env,
                    double whole) {
  double sum = 0;
  for (const CallPart& part : parts) {
    if (part.group.empty()) sum += fixed_length(machine, part.size, env, whole);
  }
  return sum;
}

/// Metres that the sizes ':' can not do without.
double least_length(Context& c, std::optional<Axis> axis) {
  double sum = 0;
  for (const SizeValue& size : measures_of(c, axis)) sum += size.minimum;
  return sum;
}

}  // namespace

/// No fixed size of the successor's first split would be cut, and no size ':' below its minimum.
bool Machine::fits(uint32_t number, const Env& env) {
  const Call& call = program.calls[number];
  Shape shape = *env.shape;
  Context c(*this, call, shape, env);
  const Value axis = c.value(0);
  const auto named = axis.type == Type::string ? axis_named(axis.string()) : std::nullopt;
  const double whole = named ? along(shape.scope.size, *named) : direction_of(c, axis).whole;
  if (std::isnan(whole)) return true;  // being measured, it gets what it asks for
  double fixed = 0;
  if (!call.parts.empty() && call.parts[0].labelled) {
    fixed = fixed_length(*this, call.parts, env, whole);
  }
  for (std::size_t i = 1; i < call.args.size(); ++i) {
    const std::size_t known = call.operation->parameter_of(i);
    if (call.args[i].value != none && !call.operation->parameters[known].optional) {
      fixed += fixed_length(*this, call.args[i], env, whole);
    }
  }
  if (call.measures) fixed += least_length(c, named);
  return fixed <= whole + touch;
}

}  // namespace mansard
