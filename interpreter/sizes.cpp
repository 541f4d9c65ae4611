#include "interpreter/sizes.hpp"

#include <algorithm>

namespace mansard {
namespace {

using enum syntax::SizeKind;

/// What sizes of each kind come to together.
struct Totals {
  double fixed = 0, shares = 0, wanted = 0, preferred = 0, minima = 0;

  Totals(std::span<const SizeValue> sizes, double whole) {
    for (const SizeValue& s : sizes) {
      if (s.kind == absolute) fixed += s.value;
      if (s.kind == percent) fixed += s.value / 100 * whole;
      if (s.kind == relative) shares += s.value;
      if (s.kind == floating) wanted += s.value;
      if (s.kind == dont_care) preferred += s.value, minima += s.minimum;
    }
  }
};

/// Metres of a ':' where they all have `room` together and nothing else does, or less room than
/// they prefer. Between minimum and preference the same fraction for each.
double shrunk(const SizeValue& s, const Totals& totals, double room) {
  if (room >= totals.preferred) return s.value;
  if (room <= totals.minima) return s.minimum;
  return s.minimum +
         (s.value - s.minimum) * (room - totals.minima) / (totals.preferred - totals.minima);
}

/// By how much the ':' that are not at their maximum stretch, so that all of them fill the room:
/// those that reach theirs leave the others more, so again until none does.
double stretch_to(std::span<const SizeValue> sizes, double room) {
  double factor = 1;
  for (;;) {
    double growing = 0, full = 0;
    for (const SizeValue& s : sizes) {
      if (s.kind != dont_care) continue;
      s.value* factor < s.maximum ? growing += s.value : full += s.maximum;
    }
    const double next = growing > 0 ? (room - full) / growing : factor;
    if (next <= factor) return factor;
    factor = next;
  }
}

}  // namespace

double solve_sizes(std::span<const SizeValue> sizes, double whole, std::vector<double>& out) {
  const Totals totals(sizes, whole);
  const double beside = std::max(0.0, whole - totals.fixed);  // the fixed ones
  const double measured =
      std::max(totals.minima, std::min(totals.preferred, beside));  // all ':' together
  const double room = std::max(0.0, beside - measured);
  const bool floats_fill = totals.wanted > 0 && (totals.shares <= 0 || totals.wanted > room);
  const double stretch = floats_fill ? room / totals.wanted : 1;
  const double share =
      totals.shares > 0 ? std::max(0.0, room - totals.wanted * stretch) / totals.shares : 0;
  const bool alone = totals.shares <= 0 && totals.wanted <= 0 && totals.preferred > 0;
  const double grown = alone && beside > totals.preferred ? stretch_to(sizes, beside) : 1;
  double left = whole;
  for (const SizeValue& s : sizes) {
    switch (s.kind) {
      case absolute:
        out.push_back(s.value);
        break;
      case percent:
        out.push_back(s.value / 100 * whole);
        break;
      case relative:
        out.push_back(s.value * share);
        break;
      case floating:
        out.push_back(s.value * stretch);
        break;
      case dont_care:
        out.push_back(grown > 1 ? std::min(s.maximum, s.value * grown) : shrunk(s, totals, beside));
        left -= out.back();
        break;
    }
  }
  left -= totals.fixed;
  return left >= 0 && (totals.shares > 0 || totals.wanted > 0) ? 0 : left;
}

}  // namespace mansard
