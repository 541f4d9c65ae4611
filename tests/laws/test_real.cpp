// Real towns (../shared/data beside the project, not part of it): every building stands on its
// footprint and is as high as its input says. MANSARD_LONG_TESTS=1 takes all four towns.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>

#include "geometry/polygon.hpp"
#include "tests/laws/derive.hpp"

namespace {

using namespace mansard;
using namespace mansard::test;

double lowest(const Surface& surface) {
  double low = 1e9;
  for (const Vec3 p : surface.points) low = std::min(low, p.y);
  return low;
}

/// The area within the edges that stand on the ground (what lies on it cancels out).
double footprint_area(const Surface& surface) {
  const double ground = lowest(surface) + 1e-6;
  double sum = 0;
  for (std::size_t polygon = 0; polygon < surface.polygons(); ++polygon) {
    const auto loop = surface.loop(polygon);
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const Vec3 a = loop[i] - surface.points[0],
                 b = loop[(i + 1) % loop.size()] - surface.points[0];
      if (loop[i].y < ground && loop[(i + 1) % loop.size()].y < ground)
        sum += (a.z * b.x - a.x * b.z) / 2;
    }
  }
  return sum;
}

/// The area of the roof seen from above: faces that look up less those that look down.
double roofed_area(const Surface& surface) {
  double sum = 0;
  for (std::size_t polygon = 0; polygon < surface.polygons(); ++polygon)
    sum += newell(surface.loop(polygon)).y / 2;
  return sum;
}

double high(const Surface& surface) {
  double top = -1e9;
  for (const Vec3 p : surface.points) top = std::max(top, p.y);
  return top - lowest(surface);
}

void check_town(const std::string& name) {
  const std::string path = std::string(MANSARD_ROOT) + "/../shared/data/" + name + ".osm.pbf";
  if (!std::filesystem::exists(path)) {
    MESSAGE(path, " is missing: not tested");
    return;
  }
  FootprintSet set = read_footprints(path, {});
  mark_neighbours(set.footprints);
  const Script script = Script::file("examples/quarter/quarter.style");
  const Script asked =
      Script::text("style Asked { Plot { FOOTPRINT -> report(\"height\", BUILDING_HEIGHT) NIL } }");
  Derivation derivation(script.program(), script.meshes(), {}),
      asking(asked.program(), asked.meshes(), {});
  Building building, answer;
  std::size_t built = 0, failed = 0, wrong_area = 0, wrong_roof = 0, wrong_height = 0,
              fallbacks = 0;
  for (const Footprint& on : set.footprints) {
    try {
      derivation.derive(on, building);
      asking.derive(on, answer);
    } catch (const Failure& failure) {
      if (++failed <= 5) MESSAGE(name, " ", on.id, ": ", failure.diagnostic.text);
      continue;
    }
    if (building.surface.points.empty()) continue;  // too small: NIL
    ++built;
    fallbacks += building.roofs.fallbacks();
    const double plan = area(on.polygon), height = answer.report.at("height").sum;
    const double stands = footprint_area(building.surface), roof = roofed_area(building.surface);
    if (std::abs(stands - plan) > 1e-6 * plan && ++wrong_area <= 10)
      MESSAGE(name, " ", on.id, ": area ", stands, " instead of ", plan);
    // Eaves leave bends of a millimetre out.
    if (std::abs(roof - plan) > 1e-3 * plan && ++wrong_roof <= 10)
      MESSAGE(name, " ", on.id, ": roof over ", roof, " instead of ", plan);
    if (std::abs(high(building.surface) - height) > 1e-6 * height && ++wrong_height <= 10)
      MESSAGE(name, " ", on.id, ": height ", high(building.surface), " instead of ", height);
  }
  MESSAGE(name, ": ", built, " of ", set.footprints.size(), " built, ", failed, " failed, ",
          fallbacks, " simpler roofs, ", wrong_area, " areas, ", wrong_roof, " roofs and ",
          wrong_height, " heights differ");
  CHECK(built > 0);
  CHECK(failed == 0);
  CHECK(wrong_area == 0);
  CHECK(wrong_roof == 0);
  CHECK(wrong_height == 0);
}

}  // namespace

TEST_CASE("Monaco's buildings are as large as their input") { check_town("monaco"); }
TEST_CASE("Helsinki's buildings are as large as their input") { check_town("helsinki"); }
TEST_CASE("other towns' buildings are as large as their input") {
  if (!std::getenv("MANSARD_LONG_TESTS")) return;
  check_town("baltimore");
  check_town("liechtenstein");
}
