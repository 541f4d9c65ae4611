// subdiv, repeat and split (Müller et al. 2006 §3.2).
#include <algorithm>
#include <cmath>

#include "geometry/clip.hpp"
#include "interpreter/component.hpp"
#include "interpreter/messages.hpp"
#include "interpreter/operations/functions.hpp"
#include "interpreter/operations/snapping.hpp"
#include "interpreter/slice.hpp"

namespace mansard {
namespace {

constexpr double touch = 1e-9;  ///< metres; less is no part
constexpr std::size_t most_parts = 100'000;

/// Along what a split runs: an axis of the scope, or a direction in the face's plane.
struct Direction {
  Axis axis = Axis::x;
  bool snaps = false;
  bool diagonal = false;
  Vec2 along;       ///< unit, diagonal only
  double from = 0;  ///< where the shape begins along the diagonal
  double whole = 0;
  Polygon outline;  ///< diagonal only
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
  piece.split_index = static_cast<uint32_t>(i);
  piece.split_count = static_cast<uint32_t>(n);
  piece.split_round = static_cast<uint32_t>(round);
  if (!d.diagonal && d.axis == Axis::y) piece.level = static_cast<uint32_t>(i);
}

template <class F>
void cut_slice(Context& c, const Direction& d, double low, double high, F f) {
  if (!d.diagonal) return for_each_slice(c.machine, c.shape, d.axis, low, high, f);
  for (const Polygon& upto : clip(d.outline, d.along, d.from + high)) {
    for (Polygon& part : clip(upto, d.along * -1, -(d.from + low))) {
      Shape piece = c.shape;
      piece.form = Form::polygon;
      c.machine.adopt(piece, std::move(part));
      f(piece);
    }
  }
}

/// What is wrong with the value of a size, if anything.
void check_size(Machine& machine, ExprId at, const Value& v) {
  if (v.type != Type::number) {
    machine.fail(machine.program.spans[at],
                 "a size is a number or a list of numbers, not " + std::string(described(v.type)));
  }
  if (!std::isfinite(v.number))
    machine.fail(machine.program.spans[at], "this size is not a finite number");
  if (v.number < 0) {
    Diagnostic d;
    d.at = machine.program.spans[at];
    const std::string number = number_text(v.number);
    d.text = "a size can not be negative: " +
             (d.at.text() == number ? number : "'" + std::string(d.at.text()) + "' is " + number);
    note_writer(d, "it", machine.program.origin(v));
    d.help = "max(0, ...) keeps it from falling below 0";
    throw Failure(std::move(d));
  }
}

void read_size(Machine& machine, const SizeExpr& size, const Env& env,
               std::vector<SizeValue>& out) {
  const Value v = machine.evaluate(size.value, env);
  if (v.type == Type::list) {
    for (const Value& item : v.list()) {
      check_size(machine, size.value, item);
      out.push_back({size.kind, item.number});
    }
    return;
  }
  check_size(machine, size.value, v);
  out.push_back({size.kind, v.number});
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
  const auto known = std::ranges::find(building.cuts, c.call.args_at, &CutSplit::at);
  if (known != building.cuts.end()) {
    ++known->parts;
  } else {
    building.cuts.push_back({c.call.args_at, c.machine.production->syntax->name.text, 1});
  }
}

/// Runs from 0 over the lengths at scratch_sizes[first...]; make(i, low, high) for each part there
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
    if (end - at > touch) make(i, at, end);
    at = high;
  }
}

/// How many parts of about `size` a length is divided into: one at least.
double times(double length, double size, const std::optional<std::string_view>& mode) {
  const double exact = length / size;
  if (!mode || *mode == "nearest") return std::max(1.0, std::round(exact));
  return std::max(1.0, *mode == "fit" ? std::floor(exact + 1e-9) : std::ceil(exact - 1e-9));
}

}  // namespace

namespace operation {

void subdiv(Context& c, Value axis, Sizes sizes, Option<std::string_view> to,
            Option<double> tolerance) {
  const Direction d = direction_of(c, axis);
  auto& values = c.machine.size_values;
  values.clear();
  for (std::size_t i = sizes.first; i < c.call.args.size(); ++i) {
    read_size(c.machine, c.call.args[i], c.env, values);
  }
  const std::size_t n = values.size();
  if (c.call.parts.size() != 1 && c.call.parts.size() != n) {
    throw Failure(size_count_error(c.call, n));
  }
  auto& lengths = c.machine.scratch_sizes;
  const std::size_t first = lengths.size();
  report_leftover(c, solve_sizes(values, d.whole, lengths), d.whole);
  if (d.snaps) snap_lengths(c, d.axis, first, {to, tolerance});
  lay_out(c, first, n, d.whole, [&](std::size_t i, double low, double high) {
    cut_slice(c, d, low, high, [&](Shape& piece) {
      mark(piece, d, i, n, 0);
      c.part(i, piece);
    });
  });
  lengths.resize(first);
}

/// Between each line that it snaps to and the next for itself.
void repeat(Context& c, Value axis, double size, std::optional<std::string_view> mode,
            Option<std::string_view> to, Option<double> tolerance) {
  const Direction d = direction_of(c, axis);
  if (size <= 0) c.fail(1, "the size to repeat must be more than 0, it is " + number_text(size));
  if (mode && *mode != "nearest" && *mode != "fit" && *mode != "ceil") {
    c.fail(2, "\"" + std::string(*mode) + "\" is no way to repeat",
           "\"nearest\", \"fit\" or \"ceil\"");
  }
  auto& edges = c.machine.scratch_sizes;
  const std::size_t first = edges.size();
  edges.push_back(0);
  if (d.snaps) push_snap_lines(c, d.axis, {to, tolerance});
  edges.push_back(d.whole);
  const std::size_t last = edges.size() - 1;
  double count = 0;
  for (std::size_t k = first; k < last; ++k) count += times(edges[k + 1] - edges[k], size, mode);
  if (count > most_parts) {
    c.fail(1, "this makes " + number_text(count) + " parts of " + number_text(size) + " m");
  }
  std::size_t i = 0;
  for (std::size_t k = first; k < last; ++k) {
    const double from = edges[k], room = edges[k + 1] - from;
    const double n = times(room, size, mode);
    for (double j = 0; j < n; ++j, ++i) {
      const double low = from + room * (j / n);
      const double high = j + 1 == n ? edges[k + 1] : from + room * ((j + 1) / n);
      cut_slice(c, d, low, high, [&](Shape& piece) {
        mark(piece, d, i, static_cast<std::size_t>(count), i);
        c.part(i, piece);
      });
    }
  }
  edges.resize(first);
}

}  // namespace operation

namespace {

/// A pattern laid out: its parts one after the other, with the round of their group.
struct Pattern {
  std::vector<SizeValue> sizes;
  std::vector<const CallPart*> parts;
  std::vector<std::size_t> rounds;

  void add(const CallPart& part, SizeValue size, std::size_t round) {
    sizes.push_back(size);
    parts.push_back(&part);
    rounds.push_back(round);
  }
};

SizeValue label_size(Context& c, const CallPart& part) {
  std::vector<SizeValue> values;
  read_size(c.machine, part.size, c.env, values);
  if (values.size() != 1) c.machine.fail(part.at, "a part of 'split' has one size");
  return values[0];
}

/// Metres that a list of parts wants: fixed sizes and floats, groups once.
double natural_length(Context& c, const std::vector<CallPart>& parts, double whole) {
  double sum = 0;
  for (const CallPart& part : parts) {
    if (!part.group.empty()) {
      sum += natural_length(c, part.group, whole);
      continue;
    }
    const SizeValue v = label_size(c, part);
    if (v.kind == syntax::SizeKind::percent) sum += v.value / 100 * whole;
    if (v.kind == syntax::SizeKind::absolute || v.kind == syntax::SizeKind::floating)
      sum += v.value;
  }
  return sum;
}

/// Lays parts out in `room` metres; the groups among them share what the others leave.
void unroll(Context& c, const std::vector<CallPart>& parts, double room, std::size_t round,
            Pattern& out) {
  double single = 0, grouped = 0;
  for (const CallPart& part : parts) {
    if (part.group.empty()) {
      const SizeValue v = label_size(c, part);
      if (v.kind == syntax::SizeKind::percent) single += v.value / 100 * room;
      if (v.kind == syntax::SizeKind::absolute || v.kind == syntax::SizeKind::floating)
        single += v.value;
    } else {
      grouped += natural_length(c, part.group, room);
    }
  }
  for (const CallPart& part : parts) {
    if (part.group.empty()) {
      out.add(part, label_size(c, part), round);
      continue;
    }
    if (grouped <= 0) c.machine.fail(part.at, "a repeated group needs a size that is not a share");
    const double times = std::max(0.0, std::round((room - single) / grouped));
    if (times > most_parts)
      c.machine.fail(part.at, "this repeats " + number_text(times) + " times");
    for (std::size_t i = 0; i < static_cast<std::size_t>(times); ++i) {
      unroll(c, part.group, natural_length(c, part.group, room), i, out);
    }
  }
}

}  // namespace

namespace operation {

/// CGA's full pattern: groups repeat round(room / natural length) times and their floats stretch.
void split(Context& c, Value axis, Option<std::string_view> to, Option<double> tolerance) {
  const Direction d = direction_of(c, axis);
  Pattern pattern;
  if (c.call.starred) {
    const double natural = natural_length(c, c.call.parts, d.whole);
    if (natural <= 0)
      c.machine.fail(c.call.parts_at, "a repeated split needs a size that is not a share");
    const double times = std::max(1.0, std::round(d.whole / natural));
    if (times > most_parts)
      c.machine.fail(c.call.parts_at, "this repeats " + number_text(times) + " times");
    for (std::size_t i = 0; i < static_cast<std::size_t>(times); ++i) {
      unroll(c, c.call.parts, natural, i, pattern);
    }
  } else {
    unroll(c, c.call.parts, d.whole, 0, pattern);
  }
  auto& lengths = c.machine.scratch_sizes;
  const std::size_t first = lengths.size(), n = pattern.sizes.size();
  report_leftover(c, solve_sizes(pattern.sizes, d.whole, lengths), d.whole);
  if (d.snaps) snap_lengths(c, d.axis, first, {to, tolerance});
  lay_out(c, first, n, d.whole, [&](std::size_t i, double low, double high) {
    cut_slice(c, d, low, high, [&](Shape& piece) {
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
  std::vector<SizeValue>& values = machine.size_values;
  values.clear();
  read_size(machine, size, env, values);
  double sum = 0;
  for (const SizeValue& v : values) {
    sum += size.kind == syntax::SizeKind::percent ? v.value / 100 * whole : v.value;
  }
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

}  // namespace

/// No fixed size of the successor's first split would be cut.
bool Machine::fits(uint32_t number, const Env& env) {
  const Call& call = program.calls[number];
  Shape shape = *env.shape;
  Context c(*this, call, shape, env);
  const Value axis = c.value(0);
  const auto named = axis.type == Type::string ? axis_named(axis.string()) : std::nullopt;
  const double whole = named ? along(shape.scope.size, *named) : direction_of(c, axis).whole;
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
  return fixed <= whole + touch;
}

}  // namespace mansard
