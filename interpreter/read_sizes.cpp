#include "interpreter/read_sizes.hpp"

#include <cmath>

#include "interpreter/context.hpp"
#include "interpreter/measure.hpp"
#include "interpreter/messages.hpp"
#include "interpreter/slice.hpp"

namespace mansard {
namespace {

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

}  // namespace

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

SizeValue measured_size(Context& c, const SizeExpr& size, const CallPart& part, const Shape& piece,
                        std::optional<Axis> axis) {
  using enum syntax::SizeKind;
  Machine& m = c.machine;
  const Span at = m.program.spans[size.value];
  if (!axis) {
    m.fail(at, "a size ':' is measured along an axis, not along an angle",
           "split it along \"X\", \"Y\" or \"Z\", or give the part a size");
  }
  const NaturalSize natural = m.measurer().part(c, part, piece, *axis, at);
  if (natural.is_known()) return {dont_care, natural.preferred, natural.minimum, natural.maximum};
  if (!m.measuring) {
    m.warn("W028", at,
           std::string("nothing in this part says how long it is along ") + letter_of(*axis) +
               ": ':' is taken for 1r",
           "give it a size, or write 1r");
  }
  return {relative, 1};
}

namespace {

/// Of its first part, like which all others are made.
SizeValue measured_part_of_repeat(Context& c, std::optional<Axis> axis) {
  Shape piece = c.shape;
  mark_part(piece, axis, 0, Shape::none, 0);
  return measured_size(c, c.call.args[1], c.call.parts[0], piece, axis);
}

}  // namespace

void read_sizes(Context& c, std::optional<Axis> axis) {
  auto& values = c.machine.size_values;
  const std::size_t first = values.size();
  for (std::size_t i = c.call.operation->count; i < c.call.args.size(); ++i) {
    read_size(c.machine, c.call.args[i], c.env, values);
  }
  const std::size_t n = values.size() - first, parts = c.call.parts.size();
  if (parts != 1 && parts != n) throw Failure(size_count_error(c.call, n));
  if (!c.call.measures) return;
  const SizeExpr* size = c.call.args.data();  // the axis
  for (std::size_t i = 0; i < n; ++i) {
    if (values[first + i].kind != syntax::SizeKind::dont_care) continue;
    while ((++size)->kind != syntax::SizeKind::dont_care) continue;
    Shape piece = c.shape;
    mark_part(piece, axis, i, n, 0);
    // Measuring may read other sizes and so move the values.
    const SizeValue measured =
        measured_size(c, *size, c.call.parts[parts == 1 ? 0 : i], piece, axis);
    values[first + i] = measured;
  }
}

namespace {

void add_measures(Context& c, const std::vector<CallPart>& parts, std::optional<Axis> axis,
                  std::vector<SizeValue>& out, std::size_t place) {
  for (const CallPart& part : parts) {
    if (!part.group.empty()) add_measures(c, part.group, axis, out, place);
    if (part.group.empty() && part.size.kind == syntax::SizeKind::dont_care) {
      Shape piece = c.shape;
      mark_part(piece, axis, place, Shape::none, 0);
      out.push_back(measured_size(c, part.size, part, piece, axis));
    }
    ++place;
  }
}

}  // namespace

std::vector<SizeValue> measures_of(Context& c, std::optional<Axis> axis) {
  std::vector<SizeValue> found;
  c.look_apart();
  if (c.call.operation->rule == PartRule::pattern) {
    add_measures(c, c.call.parts, axis, found, 0);
    return found;
  }
  if (c.call.operation->rule == PartRule::body) {  // repeat
    found.push_back(measured_part_of_repeat(c, axis));
    return found;
  }
  auto& values = c.machine.size_values;
  const std::size_t first = values.size();
  read_sizes(c, axis);
  for (std::size_t i = first; i < values.size(); ++i) {
    if (values[i].kind == syntax::SizeKind::dont_care) found.push_back(values[i]);
  }
  values.resize(first);
  return found;
}

SizeValue repeated_size(Context& c, std::optional<Axis> axis) {
  if (!c.call.measures) return {syntax::SizeKind::absolute, c.number(1)};
  const SizeValue size = measured_part_of_repeat(c, axis);
  if (size.kind == syntax::SizeKind::dont_care && size.value > 0) return size;
  c.machine.fail(c.machine.program.spans[c.call.args[1].value],
                 "nothing in the part says how long it is, so it can not be repeated by ':'",
                 "give the size to repeat in metres");
}

void check_repeat(Context& c, const SizeValue& size, const std::optional<std::string_view>& mode) {
  if (size.value <= 0)
    c.fail(1, "the size to repeat must be more than 0, it is " + number_text(size.value));
  if (mode && *mode != "nearest" && *mode != "fit" && *mode != "ceil") {
    c.fail(2, "\"" + std::string(*mode) + "\" is no way to repeat",
           "\"nearest\", \"fit\" or \"ceil\"");
  }
}

void check_repeats(Context& c, const SizeValue& size, double count) {
  constexpr double most_parts = 100'000;
  if (count <= most_parts) return;
  c.fail(1, "this makes " + number_text(count) + " parts of " + number_text(size.value) + " m");
}

double repeats(double length, const SizeValue& size, const std::optional<std::string_view>& mode) {
  const double exact = length / size.value;
  double count = std::round(exact);
  if (mode == "fit") count = std::floor(exact + 1e-9);
  if (mode == "ceil") count = std::ceil(exact - 1e-9);
  if (!mode && size.minimum > 0) count = std::min(count, std::floor(length / size.minimum + 1e-9));
  return std::max(1.0, count);
}

namespace {

void note(Context& c, const SizeValue& size, std::size_t part, double got, Axis axis) {
  Machine& m = c.machine;
  m.building->measures.push_back(
      {m.expanding, c.call.at, axis, part, {size.minimum, size.value, size.maximum}, got});
}

bool is_noted(const Context& c) { return c.call.measures && c.machine.keeps_tree; }

}  // namespace

void note_measures(Context& c, std::span<const SizeValue> sizes, std::size_t first,
                   std::optional<Axis> axis) {
  if (!is_noted(c) || !axis) return;
  for (std::size_t i = 0; i < sizes.size(); ++i) {
    if (sizes[i].kind == syntax::SizeKind::dont_care)
      note(c, sizes[i], i, c.machine.scratch_sizes[first + i], *axis);
  }
}

void note_repeat(Context& c, const SizeValue& size, double got, std::optional<Axis> axis) {
  if (is_noted(c) && axis) note(c, size, 0, got, *axis);
}

}  // namespace mansard
