// Prints real footprints with the arcs of their skeletons, for the comparison with PostGIS: a line
// `number TAB cleaned polygon TAB arcs`, the last two in WKT.
//
//     skeleton_lines COUNT        footprints at most, spread evenly over all sets
#include <cstdio>
#include <cstdlib>
#include <string>

#include "geometry/skeleton.hpp"
#include "tests/geometry/roof_input.hpp"

namespace mansard {
namespace {

std::string text_of(Vec2 p) {
  char buffer[64];
  std::snprintf(buffer, sizeof buffer, "%.17g %.17g", p.x, p.y);
  return buffer;
}

std::string polygon_wkt(const Polygon& polygon) {
  std::string text = "POLYGON(";
  for (std::size_t r = 0; r < polygon.rings(); ++r) {
    text += r == 0 ? "(" : ",(";
    for (const Vec2 p : polygon.ring(r)) text += text_of(p) + ",";
    text += text_of(polygon.ring(r)[0]) + ")";
  }
  return text + ")";
}

// Every arc once, from its lower number.
std::string arcs_wkt(const SkeletonMesh& mesh) {
  std::string text = "MULTILINESTRING(";
  for (std::size_t f = 0; f < mesh.faces(); ++f) {
    const auto face = mesh.face(f);
    for (std::size_t i = 1; i < face.size(); ++i) {
      const uint32_t a = face[i], b = face[(i + 1) % face.size()];
      const Vec2 p{mesh.nodes[a].x, mesh.nodes[a].y}, q{mesh.nodes[b].x, mesh.nodes[b].y};
      if (a > b || p == q) continue;
      text += (text.back() == '(' ? "(" : ",(") + text_of(p) + "," + text_of(q) + ")";
    }
  }
  return text + ")";
}

}  // namespace
}  // namespace mansard

int main(int argc, char** argv) {
  using namespace mansard;
  const std::size_t count = argc > 1 ? std::strtoul(argv[1], nullptr, 10) : 2000;
  const auto all = test::real_footprints(1, 1);
  const std::size_t step = std::max<std::size_t>(1, all.size() / std::max<std::size_t>(count, 1));
  std::size_t printed = 0;
  for (std::size_t i = 0; i < all.size() && printed < count; i += step) {
    const auto on = best_skeleton(all[i].polygon);
    if (!on) continue;
    std::printf("%zu\t%s\t%s\n", i, polygon_wkt(on->polygon).c_str(), arcs_wkt(on->mesh).c_str());
    ++printed;
  }
  return 0;
}
