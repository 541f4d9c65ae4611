#include "interpreter/sizes.hpp"

#include <algorithm>

namespace mansard {

double solve_sizes(std::span<const SizeValue> sizes, double whole, std::vector<double>& out) {
  using enum syntax::SizeKind;
  double fixed = 0, shares = 0, wanted = 0;
  for (const SizeValue& s : sizes) {
    if (s.kind == absolute) fixed += s.value;
    if (s.kind == percent) fixed += s.value / 100 * whole;
    if (s.kind == relative) shares += s.value;
    if (s.kind == floating) wanted += s.value;
  }
  const double room = std::max(0.0, whole - fixed);
  const bool floats_fill = wanted > 0 && (shares <= 0 || wanted > room);
  const double stretch = floats_fill ? room / wanted : 1;
  const double share = shares > 0 ? std::max(0.0, room - wanted * stretch) / shares : 0;
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
      default:
        out.push_back(s.value * stretch);
        break;
    }
  }
  if (fixed > whole) return whole - fixed;
  return shares > 0 || wanted > 0 ? 0 : whole - fixed;
}

}  // namespace mansard
