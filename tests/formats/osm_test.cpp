#include <doctest/doctest.h>

#include <filesystem>
#include <set>

#include "formats/footprints.hpp"
#include "support.hpp"

using namespace mansard;

namespace {

/// The real sets lie beside the project.
std::string data(const std::string& name) {
  const std::string path = "../shared/data/" + name;
  if (std::filesystem::exists(path)) return path;
  MESSAGE("skipped: " << path << " is not here");
  return {};
}

struct Real {
  const char* file;
  std::size_t at_least;
  double longitude, latitude;
};

std::size_t with(const FootprintSet& set, const char* property) {
  std::size_t count = 0;
  for (const Footprint& f : set.footprints) count += f.find(property) != nullptr;
  return count;
}

void check(const FootprintSet& set) {
  std::set<std::string> ids;
  std::size_t bad = 0, far = 0;
  for (const Footprint& f : set.footprints) {
    ids.insert(f.id);
    bad += !(area(f.polygon) > 0) || f.polygon.tags.size() != f.polygon.points.size();
    for (std::size_t r = 0; r < f.polygon.rings(); ++r) {
      bad += (area(f.polygon.ring(r)) > 0) != (r == 0);
    }
    far += length(f.polygon.points[0]) > 30'000;
  }
  CHECK(bad == 0);
  CHECK(far == 0);
  CHECK(ids.size() == set.footprints.size());
  CHECK(with(set, "building") == set.footprints.size());
}

}  // namespace

TEST_CASE("buildings of real towns") {
  for (const Real& real :
       {Real{"helsinki.osm.pbf", 497, 24.9, 60.2}, Real{"monaco.osm.pbf", 1207, 7.4, 43.7},
        Real{"baltimore.osm.pbf", 1731, -76.6, 39.3}}) {
    CAPTURE(real.file);
    const std::string path = data(real.file);
    if (path.empty()) continue;
    const FootprintSet set = read_footprints(path, {});
    CHECK(set.footprints.size() >= real.at_least);
    check(set);
  }
}
