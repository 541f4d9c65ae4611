// Textures run on over a wall whatever it is split into; variants follow their weights; chance
// changes what depends on it and nothing else.
#include <doctest/doctest.h>

#include <cmath>
#include <random>

#include "tests/laws/derive.hpp"

namespace {

using namespace mansard;
using namespace mansard::test;

#ifdef __SANITIZE_ADDRESS__
constexpr int draws = 10'000;
constexpr double tolerance = 0.02;
#else
constexpr int draws = 100'000;
constexpr double tolerance = 0.01;
#endif

// ---- one pattern on one wall

class RandomWall {
 public:
  explicit RandomWall(uint32_t seed) : random_(seed) {}

  /// A successor that splits, sinks, raises and takes apart, down to BRICK.
  std::string successor(int levels) {
    if (levels == 0) return "BRICK";
    const std::string inner = successor(levels - 1);
    switch (random_() % 7) {
      case 0:
        return "subdiv(\"X\", " + metres(0.3, 2) + ", 1r) { BRICK | " + inner + " }";
      case 1:
        return "subdiv(\"Y\", 1r, " + metres(0.3, 2) + ") { " + inner + " | BRICK }";
      case 2:
        return "repeat(\"X\", " + metres(0.5, 4) + ") { " + inner + " }";
      case 3:
        return "subdiv(" + metres(20, 70) + ", 1r, 2r) { " + inner + " | BRICK }";
      case 4:
        return "detrude(" + metres(0.05, 0.4) + ") { inner : " + inner + " | reveal : BRICK }";
      case 5:
        return "extrude(" + metres(0.05, 0.4) + ") { comp { front : " + inner +
               " | side : BRICK } }";
      default:
        return "cut(\"circle\") { inside : " + inner + " | outside : BRICK }";
    }
  }
  std::string metres(double low, double high) {
    return std::to_string(std::uniform_real_distribution<double>(low, high)(random_));
  }

 private:
  std::mt19937 random_;
};

/// How far a texture of `metres` is from running on over the polygon from the wall's corner.
double misfit(const Surface& surface, std::size_t polygon, const Scope& wall, Vec2 metres) {
  const auto loop = surface.loop(polygon);
  const Vec3 normal = surface.normals[polygon];
  const bool flat = std::abs(dot(normal, wall.z)) > 0.999;
  const auto uv = [&](std::size_t i) {
    const Vec2 repeats = surface.uvs[surface.begin(polygon) + i];
    return Vec2{repeats.x * metres.x, repeats.y * metres.y};
  };
  double worst = 0;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Vec3 d = loop[i] - wall.origin;
    // On the wall and in parallel planes: the projection. What is folded over begins on it and
    // keeps its lengths.
    if (flat || std::abs(dot(d, wall.z)) < 1e-9) {
      worst = std::max({worst, std::abs(uv(i).x - dot(d, wall.x)), std::abs(uv(i).y - loop[i].y)});
    }
    const std::size_t next = (i + 1) % loop.size();
    worst = std::max(worst, std::abs(length(uv(next) - uv(i)) - length(loop[next] - loop[i])));
  }
  return worst;
}

}  // namespace

TEST_CASE("the texture of a wall runs on over splits, reveals and relief") {
  for (uint32_t seed = 0; seed < 300; ++seed) {
    RandomWall random(seed);
    const std::string script = "style A { Plot { FOOTPRINT -> extrude(" + random.metres(3, 12) +
                               ") comp { front : FRONT }  FRONT -> " +
                               random.successor(1 + static_cast<int>(seed % 6)) +
                               " } Materials { BRICK : texture(\"brick.png\", 0.9, 0.6) } }";
    CAPTURE(script);
    Footprint plot = footprint("rect:" + random.metres(4, 20) + "x8");
    plot.properties.push_back({"min_height", random.metres(0, 3)});
    const Script style = Script::text(script);
    const Building building = style.derive(plot, {.keep_tree = true});
    const Scope* wall = nullptr;
    for (const TreeNode& node : building.tree) {
      if (node.shape.symbol == style.symbol("FRONT")) wall = &node.shape.scope;
    }
    REQUIRE(wall);
    Scope from_foot = *wall;
    for_each_polygon(building.surface, [&](std::size_t polygon, uint32_t) {
      const Surface& s = building.surface;
      REQUIRE(s.uvs.size() == s.points.size());
      Surface lifted = s;  // the height counts from the foot of the building
      for (Vec3& p : lifted.points) p.y -= from_foot.origin.y;
      Scope foot = from_foot;
      foot.origin.y = 0;
      CHECK(misfit(lifted, polygon, foot, {0.9, 0.6}) < 1e-6);
    });
  }
}

TEST_CASE("courses are level on all walls, and uv() begins anew") {
  const Script style = Script::text(
      "style A { Plot { FOOTPRINT -> extrude(2.35) { comp { side : BRICK | top : Upper } }"
      " Upper -> offset(1) { extrude(3) { comp { side : BRICK } } | NIL }"
      "} Materials { BRICK : texture(\"b.png\", 0.9, 0.6) } }");
  const Building building = style.derive("L:12x9x5x4");
  REQUIRE(building.surface.points.size() > 24);
  for (std::size_t i = 0; i < building.surface.points.size(); ++i)
    CHECK(building.surface.uvs[i].y == doctest::Approx(building.surface.points[i].y / 0.6));

  const Building sign =
      Script::text(
          "style A { Plot { FOOTPRINT -> extrude(3) comp { front : subdiv(\"X\", 1, 2, 1r)"
          " { NIL | uv(2, 1) SIGN | NIL } } }"
          " Materials { SIGN : texture(\"b.png\", 7) } }")
          .derive("rect:10x8");
  REQUIRE(sign.surface.uvs.size() == 4);
  const std::array<Vec2, 4> whole{{{0, 0}, {2, 0}, {2, 1}, {0, 1}}};
  for (std::size_t i = 0; i < 4; ++i) {
    CHECK(sign.surface.uvs[i].x == doctest::Approx(whole[i].x));
    CHECK(sign.surface.uvs[i].y == doctest::Approx(whole[i].y));
  }
}

// ---- weights

namespace {

/// How often each material of the symbol was drawn, by polygons.
std::map<uint32_t, int> drawn(const Building& building, uint32_t symbol) {
  std::map<uint32_t, int> counts;
  uint32_t begin = 0;
  for (const Surface::Run& run : building.surface.runs) {
    if (run.symbol == symbol) counts[run.material] += static_cast<int>(run.end - begin);
    begin = run.end;
  }
  return counts;
}

/// The program's own materials begin at 1, in the order of the text.
void check_weights(const std::map<uint32_t, int>& counts) {
  int all = 0;
  for (const auto& [material, count] : counts) all += count;
  CHECK(all >= draws);
  const std::array<double, 3> weights{0.5, 0.3, 0.2};
  for (uint32_t i = 0; i < 3; ++i) {
    const auto found = counts.find(i + 1);
    const double part = found == counts.end() ? 0 : double(found->second) / all;
    CHECK(std::abs(part - weights[i]) < tolerance);
  }
}

std::string panels(const std::string& facade, const std::string& per) {
  return "style A { Plot { FOOTPRINT -> extrude(10) comp { front : FACADE } " + facade +
         " } Materials { PANEL : color(\"red\") : 5  color(\"tan\") : 3  color(\"blue\") : 2  per "
         "\"" +
         per + "\" } }";
}

}  // namespace

TEST_CASE("variants follow their weights, drawn per shape, per floor and per building") {
  SUBCASE("shape") {
    const Script style = Script::text(panels("FACADE -> repeat(\"Y\", 0.1) { repeat(\"X\", " +
                                                 std::to_string(1e3 / draws) + ") { PANEL } }",
                                             "shape"));
    check_weights(drawn(style.derive("rect:10x8"), style.symbol("PANEL")));
  }
  SUBCASE("floor") {
    const Script style =
        Script::text(panels("FACADE -> repeat(\"X\", 0.1) { BAY }  BAY -> repeat(\"Y\", " +
                                std::to_string(1e3 / draws) +
                                ") { FLOOR }  FLOOR -> subdiv(\"X\", 1r, 1r) { PANEL | PANEL }",
                            "FLOOR"));
    const Building building = style.derive("rect:10x8");
    check_weights(drawn(building, style.symbol("PANEL")));
    for (const Surface::Run& run : building.surface.runs) REQUIRE(run.end % 2 == 0);  // pairs agree
  }
  SUBCASE("building") {
    const Script style = Script::text(panels("FACADE -> repeat(\"X\", 5) { PANEL }", "building"));
    Footprint plot = footprint("rect:10x8");
    Derivation derivation(style.program(), style.meshes(), {});
    Building building;
    std::map<uint32_t, int> counts;
    for (int i = 0; i < draws; ++i) {
      plot.id = "way/" + std::to_string(i);
      derivation.derive(plot, building);
      REQUIRE(building.surface.runs.size() == 1);  // both panels agree
      ++counts[building.surface.runs[0].material];
    }
    check_weights(counts);
  }
}

// ---- chance

namespace {

bool same_shape(const Surface& a, const Surface& b) {
  return a.points == b.points && a.ends == b.ends && a.normals == b.normals;
}

std::vector<std::array<uint32_t, 3>> runs_of(const Surface& surface) {
  std::vector<std::array<uint32_t, 3>> runs;
  for (const Surface::Run& run : surface.runs) runs.push_back({run.symbol, run.material, run.end});
  return runs;
}

}  // namespace

TEST_CASE("another seed changes what depends on chance and nothing else") {
  const std::string house =
      "style A { Plot { FOOTPRINT -> extrude(6) comp { side : FACADE | top : ROOF } }"
      " Facade { var Wide = 1.2  FACADE -> repeat(\"X\", 2) { TILE }"
      " TILE -> subdiv(\"X\", 1r, Wide, 1r) { WALL | detrude(0.1) { WINDOW | WALL } | WALL } }"
      " Materials { WINDOW : color(\"red\") : 1 LOOKS  WALL : texture(\"b.png\", 0.9) } }";
  const auto with = [&](const std::string& from, const std::string& to) {
    std::string text = house;
    text.replace(text.find(from), from.size(), to);
    return Script::text(text);
  };
  const Script plain = with("LOOKS", "");
  const Script painted = with("LOOKS", "color(\"blue\") : 1");
  std::string varied = house;
  varied.replace(varied.find("LOOKS"), 5, "");
  varied.replace(varied.find("Wide = 1.2"), 10, "Wide = rand(0.9, 1.3)");
  const Script wide = Script::text(varied);

  const Surface one = plain.derive("rect:20x12", {.seed = 1}).surface;
  bool differs = false, moves = false;
  for (uint64_t seed = 2; seed < 8; ++seed) {
    CAPTURE(seed);
    const Surface other = plain.derive("rect:20x12", {.seed = seed}).surface;
    CHECK(same_shape(one, other));
    CHECK(one.uvs == other.uvs);
    CHECK(runs_of(one) == runs_of(other));
    const Surface looks = painted.derive("rect:20x12", {.seed = seed}).surface;
    CHECK(same_shape(one, looks));  // chance in Materials moves nothing
    CHECK(one.uvs == looks.uvs);
    differs =
        differs || runs_of(painted.derive("rect:20x12", {.seed = 1}).surface) != runs_of(looks);
    const Building drawn_wide = wide.derive("rect:20x12", {.seed = seed});
    const auto parts = by_symbol(wide, drawn_wide),
               plain_parts = by_symbol(plain, plain.derive("rect:20x12"));
    CHECK(parts.at("ROOF") == plain_parts.at("ROOF"));
    moves = moves || parts.at("WINDOW") != plain_parts.at("WINDOW");
  }
  CHECK(differs);
  CHECK(moves);
}
