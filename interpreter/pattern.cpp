#include "interpreter/pattern.hpp"

#include <cmath>

#include "interpreter/context.hpp"
#include "interpreter/messages.hpp"
#include "interpreter/read_sizes.hpp"
#include "interpreter/slice.hpp"

namespace mansard {
namespace {

/// Parts that a group can make.
constexpr std::size_t most_rounds = 100'000;

class Layout {
 public:
  Layout(Context& c, std::optional<Axis> axis) : c_(c), axis_(axis) {}

  Pattern whole(double length);

 private:
  SizeValue size_of(const CallPart& part, std::size_t place, std::size_t round);
  double natural_length(const std::vector<CallPart>& parts, double whole, std::size_t place,
                        std::size_t round);
  void unroll(const std::vector<CallPart>& parts, double room, std::size_t round);
  std::size_t rounds(double times, Span at);
  template <class F>
  std::size_t rounds_of(double room, F length, Span at);

  Context& c_;
  std::optional<Axis> axis_;
  Pattern pattern_;
};

/// Of a part that comes to stand at this place.
SizeValue Layout::size_of(const CallPart& part, std::size_t place, std::size_t round) {
  if (part.size.kind == syntax::SizeKind::dont_care) {
    Shape piece = c_.shape;
    mark_part(piece, axis_, place, Shape::none, round);
    return measured_size(c_, part.size, part, piece, axis_);
  }
  std::vector<SizeValue> values;
  read_size(c_.machine, part.size, c_.env, values);
  if (values.size() != 1) c_.machine.fail(part.at, "a part of 'split' has one size");
  return values[0];
}

/// Metres that a size wants; nothing for a share.
double wanted(const SizeValue& size, double whole) {
  using enum syntax::SizeKind;
  if (size.kind == relative) return 0;
  return size.kind == percent ? size.value / 100 * whole : size.value;
}

/// Metres that a list of parts wants: fixed sizes and floats, groups once.
double Layout::natural_length(const std::vector<CallPart>& parts, double whole, std::size_t place,
                              std::size_t round) {
  double sum = 0;
  for (const CallPart& part : parts) {
    sum += part.group.empty() ? wanted(size_of(part, place, round), whole)
                              : natural_length(part.group, whole, place, round);
    ++place;
  }
  return sum;
}

std::size_t Layout::rounds(double times, Span at) {
  if (times > most_rounds) c_.machine.fail(at, "this repeats " + number_text(times) + " times");
  return static_cast<std::size_t>(std::max(0.0, times));
}

/// As many as come nearest to the room. Where sizes are measured each round has its own length.
template <class F>
std::size_t Layout::rounds_of(double room, F length, Span at) {
  double sum = length(0);
  if (sum <= 0) return most_rounds + 1;
  if (!c_.call.measures) return rounds(std::round(room / sum), at);
  std::size_t n = 0;
  for (double next = sum; sum - next / 2 <= room; sum += next) {
    next = length(rounds(static_cast<double>(++n), at));
  }
  return n;
}

/// Lays parts out in `room` metres; the groups among them share what the others leave.
void Layout::unroll(const std::vector<CallPart>& parts, double room, std::size_t round) {
  double single = 0;
  const std::size_t first = pattern_.sizes.size();
  std::size_t place = first;
  for (const CallPart& part : parts) {
    if (part.group.empty()) single += wanted(size_of(part, place, round), room);
    ++place;
  }
  const auto grouped = [&](std::size_t i) {
    double sum = 0;
    std::size_t at = first;
    for (const CallPart& part : parts) {
      if (!part.group.empty())
        sum += natural_length(part.group, room, at + i * part.group.size(), i);
      ++at;
    }
    return sum;
  };
  for (const CallPart& part : parts) {
    if (part.group.empty()) {
      pattern_.sizes.push_back(size_of(part, pattern_.sizes.size(), round));
      pattern_.parts.push_back(&part);
      pattern_.rounds.push_back(round);
      continue;
    }
    const std::size_t times = rounds_of(room - single, grouped, part.at);
    if (times > most_rounds) {
      c_.machine.fail(part.at, "a repeated group needs a size that is not a share");
    }
    for (std::size_t i = 0; i < times; ++i) {
      unroll(part.group, natural_length(part.group, room, pattern_.sizes.size(), i), i);
    }
  }
}

Pattern Layout::whole(double length) {
  const Call& call = c_.call;
  if (!call.starred) {
    unroll(call.parts, length, 0);
    return std::move(pattern_);
  }
  const auto natural = [&](std::size_t i) {
    return natural_length(call.parts, length, i * call.parts.size(), i);
  };
  const std::size_t times = rounds_of(length, natural, call.parts_at);
  if (times > most_rounds) {
    c_.machine.fail(call.parts_at, "a repeated split needs a size that is not a share");
  }
  for (std::size_t i = 0; i < std::max<std::size_t>(1, times); ++i) {
    unroll(call.parts, natural(i), i);
  }
  return std::move(pattern_);
}

}  // namespace

Pattern pattern_of(Context& c, std::optional<Axis> axis, double whole) {
  return Layout(c, axis).whole(whole);
}

}  // namespace mansard
