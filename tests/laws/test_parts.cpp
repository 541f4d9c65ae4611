// Parts that are derived once and placed many times: the result is the same to the last bit as when
// each is derived for itself.
#include <doctest/doctest.h>

#include <array>
#include <cstring>
#include <filesystem>

#include "tests/laws/derive.hpp"

namespace {

using namespace mansard;
using namespace mansard::test;

template <class T>
bool same_bytes(const std::vector<T>& a, const std::vector<T>& b) {
  return a.size() == b.size() &&
         (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0);
}

bool same_runs(const Surface& a, const Surface& b) {
  return std::ranges::equal(a.runs, b.runs, [](const auto& p, const auto& q) {
    return p.symbol == q.symbol && p.material == q.material && p.end == q.end;
  });
}

bool same_placed(const Surface& a, const Surface& b) {
  return std::ranges::equal(a.placed, b.placed, [](const auto& p, const auto& q) {
    return p.mesh == q.mesh && p.begin == q.begin && p.end == q.end && p.origin == q.origin;
  });
}

bool same_drips(const Building& a, const Building& b) {
  return std::ranges::equal(a.drips, b.drips, [](const Drip& p, const Drip& q) {
    return p.from == q.from && p.to == q.to && p.top == q.top && p.seed == q.seed;
  });
}

/// What differs, or nothing.
std::string difference(const Building& a, const Building& b) {
  if (!same_bytes(a.surface.points, b.surface.points)) return "points";
  if (!same_bytes(a.surface.uvs, b.surface.uvs)) return "uvs";
  if (!same_bytes(a.surface.normals, b.surface.normals)) return "normals";
  if (a.surface.ends != b.surface.ends) return "polygons";
  if (!same_runs(a.surface, b.surface)) return "runs";
  if (!same_placed(a.surface, b.surface)) return "placed meshes";
  if (!same_drips(a, b)) return "drips";
  if (a.terminals != b.terminals || a.taken != b.taken) return "counts";
  if (a.shapes != b.shapes || a.operations != b.operations) return "totals";
  if (a.parts_cut != b.parts_cut || a.unmatched != b.unmatched) return "what did not fit";
  if (a.materials != b.materials) return "materials";
  if (a.report.size() != b.report.size()) return "report";
  if (a.warnings.size() != b.warnings.size()) return "warnings";
  for (std::size_t i = 0; i < a.warnings.size(); ++i) {
    if (a.warnings[i].text != b.warnings[i].text) return "a warning";
  }
  return {};
}

/// A row of buildings, twice over: of several heights and uses, each with its own id.
std::vector<Footprint> street() {
  std::vector<Footprint> all;
  const auto add = [&](const char* literal, double height, const char* use, double width) {
    Footprint f = footprint(literal);
    f.id = std::string(literal) + use + std::to_string(all.size());
    f.properties.push_back({"height", height});
    f.properties.push_back({"use", std::string(use)});
    if (width > 0) f.properties.push_back({"TileWidth", width});
    all.push_back(std::move(f));
  };
  for (int round = 0; round < 2; ++round) {
    add("rect:10x8", 9, "shop", 0);
    add("rect:10x8", 9, "shop", 2.5);
    add("rect:10x8", 13, "flat", 0);
    add("L:14x11x6x5", 9, "flat", 0);
    add("WKT:POLYGON((0 0, 9 -2, 15 4, 13 12, 5 14, -2 7, 0 0))", 11, "shop", 0);
    add("WKT:POLYGON((1003 2001, 1013 2001, 1013 2009, 1003 2009, 1003 2001))", 9, "shop", 0);
  }
  return all;
}

double furthest(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
  double most = 0;
  for (std::size_t i = 0; i < a.size(); ++i) most = std::max(most, length(a[i] - b[i]));
  return most;
}

double furthest(const std::vector<Vec2>& a, const std::vector<Vec2>& b) {
  double most = 0;
  for (std::size_t i = 0; i < a.size(); ++i) most = std::max(most, length(a[i] - b[i]));
  return most;
}

/// Where trees are kept every shape is derived where it stands: what was derived at the origin and
/// moved has the same points and its textures lie the same.
/// Far away ties between corners of roofs fall otherwise, and so do their points' order.
void check_placed(const Script& script, bool far_away = true) {
  REQUIRE_MESSAGE(script.good(), script.problems());
  Derivation moving(script.program(), script.meshes(), {});
  Derivation still(script.program(), script.meshes(), {.keep_tree = true});
  Building a, b;
  for (Footprint on : street()) {
    if (!far_away && on.polygon.points[0].x > 100) continue;
    on.properties.push_back({"min_height", 1.3});  // the foot of the building
    CAPTURE(on.id);
    moving.derive(on, a);
    still.derive(on, b);
    REQUIRE(a.surface.points.size() == b.surface.points.size());
    CHECK(furthest(a.surface.points, b.surface.points) < 1e-9);
    CHECK(furthest(a.surface.uvs, b.surface.uvs) < 1e-6);
    CHECK(furthest(a.surface.normals, b.surface.normals) < 1e-9);
    REQUIRE(a.drips.size() == b.drips.size());
    for (std::size_t i = 0; i < a.drips.size(); ++i) {
      CHECK(length(a.drips[i].from - b.drips[i].from) < 1e-9);
      CHECK(a.drips[i].top == doctest::Approx(b.drips[i].top));
    }
  }
}

/// Derives the street with and without copies; gives how many shapes were copied.
std::size_t check_same(const Script& script, DeriveOptions options = {}) {
  REQUIRE_MESSAGE(script.good(), script.problems());
  DeriveOptions apart = options;
  apart.share_parts = false;
  Derivation sharing(script.program(), script.meshes(), options);
  Derivation alone(script.program(), script.meshes(), apart);
  Building a, b;
  std::size_t copied = 0;
  for (const Footprint& on : street()) {
    CAPTURE(on.id);
    std::string why_a, why_b;
    const auto attempt = [&](Derivation& derivation, Building& building, std::string& why) {
      try {
        derivation.derive(on, building);
      } catch (const Failure& failure) {
        why = to_text(failure.diagnostic, false);
      }
    };
    attempt(sharing, a, why_a);
    attempt(alone, b, why_b);
    CHECK(why_a == why_b);
    CHECK(difference(a, b) == "");
    CHECK(b.copied == 0);
    copied += a.copied;
  }
  return copied;
}

/// A box with rows of tiles on its sides, and what a tile becomes.
Script tiles(const std::string& rules) {
  return Script::text(R"(style Tiles {
    Main {
      var TileWidth = 2
      var Drawn = rand(0, 1)
      @per("shape") var Each = rand(0, 1)
      FOOTPRINT -> extrude(BUILDING_HEIGHT) comp { side : FACADE | top : ROOF }
      FACADE -> repeat("Y", 3) { FLOOR }
      FLOOR -> repeat("X", TileWidth) { TILE }
      WALL -> color("tan") PLASTER
      def deeper(x) = x + TileWidth / 10
      )" + rules + "} Materials { PLASTER : color(\"tan\") : 2 color(\"white\") : 1 } }");
}

}  // namespace

TEST_CASE("examples are the same with and without copies of parts") {
  std::size_t scripts = 0, copied = 0;
  const std::filesystem::path root = MANSARD_ROOT;
  for (const char* folder : {"examples", "styles/library", "bench"}) {
    for (const auto& entry : std::filesystem::recursive_directory_iterator(root / folder)) {
      if (entry.path().extension() != ".style" || entry.path().stem() == "mistake") continue;
      const std::string path = std::filesystem::relative(entry.path(), root).string();
      CAPTURE(path);
      const Script script = Script::file(path);
      ++scripts;
      copied += check_same(script);
      check_same(script, {.seed = 7, .lod = 2});
      if (!path.starts_with("bench")) check_placed(script, false);
    }
  }
  CHECK(scripts > 40);
  CHECK(copied > 10'000);
}

TEST_CASE("a box of tiles is copied as a whole") {
  const Script script = Script::file("bench/facade_box.style");
  Derivation derivation(script.program(), script.meshes(), {});
  Building building;
  derivation.derive(footprint("rect:10x8"), building);
  CHECK(building.copied > building.shapes / 3);  // all but its first tiles
  derivation.derive(footprint("rect:10x8"), building);
  CHECK(building.copied > building.shapes * 9 / 10);
}

TEST_CASE("tiles that are alike are copied") {
  for (const char* rules : {
           "TILE -> detrude(0.2) { WINDOW | WALL }",
           "TILE -> set(TileWidth, 1) repeat(\"X\", TileWidth) { PANE }",
           "TILE -> subdiv(\"X\", 1r, 0.3, 1r) { WALL | BAR(deeper(2)) | WALL }"
           "BAR(n) -> subdiv(\"Y\", n / 10, 1r) { A | B }",
           "TILE -> subdiv(\"X\", 1r, 0.3) { A[split.index] | B } A -> subdiv(\"Y\", 1r, index + "
           "1) "
           "{ C | D }",
           "TILE : W > 1 -> [ extrude(0.1) { SLAB } ] subdiv(\"Y\", 1, 1r) { WALL | PANE }"
           "TILE : else -> WALL",
           "TILE -> label(\"tile\") super_tile super_tile -> subdiv(\"X\", 1r, 1r) { A | B }",
       }) {
    CAPTURE(std::string(rules));
    CHECK(check_same(tiles(rules)) > 1000);
  }
}

TEST_CASE("what tiles depend on is seen, or they are not copied") {
  for (const char* rules : {
           "TILE : split.index == 1 -> detrude(0.2) { DOOR | WALL }"
           "TILE : else -> detrude(0.2) { WINDOW | WALL }",
           "TILE : split.index == split.count - 1 -> subdiv(\"X\", 1r, 1r) { A | B }"
           "TILE : else -> subdiv(\"X\", 1r, 1r) { A | C }",
           "TILE : level == 1 -> subdiv(\"X\", 1r, 1r) { A | B }"
           "TILE : else -> subdiv(\"X\", 1r, 1r) { C | D }",
           "TILE : elevation > 3 -> subdiv(\"X\", 1r, 1r) { A | B }"
           "TILE : else -> subdiv(\"X\", 1r, 1r) { C | D }",
           "TILE : facing < 90 -> subdiv(\"X\", 1r, 1r) { A | B }"
           "TILE : else -> subdiv(\"X\", 1r, 1r) { C | D }",
           "TILE -> subdiv(\"X\", 1r, 1r) { A | B } : 0.5 TILE -> subdiv(\"X\", 1r, 1r) { C | D } "
           ": 0.5",
           "TILE -> subdiv(\"X\", rand(0.2, 0.6), 1r) { A | B }",
           "TILE -> subdiv(\"X\", 0.1 + 0.5 * Drawn, 1r) { A | B }",
           "TILE -> subdiv(\"X\", 0.1 + 0.5 * Each, 1r) { A | B }",
           "TILE -> subdiv(\"X\", 0.1 + 0.5 * seed, 1r) { A | B }",
           "TILE -> subdiv(\"X\", TileWidth / 7, 1r) { A | B }",
           "TILE -> subdiv(\"X\", BUILDING_HEIGHT / 40, 1r) { A | B }",
           "TILE : BUILDING_USE == \"shop\" -> subdiv(\"X\", 1r, 1r) { A | B }"
           "TILE : else -> subdiv(\"X\", 1r, 1r) { C | D }",
           "TILE -> subdiv(\"X\", attr(\"height\", 3) / 40, 1r) { A | B }",
           "TILE -> subdiv(\"X\", 1r, 1r) { A | B } report(\"tiles\", 1)",
           "TILE -> subdiv(\"X\", 0.2, 0.2) { A | B }",
           "TILE -> subdiv(\"X\", 1.2, 1.3) { A | B }",
           "TILE : W > 5 -> subdiv(\"X\", 1r, 1r) { A | B }",
           "TILE -> subdiv(\"X\", 1r, 1r) { color(if level > 0 then \"red\" else \"blue\") A | B }",
           "TILE -> subdiv(\"Y\", 1, 1r) { A | TILE2 } TILE2 : H > 1 -> subdiv(\"Y\", 1, 1r) { A | "
           "TILE2 } TILE2 : else -> B",
       }) {
    CAPTURE(std::string(rules));
    check_same(tiles(rules));
  }
}

/// Rules of a tile whose textures run on over it, fold into its reveals or start with it.
constexpr std::array textured{
    "TILE -> detrude(0.2) { WINDOW | WALL }",
    "TILE -> subdiv(\"X\", 1r, 0.5, 1r) { WALL | extrude(0.3) BAR | detrude(0.1) { A | B } }",
    "TILE -> [ extrude(0.4, corners = \"mitre\") TOP ] [ t(0, 0, 0.1) subdiv(\"Y\", 1r, 1r) { A | "
    "B } ]",
    "TILE -> subdiv(\"X\", 1r, 1r) { t(0, 0, 0.1) uv(1, 1) A | t(0, 0, 0.1) uv() B }",
    "TILE -> t(0, 0, 0.3) detrude(0.2) { uv(2, 1, turn = 30) WINDOW | WALL }",
    "TILE -> extrude(0.5) INNER INNER -> comp { side : FACE | front : FACE } "
    "FACE -> subdiv(\"Y\", 1r, 1r) { A | extrude(0.1) B }",
    "TILE -> material(PLASTER) t(0, 0, 0.2) INNER INNER -> subdiv(\"Y\", 1r, 1r) { A | B }",
    "TILE -> stain(0.5) subdiv(\"Y\", 1r, 0.2, 1r) { A | extrude(0.3) SILL | DEEP } "
    "DEEP -> subdiv(\"Y\", 1r, 0.1) { MORE | extrude(0.2) B } MORE -> extrude(0.1) LEDGE",
};

TEST_CASE("textures of parts lie as if nothing had moved") {
  std::size_t copied = 0;
  for (const char* rules : textured) {
    CAPTURE(std::string(rules));
    const Script script = tiles(rules);
    copied += check_same(script);
    check_placed(script);
  }
  CHECK(copied > 10'000);
  for (const char* name : {"materials", "weathered", "mitre", "gable_windows"}) {
    CAPTURE(std::string(name));
    check_placed(Script::file("examples/" + std::string(name) + ".style"));
  }
}

/// Every mesh is a sheet of paper with its own picture on it.
class Sheets final : public MeshSource {
 public:
  Sheets() {
    sheet_.points = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    sheet_.add_face(std::array<uint32_t, 4>{0, 1, 2, 3});
    sheet_.uvs = {{0.25, 0.25}, {0.75, 0.25}, {0.75, 0.5}, {0.25, 0.5}};
    sheet_.materials.resize(1);
    sheet_.materials[0].name = "print";
    sheet_.faces[0].material = 0;
  }
  const Mesh* mesh(const std::string&, std::string&) override { return &sheet_; }
  bool has_picture(const std::string&) override { return true; }

 private:
  Mesh sheet_;
};

TEST_CASE("meshes of parts keep their own texture coordinates") {
  const Script script = Script::text(
      "style Posters { Main { FOOTPRINT -> extrude(9) comp { side : WALL } WALL -> repeat(\"Y\", "
      "3) { TILE } TILE -> subdiv(\"Y\", 1r, 1r) { A | insert(\"sheet.obj\") POSTER } } }",
      std::make_unique<Sheets>());
  check_same(script);
  check_placed(script);
  const Building building = script.derive("rect:10x8");
  std::size_t posters = 0;
  for_each_polygon(building.surface, [&](std::size_t polygon, uint32_t symbol) {
    if (symbol != script.symbol("POSTER")) return;
    ++posters;
    CHECK(building.surface.uvs[building.surface.begin(polygon)] == Vec2{0.25, 0.25});
  });
  CHECK(posters == 12);
}

TEST_CASE("copies keep to the limits") {
  const Script script = tiles("TILE -> detrude(0.2) { WINDOW | WALL }");
  check_same(script, {.max_shapes = 100});
  check_same(script, {.max_depth = 4});
  check_same(script, {.max_depth = 3});
}
