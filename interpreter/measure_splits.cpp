// Splits along what is measured add up; across it the longest part counts.
#include <cmath>

#include "interpreter/context.hpp"
#include "interpreter/measure.hpp"
#include "interpreter/messages.hpp"
#include "interpreter/pattern.hpp"
#include "interpreter/read_sizes.hpp"
#include "interpreter/slice.hpp"

namespace mansard {
namespace {

constexpr double touch = 1e-9;  ///< metres; less is no part

Vec3 unit(Axis axis) {
  Vec3 v;
  along(v, axis) = 1;
  return v;
}

}  // namespace

class Measurer::Row {
 public:
  void add(const SizeValue& size) {
    using enum syntax::SizeKind;
    switch (size.kind) {
      case absolute:
        total_ = total_ + NaturalSize::exactly(size.value);
        break;
      case percent:
        percent_ += size.value;
        break;
      case relative:
        total_ = total_ + NaturalSize{};
        break;
      case floating:
        total_ = total_ + NaturalSize{0, size.value, NaturalSize::unbounded};
        break;
      case dont_care:
        total_ = total_ + NaturalSize{size.minimum, size.value, size.maximum};
        break;
    }
  }
  /// A group that may be left out; it wants to be there once.
  void add_group(const Row& group) {
    total_ = total_ + NaturalSize{0, group.total_.preferred, NaturalSize::unbounded};
    percent_ += group.percent_;
  }
  /// Per cent are of the whole: 10%, 2 and 10% are 2.5 long together.
  NaturalSize whole() const {
    const double rest = 1 - percent_ / 100;
    if (rest <= 1e-9) return {};
    return {total_.minimum / rest, total_.preferred / rest, total_.maximum / rest};
  }

 private:
  NaturalSize total_{0, 0, 0};
  double percent_ = 0;
};

void Measurer::split(Context& c, Piece& piece, Result& result) {
  ++result.emitted;
  const Value word = c.value(0);
  const auto axis = word.type == Type::string ? axis_named(word.string()) : std::nullopt;
  if (!axis) return result.add({}, piece);
  c.count_apart();
  if (axis == open_axis(piece.shape)) return result.add(along_it(c, *axis), piece);
  across(c, *axis, piece, result);
}

NaturalSize Measurer::along_it(Context& c, Axis axis) {
  if (c.call.operation->rule == PartRule::body) {  // repeat
    if (!c.call.measures) return {0, c.number(1), NaturalSize::unbounded};
    const SizeValue size = measures_of(c, axis)[0];
    if (size.kind == syntax::SizeKind::relative) return {};
    return {size.minimum, size.value, NaturalSize::unbounded};
  }
  Row row;
  if (c.call.operation->rule == PartRule::pattern) {
    std::size_t place = 0;
    row_of(c, c.call.parts, axis, place, row);
    return row.whole();
  }
  auto& values = machine_.size_values;
  const std::size_t first = values.size();
  read_sizes(c, axis);
  for (std::size_t i = first; i < values.size(); ++i) row.add(values[i]);
  values.resize(first);
  return row.whole();
}

/// A pattern once.
void Measurer::row_of(Context& c, const std::vector<CallPart>& parts, Axis axis, std::size_t& place,
                      Row& row) {
  for (const CallPart& part : parts) {
    if (!part.group.empty()) {
      Row group;
      row_of(c, part.group, axis, place, group);
      row.add_group(group);
      continue;
    }
    Shape piece = c.shape;
    mark_part(piece, axis, place++, Shape::none, 0);
    if (part.size.kind == syntax::SizeKind::dont_care) {
      row.add(measured_size(c, part.size, part, piece, axis));
      continue;
    }
    auto& values = machine_.size_values;
    const std::size_t first = values.size();
    read_size(machine_, part.size, c.env, values);
    for (std::size_t i = first; i < values.size(); ++i) row.add(values[i]);
    values.resize(first);
  }
}

namespace {

/// Parts of a split across what is measured, one after the other.
struct Columns {
  std::vector<double> lengths;  ///< NaN where the shape's own is
  std::vector<const CallPart*> parts;
  std::vector<std::size_t> rounds;

  void add(const CallPart& part, double length, std::size_t round) {
    parts.push_back(&part);
    lengths.push_back(length);
    rounds.push_back(round);
  }
};

/// Every part once, as long as may be.
void add_each(const std::vector<CallPart>& parts, double whole, Columns& columns) {
  for (const CallPart& part : parts) {
    part.group.empty() ? columns.add(part, whole, 0) : add_each(part.group, whole, columns);
  }
}

Columns columns_of(Context& c, Axis axis, double whole) {
  Columns columns;
  const std::vector<CallPart>& parts = c.call.parts;
  if (std::isnan(whole)) {
    add_each(parts, whole, columns);
  } else if (c.call.operation->rule == PartRule::pattern) {
    Pattern pattern = pattern_of(c, axis, whole);
    solve_sizes(pattern.sizes, whole, columns.lengths);
    columns.parts = std::move(pattern.parts);
    columns.rounds = std::move(pattern.rounds);
  } else if (c.call.operation->rule == PartRule::body) {
    const SizeValue size = repeated_size(c, axis);
    const auto mode = taker<std::optional<std::string_view>>::take(c, 2);
    check_repeat(c, size, mode);
    const double count = repeats(whole, size, mode);
    check_repeats(c, size, count);
    const auto n = static_cast<std::size_t>(count);
    for (std::size_t i = 0; i < n; ++i) columns.add(parts[0], whole / static_cast<double>(n), i);
  } else {
    auto& values = c.machine.size_values;
    const std::size_t first = values.size();
    read_sizes(c, axis);
    solve_sizes(std::span(values).subspan(first), whole, columns.lengths);
    values.resize(first);
    for (std::size_t i = 0; i < columns.lengths.size(); ++i) {
      columns.parts.push_back(&parts[parts.size() == 1 ? 0 : i]);
      columns.rounds.push_back(0);
    }
  }
  return columns;
}

}  // namespace

void Measurer::across(Context& c, Axis axis, const Piece& piece, Result& result) {
  const double whole = along(piece.shape.scope.size, axis);
  const Columns columns = columns_of(c, axis, whole);
  double at = 0;
  for (std::size_t i = 0; i < columns.parts.size(); ++i) {
    const double length = std::isnan(whole) ? whole : std::min(columns.lengths[i], whole - at);
    if (length <= touch) continue;
    Piece inner = piece;
    inner.shape.scope.origin = inner.shape.scope.at(unit(axis) * at);
    along(inner.shape.scope.size, axis) = length;
    mark_part(inner.shape, axis, i, columns.parts.size(), columns.rounds[i]);
    if (axis == Axis::x && at > touch) inner.shape.corner_left = 180;
    if (axis == Axis::x && at + length < whole - touch) inner.shape.corner_right = 180;
    on_part(c, *columns.parts[i], i, inner, result);
    at += length;
  }
}

}  // namespace mansard
