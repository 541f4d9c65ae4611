#include "interpreter/building_height.hpp"

#include <cmath>

#include "interpreter/units.hpp"

namespace mansard {

double number_or(const Footprint& footprint, std::string_view name, double fallback) {
  const Property* p = footprint.find(name);
  if (!p) return fallback;
  if (const double* v = std::get_if<double>(&p->value)) return std::isfinite(*v) ? *v : fallback;
  const std::string* text = std::get_if<std::string>(&p->value);
  return text ? read_number(*text).value_or(fallback) : fallback;
}

double base_of(const Footprint& footprint) { return number_or(footprint, "min_height", 0); }

double height_of(const Footprint& footprint) {
  const double base = base_of(footprint), top = number_or(footprint, "height", 0);
  const double height = top > base ? top - base : top;
  if (height > 0) return height;
  const double levels = number_or(footprint, "building:levels", 0);
  return levels > 0 ? levels * 3 : 9;
}

}  // namespace mansard
