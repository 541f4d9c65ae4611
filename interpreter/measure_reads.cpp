// What a measure depends on: what its rules read of the shape, and what they may not read.
#include <algorithm>
#include <bit>
#include <cmath>

#include "interpreter/function.hpp"
#include "interpreter/measure.hpp"

namespace mansard {
namespace {

constexpr std::size_t most_notes = 4;
static_assert(1u << static_cast<int>(Attribute::seed) <= read_bits::attributes);

uint64_t bits_of(double v) { return std::isnan(v) ? 1 : std::bit_cast<uint64_t>(v + 0.0); }

}  // namespace

void Measurer::check_call(const Function& function, uint32_t node) {
  if (function.asks != Asks::nothing) refuse_question(machine_.program.spans[node]);
}

void Measurer::refuse_question(Span at) const {
  Diagnostic d;
  d.at = at;
  d.text =
      "what '" + std::string(at.text()) + "' comes to is not known while a size ':' is measured";
  d.help = "give the part a size, or ask in a rule above the split";
  refuse(std::move(d));
}

void Measurer::check_read(Attribute which, const Shape& shape, uint32_t node) {
  using enum Attribute;
  const Vec3 size = shape.scope.size, origin = shape.scope.origin;
  const double all = size.x + size.y + size.z;
  double read = 0;
  switch (which) {
    case width:
      read = size.x;
      break;
    case height:
      read = size.y;
      break;
    case depth:
      read = size.z;
      break;
    case tx:
      read = origin.x;
      break;
    case ty:
    case elevation:
      read = origin.y;
      break;
    case tz:
      read = origin.z;
      break;
    case area:
    case volume:
    case perimeter:
    case inradius:
      read = all;
      break;
    case is_rectangle:
    case is_convex:
    case edges:
      read = shape.form == Form::rectangle || shape.form == Form::box ? 0 : all;
      break;
    case split_count:
      read = shape.split_count == Shape::none ? std::numeric_limits<double>::quiet_NaN() : 0;
      break;
    default:
      break;
  }
  if (!std::isnan(read)) return;
  Diagnostic d;
  d.at = machine_.program.spans[node];
  d.text = "a size ':' that depends on itself: '" + std::string(d.at.text()) +
           "' is asked for to find how long this shape is along " + letter_of(letter_);
  d.help = "give the part a size, or let its rules do without '" + std::string(d.at.text()) +
           "'; 'fits' holds while a part is measured";
  try {
    refuse(std::move(d));
  } catch (Failure& failure) {
    throw UnknownLength(std::move(failure.diagnostic));
  }
}

/// Says for which sizes ':' it was asked.
void Measurer::refuse(Diagnostic d) const {
  std::vector<Span> said;
  for (auto at = open_.rbegin(); at != open_.rend() && said.size() < most_notes; ++at) {
    if (std::ranges::find(said, *at) != said.end()) continue;
    said.push_back(*at);
    d.notes.push_back({said.size() == 1 ? "while this is measured" : "which this needs", *at});
  }
  throw Failure(std::move(d));
}

/// All that every rule may depend on.
uint64_t Measurer::key_of(const Shape& shape, Axis axis) const {
  const Vec3 size = shape.scope.size;
  uint64_t key = mix(shape.symbol, shape.style);
  key = mix(key, static_cast<uint64_t>(axis) | static_cast<uint64_t>(shape.form) << 8 |
                     static_cast<uint64_t>(shape.ground) << 16 |
                     static_cast<uint64_t>(shape.plain) << 17);
  for (const double v : {size.x, size.y, size.z, shape.index}) key = mix(key, bits_of(v));
  return mix(key, machine_.inherited_values(shape));
}

/// What its rules did read of it, besides.
uint64_t Measurer::read_of(const Shape& shape, uint32_t reads) const {
  uint64_t key = reads & (read_bits::chance | read_bits::attributes);
  if (reads & read_bits::chance) key = mix(key, shape.seed);
  for (uint32_t bit = 0; 1u << bit <= read_bits::attributes; ++bit) {
    if (!(reads & 1u << bit)) continue;
    const auto which = static_cast<Attribute>(bit);
    key = mix(key, bit);
    switch (which) {
      case Attribute::comp_name:
        key = mix(key, shape.comp_name);
        break;
      case Attribute::area:
      case Attribute::volume:
      case Attribute::perimeter:
      case Attribute::inradius:
      case Attribute::edges:
      case Attribute::is_rectangle:
      case Attribute::is_convex:
      case Attribute::is_planar:
        key = mix(key, shape.geometry);
        break;
      case Attribute::seed:
        key = mix(key, shape.seed);
        break;
      default:
        key = mix(key, bits_of(machine_.attribute_number(which, shape)));
    }
  }
  return key;
}

}  // namespace mansard
