#include "interpreter/snap_lines.hpp"

#include <algorithm>
#include <cmath>

namespace mansard {
namespace {

constexpr double touch = 1e-9;  ///< metres; less is no distance

/// The nearest of the lines in (low, high] that lies within the tolerance; of two as near, the
/// first.
SnapLine* nearest_line(std::span<SnapLine> lines, double at, double low, double high,
                       double tolerance) {
  SnapLine* best = nullptr;
  for (SnapLine& line : lines) {
    const double far = std::abs(line.at - at);
    if (line.at <= low + touch || line.at > high + touch || far > tolerance + touch) continue;
    if (!best || far < std::abs(best->at - at) - touch) best = &line;
  }
  return best;
}

}  // namespace

void keep_apart(std::span<SnapLine> lines, double whole, double tolerance) {
  const double apart = std::max(tolerance, same_line) - touch;
  double before = 0;
  for (SnapLine& line : lines) {
    line.used = line.at - before >= apart && whole - line.at >= apart;
    if (line.used) before = line.at;
  }
}

void pull(std::span<double> lengths, double whole, std::span<SnapLine> lines, double tolerance) {
  double before = 0, at = 0;  // the boundary before, and the end of part i, unmoved
  for (std::size_t i = 0; i < lengths.size();) {
    at += lengths[i];
    std::size_t next = i + 1;  // the first part behind that has a length: it begins here, too
    while (next < lengths.size() && lengths[next] <= touch) ++next;
    const bool inside = at > touch && at < whole - touch;
    if (inside) {
      const double after = next < lengths.size() ? std::min(at + lengths[next], whole) : whole;
      SnapLine* const line =
          nearest_line(lines, at, (before + at) / 2, (at + after) / 2, tolerance);
      if (line) {
        line->used = true;
        lengths[i] += line->at - at;
        if (next < lengths.size()) lengths[next] += at - line->at;
      }
      before = at;
      // What was taken from the next part is not to move the boundary behind it.
      if (line) at = line->at;
    }
    i = next;
  }
}

}  // namespace mansard
