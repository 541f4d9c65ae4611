// Which models derive writes: formats, levels of detail, instances.
#include <doctest/doctest.h>
#include <sys/resource.h>

#include <array>
#include <cstdlib>
#include <nlohmann/json.hpp>

#include "tests/cli/run.hpp"

namespace {

using namespace mansard::test;
using nlohmann::json;

const std::string root = MANSARD_ROOT;

/// CPU seconds of all programs that were run so far.
double child_seconds() {
  rusage usage{};
  getrusage(RUSAGE_CHILDREN, &usage);
  return double(usage.ru_utime.tv_sec + usage.ru_stime.tv_sec) +
         1e-6 * double(usage.ru_utime.tv_usec + usage.ru_stime.tv_usec);
}

std::string box(double x, double y, double z, double w, double h, double d, int& points) {
  std::string text;
  for (int i = 0; i < 8; ++i)
    text += "v " + std::to_string(i & 1 ? x + w : x) + " " + std::to_string(i & 2 ? y + h : y) +
            " " + std::to_string(i & 4 ? z + d : z) + "\n";
  for (const auto& face : {"0 2 3 1", "4 5 7 6", "0 1 5 4", "2 6 7 3", "0 4 6 2", "1 3 7 5"}) {
    text += "f";
    for (const char* c = face; *c != 0; c += c[1] != 0 ? 2 : 1)
      text += " " + std::to_string(points + *c - '0' + 1);
    text += "\n";
  }
  points += 8;
  return text;
}

/// A frame with bars, `panes` wide and high: 12 faces a pane, and 18.
std::string window(int panes) {
  int points = 0;
  std::string text = box(0, 0, 0, 1, 1.5, 0.02, points);
  for (int i = 0; i <= panes; ++i) {
    text += box(0.95 * i / panes, 0, 0, 0.05, 1.5, 0.08, points);
    text += box(0, 1.45 * i / panes, 0, 1, 0.05, 0.08, points);
  }
  return text;
}

/// 10 x 10 m each: 25 windows in each of four facades.
std::string plots(int count) {
  std::string text = "{\"type\":\"FeatureCollection\",\"features\":[";
  for (int i = 0; i < count; ++i) {
    const auto at = [&](int dx, int dy) {
      return "[" + std::to_string(20 * (i % 20) + dx) + "," + std::to_string(20 * (i / 20) + dy) +
             "]";
    };
    text += std::string(i == 0 ? "" : ",") +
            "{\"type\":\"Feature\",\"properties\":{},\"geometry\":{\"type\":\"Polygon\","
            "\"coordinates\":[[" +
            at(0, 0) + "," + at(10, 0) + "," + at(10, 10) + "," + at(0, 10) + "," + at(0, 0) +
            "]]}}";
  }
  return text + "],\"crs\":{\"type\":\"name\",\"properties\":{\"name\":\"EPSG:25833\"}}}";
}

constexpr auto block_style = R"(style Block {
    Mass   { FOOTPRINT -> extrude(15) { comp { side : FACADE | top : ROOF } } }
    Facade { FACADE -> repeat("Y", 3) { FLOOR }   FLOOR -> repeat("X", 2) { TILE } }
    Tile {
        TILE   -> subdiv("X", 1r, 1, 1r) { WALL | MIDDLE | WALL }
        MIDDLE -> subdiv("Y", 0.9, 1.5, 1r) { WALL | WINDOW | WALL }
    }
    Elements { WINDOW : "w1.obj" | "w2.obj" | "w3.obj" | "w4.obj" | "w5.obj" }
})";

/// Masses upon masses, with relief on their walls.
constexpr auto towers = R"(style Tower {
    Mass {
        FOOTPRINT -> extrude(8) { Podium }
        Podium    -> comp { side : FACADE | top : Deck }
        Deck      -> offset(4) { Base | ROOF }
        Base      -> extrude(30) { Shaft }
        Shaft     -> comp { side : FACADE | top : ROOF }
    }
    Relief { FACADE -> subdiv("Y", 1r, 0.5) { WALL | extrude(0.2) { LEDGE } } }
}
style Jettied {
    Mass {
        FOOTPRINT -> Storey(3)
        Storey(n) -> extrude(2.8) { Walls(n) }
        Walls(n)  -> comp { side : FACADE | top : Next(n - 1) }
        Next(n) : n > 0 -> offset(-0.4) { Storey(n) | SOFFIT }
        Next(n) : else  -> ROOF
    }
    Relief { FACADE -> subdiv("Y", 1r, 0.3) { WALL | extrude(0.1) { BEAM } } }
})";

/// Least and greatest x, y, z of an .obj's points.
std::array<double, 6> extent(const std::string& obj) {
  std::array<double, 6> box{1e9, 1e9, 1e9, -1e9, -1e9, -1e9};
  for (std::size_t at = 0; (at = obj.find("\nv ", at)) != std::string::npos; ++at) {
    const char* from = obj.c_str() + at + 3;
    for (std::size_t i = 0; i < 3; ++i) {
      char* end = nullptr;
      const double value = std::strtod(from, &end);
      from = end;
      box[i] = std::min(box[i], value);
      box[i + 3] = std::max(box[i + 3], value);
    }
  }
  return box;
}

}  // namespace

TEST_CASE("towers on podiums and jettied storeys keep their mass without relief") {
  const TemporaryFolder folder;
  const std::string style = written(folder, "towers.style", towers);
  struct Expected {
    std::string style;
    std::array<double, 6> masses, first;
    double walls;  ///< square metres, ledges left out
  };
  const std::array<Expected, 2> all{
      Expected{"Tower", {0, 0, -24, 30, 38, 0}, {0, 0, -24, 30, 8, 0}, 108 * 8 + 76 * 30},
      Expected{"Jettied",
               {-0.8, 0, -8.8, 10.8, 8.4, 0.8},
               {0, 0, -8, 10, 2.8, 0},
               (36 + 39.2 + 42.4) * 2.8}};
  for (const auto& [name, masses, first, walls] : all) {
    CAPTURE(name);
    const Run result = run({"derive", style, name == "Tower" ? "rect:30x24" : "rect:10x8",
                            "--style", name, "--lod", "all", "-o", folder / "t.obj", "--quiet"});
    REQUIRE_MESSAGE(result.status == 0, result.err);
    const auto coarse = extent(contents(folder / "t_lod2.obj"));
    const auto block = extent(contents(folder / "t_lod1.obj"));
    for (std::size_t i = 0; i < 6; ++i) {
      CHECK(coarse[i] == doctest::Approx(masses[i]));
      CHECK(block[i] == doctest::Approx(first[i]));
    }
    CHECK(run({"derive", style, name == "Tower" ? "rect:30x24" : "rect:10x8", "--style", name,
               "--lod", "2", "-o", folder / "t.obj", "--report", folder / "r.json", "--quiet"})
              .status == 0);
    const json report = json::parse(contents(folder / "r.json"))["terminals"];
    double area = 0;
    for (const char* const symbol : {"WALL", "LEDGE", "BEAM"})
      if (report.contains(symbol)) area += report[symbol]["area"].get<double>();
    CHECK(area == doctest::Approx(walls));
  }
}

TEST_CASE("a block of 20,000 windows of five kinds takes a fraction of its copies' room") {
  const TemporaryFolder folder;
#ifdef __SANITIZE_ADDRESS__
  constexpr int houses = 20;
#else
  constexpr int houses = 200;
#endif
  for (int i = 1; i <= 5; ++i) written(folder, "w" + std::to_string(i) + ".obj", window(i));
  const std::string style = written(folder, "block.style", block_style);
  const std::string footprints = written(folder, "plots.geojson", plots(houses));
  const auto derived = [&](const std::string& instancing, double& seconds) {
    const std::string model = folder / (instancing + ".glb");
    const double before = child_seconds();
    const Run result = run({"derive", style, footprints, "-o", model, "--instancing", instancing,
                            "--report", folder / "report.json", "--quiet"});
    seconds = child_seconds() - before;
    REQUIRE_MESSAGE(result.status == 0, result.err);
    const json report = json::parse(contents(folder / "report.json"));
    CHECK(report["terminals"]["WINDOW"]["count"] == 100 * houses);
    return std::filesystem::file_size(model);
  };
  double copying = 0, sharing = 0, instancing = 0;
  const auto copies = derived("none", copying);
  const auto nodes = derived("nodes", sharing), gpu = derived("gpu", instancing);
  MESSAGE("copies ", copies, " bytes in ", copying, " s; nodes ", nodes, " in ", sharing, "; gpu ",
          gpu, " in ", instancing);
  CHECK(nodes * 100 <= copies * 15);
  CHECK(gpu < nodes);
#ifndef __SANITIZE_ADDRESS__  // where most is the program's start
  CHECK(sharing < copying);   // half of it
  CHECK(instancing < copying);
#endif
}

TEST_CASE("--lod all writes a chain, and the report has each level's faces and vertices") {
  const TemporaryFolder folder;
  for (const std::string building : {"Building1", "Building2"}) {
    CAPTURE(building);
    const Run result =
        run({"derive", root + "/styles/library/listings.style", "rect:10x8", "--style", building,
             "--attr", "height=5", "--lod", "all", "-o", "town.v1.obj", "--report", "report.json"},
            folder.path());
    REQUIRE_MESSAGE(result.status == 0, result.err);
    CHECK(result.err.find("town.v1_lod1.obj") != std::string::npos);
    const json levels = json::parse(contents(folder / "report.json"))["levels"];
    REQUIRE(levels.size() == 3);
    for (int i = 0; i < 3; ++i) {
      CHECK(levels[i]["lod"] == 3 - i);
      const std::string path = levels[i]["model"];
      CHECK(path == "town.v1_lod" + std::to_string(3 - i) + ".obj");
      const std::string text = contents(folder / path);
      std::size_t faces = 0, points = 0;
      for (std::size_t at = 0; at != std::string::npos; at = text.find('\n', at + 1)) {
        faces += text.compare(at, 3, "\nf ") == 0;
        points += text.compare(at, 3, "\nv ") == 0;
      }
      CHECK(levels[i]["polygons"] == faces);
      CHECK(levels[i]["vertices"] == points);
      CHECK(std::filesystem::exists(folder / (path.substr(0, path.size() - 4) + ".mtl")));
    }
    CHECK(levels[1]["polygons"].get<int>() * 2 <= levels[0]["polygons"].get<int>());
    CHECK(levels[2]["polygons"] == 6);  // the footprint's prism
  }
  CHECK(files_in(folder) == 7);
}

TEST_CASE("a chain is whole or not there, and a footprint that fails is in none of it") {
  const TemporaryFolder folder;
  const std::string style = written(folder, "fails.style", R"(style Fails {
    Mass { FOOTPRINT : W > 15 -> fail("too wide")   FOOTPRINT : else -> extrude(3) MASS }
})");
  const std::string footprints = written(folder, "two.obj",
                                         "o a\nv 0 0 0\nv 9 0 0\nv 9 0 -9\nv 0 0 -9\nf 1 2 3 4\n"
                                         "o b\nv 20 0 0\nv 39 0 0\nv 39 0 -9\nv 20 0 -9\n"
                                         "f 5 6 7 8\n");
  const Run stopped = run({"derive", style, footprints, "--lod", "all", "-o", folder / "t.glb"});
  CHECK(stopped.status == 1);
  CHECK(files_in(folder) == 2);
  const Run kept = run({"derive", style, footprints, "--lod", "all", "-o", folder / "t.glb",
                        "--keep-going", "--report", folder / "r.json"});
  CHECK(kept.status == 1);
  CHECK(kept.err.find("1 footprint was left out") != std::string::npos);
  CHECK(kept.err.find("error:") == kept.err.rfind("error:"));
  CHECK(files_in(folder) == 2 + 3 + 1);
  const json report = json::parse(contents(folder / "r.json"));
  CHECK(report["levels"].size() == 3);
  for (const json& level : report["levels"]) CHECK(level["polygons"] == 6);
}

TEST_CASE("PLY and STL are written by their endings") {
  const TemporaryFolder folder;
  const std::string style = root + "/examples/first_house.style";
  for (const std::string name : {"a.ply", "a.stl"}) {
    const Run result = run({"derive", style, "rect:10x8", "-o", folder / name, "--up", "z"});
    CHECK_MESSAGE(result.status == 0, result.err);
  }
  CHECK(contents(folder / "a.ply").starts_with("ply\n"));
  const std::string stl = contents(folder / "a.stl");
  REQUIRE(stl.size() > 84);
  CHECK((stl.size() - 84) % 50 == 0);
}

TEST_CASE("flags that say nothing to a format are refused before the work") {
  const TemporaryFolder folder;
  const auto said = [&](std::vector<std::string> words) {
    words.insert(words.begin(), {"derive", root + "/examples/first_house.style", "rect:10x8"});
    const Run result = run(words, folder.path());
    CHECK(result.status == 2);
    CHECK(files_in(folder) == 0);
    return result.err;
  };
  CHECK(said({"-o", "x.fbx"})
            .find("'x.fbx' has no ending that is written: .obj, .glb, .gltf, .ply or .stl") !=
        std::string::npos);
  CHECK(said({"-o", "x.obj", "--instancing", "gpu"})
            .find("--instancing is for .glb and .gltf: .obj has no word for it") !=
        std::string::npos);
  CHECK(said({"-o", "x.stl", "--compress", "draco"})
            .find("--compress is for .glb and .gltf: .stl has no word for it") !=
        std::string::npos);
  CHECK(said({"-o", "x.glb", "--instancing", "all"})
            .find("--instancing takes nodes, gpu or none, not 'all'") != std::string::npos);
  CHECK(said({"-o", "x.glb", "--compress", "zip"})
            .find("--compress takes none or draco, not 'zip'") != std::string::npos);
  CHECK(said({"-o", "x.glb", "--lod", "0"}).find("--lod takes 1, 2, 3 or all, not '0'") !=
        std::string::npos);
  CHECK(said({"-o", "x.glb", "--up", "z"}).find("glTF is always y up") != std::string::npos);
  const Run missing = run({"derive", root + "/examples/first_house.style", "rect:10x8", "-o",
                           folder / "none/x.ply", "--lod", "all"});
  CHECK(missing.status == 1);
  CHECK(missing.err.find("can not write") != std::string::npos);
  CHECK(missing.err.find("make the folder first") != std::string::npos);
}
