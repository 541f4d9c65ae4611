// Weathered models: one picture of stains however many buildings, and walls that stay as they are.
#include <doctest/doctest.h>

#include <algorithm>
#include <cstring>
#include <nlohmann/json.hpp>

#include "render/png.hpp"
#include "tests/cli/run.hpp"

namespace {

using namespace mansard::test;
using nlohmann::json;

const std::string root = MANSARD_ROOT;
const std::string script = root + "/examples/weathered.style";

std::size_t count_of(const std::string& text, const std::string& word) {
  std::size_t count = 0;
  for (std::size_t at = text.find(word); at != text.npos; at = text.find(word, at + 1)) ++count;
  return count;
}

/// The document of a .glb.
json document(const std::string& glb) {
  uint32_t length = 0;
  std::memcpy(&length, glb.data() + 12, 4);
  return json::parse(glb.substr(20, length));
}

Run derive(const std::string& out, std::vector<std::string> more = {}) {
  std::vector<std::string> words{"derive", script, "rect:9x8", "--quiet", "-o", out};
  words.insert(words.end(), more.begin(), more.end());
  return run(words);
}

std::size_t materials_named(const json& model, const std::string& name) {
  return static_cast<std::size_t>(
      std::ranges::count_if(model["materials"], [&](const json& m) { return m["name"] == name; }));
}

}  // namespace

TEST_CASE("a glb holds the stains' picture and material once") {
  const TemporaryFolder folder;
  const auto town = root + "/examples/quarter/footprints.geojson";
  for (const char* const limit : {"1", "12"}) {
    const Run made =
        run({"derive", script, town, "--limit", limit, "--quiet", "-o", folder / "a.glb"});
    REQUIRE_MESSAGE(made.status == 0, made.err);
    const std::string glb = contents(folder / "a.glb");
    const json model = document(glb);
    CHECK(count_of(glb, "\x89PNG") == 7);  // six of textures
    REQUIRE(materials_named(model, "stain") == 1);
    const auto stain = *std::ranges::find(
        model["materials"], "stain", [](const json& m) { return m["name"].get<std::string>(); });
    CHECK(stain["alphaMode"] == "BLEND");
    CHECK(stain["pbrMetallicRoughness"]["baseColorTexture"]["index"] == 6);
    CHECK(stain["pbrMetallicRoughness"]["baseColorFactor"][3] == 1);
    CHECK(stain["pbrMetallicRoughness"]["baseColorFactor"][0] < 0.05);
    CHECK(model["images"].size() == 7);
  }
}

TEST_CASE("the stains' picture stands beside an OBJ and a glTF") {
  const TemporaryFolder folder;
  REQUIRE(derive(folder / "b.obj").status == 0);
  REQUIRE(derive(folder / "c.gltf").status == 0);
  const std::string mtl = contents(folder / "b.mtl");
  CHECK(mtl.find("map_d b_stains.png\n") != mtl.npos);
  CHECK(mtl.find("map_Kd b_stains.png") == mtl.npos);
  CHECK(contents(folder / "c.gltf").find("c_stains.png") != std::string::npos);
  CHECK(contents(folder / "b_stains.png") == contents(root + "/styles/library/stains.png"));
  CHECK(contents(folder / "c_stains.png") == contents(folder / "b_stains.png"));
  CHECK(contents(folder / "b.obj").find("g STAIN\nusemtl stain\n") != std::string::npos);
}

TEST_CASE("stains are faces of their own: all else is as without") {
  const TemporaryFolder folder;
  REQUIRE(derive(folder / "old.obj").status == 0);
  REQUIRE(derive(folder / "new.obj", {"--set", "Weather.Stains=0"}).status == 0);
  REQUIRE(derive(folder / "coarse.obj", {"--lod", "2"}).status == 0);
  const std::string old = contents(folder / "old.obj"), clean = contents(folder / "new.obj");
  const std::size_t stains = old.find("g STAIN");
  REQUIRE(stains != old.npos);
  CHECK(clean.find("g STAIN") == clean.npos);
  CHECK(contents(folder / "coarse.obj").find("g STAIN") == std::string::npos);
  CHECK(count_of(old.substr(stains), "\nf ") > 20);
  CHECK(count_of(old, "\nf ") - count_of(old.substr(stains), "\nf ") == count_of(clean, "\nf "));
  CHECK(old.substr(stains).find("g ", 1) == std::string::npos);
}

TEST_CASE("what can not show stains leaves them out") {
  const TemporaryFolder folder;
  const std::vector<std::string> clean{"--set", "Weather.Stains=0"};
  for (const std::string ending : {".ply", ".stl"}) {
    REQUIRE(derive(folder / ("old" + ending)).status == 0);
    REQUIRE(derive(folder / ("new" + ending), clean).status == 0);
    CHECK(contents(folder / ("old" + ending)) == contents(folder / ("new" + ending)));
  }
}

/// The mean of how much the pictures' bytes differ.
double difference(const mansard::Picture& a, const mansard::Picture& b) {
  REQUIRE(a.rgb.size() == b.rgb.size());
  REQUIRE(!a.rgb.empty());
  double sum = 0;
  for (std::size_t i = 0; i < a.rgb.size(); ++i) sum += std::abs(int(a.rgb[i]) - int(b.rgb[i]));
  return sum / static_cast<double>(a.rgb.size());
}

TEST_CASE("a model that is read is drawn with its stains") {
  const TemporaryFolder folder;
  const auto picture = [&](std::vector<std::string> words) {
    words.insert(words.begin(), "render");
    words.insert(words.end(), {"--size", "240x160", "--camera", "-9,4,9,0,3,0", "--quiet", "-o",
                               folder / "picture.png"});
    const Run drawn = run(words);
    REQUIRE_MESSAGE(drawn.status == 0, drawn.err);
    return mansard::read_picture(folder / "picture.png");
  };
  const std::vector<std::string> clean{"--set", "Weather.Stains=0"};
  const double derived =
      difference(picture({script, "rect:9x8"}), picture({script, "rect:9x8", clean[0], clean[1]}));
  CHECK(derived > 0.5);
  for (const std::string ending : {".obj", ".gltf", ".glb"}) {
    CAPTURE(ending);
    REQUIRE(derive(folder / ("old" + ending)).status == 0);
    REQUIRE(derive(folder / ("new" + ending), clean).status == 0);
    const double read =
        difference(picture({folder / ("old" + ending)}), picture({folder / ("new" + ending)}));
    CHECK(read == doctest::Approx(derived).epsilon(0.05));
  }
}

TEST_CASE("a model without stains does not speak of them") {
  const TemporaryFolder folder;
  REQUIRE(derive(folder / "new.obj", {"--set", "Weather.Stains=0"}).status == 0);
  CHECK(contents(folder / "new.mtl").find("stain") == std::string::npos);
  CHECK(!std::filesystem::exists(folder / "new_stains.png"));
}

TEST_CASE("the report counts the faces that are stained") {
  const TemporaryFolder folder;
  const auto stains = [&](std::vector<std::string> more) {
    more.insert(more.end(), {"--report", folder / "report.json"});
    REQUIRE(derive(folder / "a.obj", more).status == 0);
    return json::parse(contents(folder / "report.json"))["stains"].get<std::size_t>();
  };
  const std::size_t drawn = stains({});
  const std::string old = contents(folder / "a.obj");
  CHECK(drawn == count_of(old.substr(old.find("g STAIN")), "\nf "));
  CHECK(stains({"--set", "Weather.Stains=0"}) == 0);
}

TEST_CASE("stains are the same on any number of threads") {
  const TemporaryFolder folder;
  const auto town = root + "/examples/quarter/footprints.geojson";
  for (const char* const threads : {"1", "3"})
    REQUIRE(run({"derive", script, town, "--limit", "9", "--threads", threads, "--quiet", "-o",
                 folder / (std::string(threads) + ".glb")})
                .status == 0);
  CHECK(contents(folder / "1.glb") == contents(folder / "3.glb"));
}

TEST_CASE("mansard stains makes the picture that is shipped, and others") {
  const TemporaryFolder folder;
  const Run made = run({"stains", "-o", folder / "stains.png"});
  CHECK(made.status == 0);
  CHECK(made.err == "stains: " + (folder / "stains.png") + "\n");
  CHECK(made.out.empty());
  CHECK(contents(folder / "stains.png").starts_with("\x89PNG\r\n"));
  CHECK(run({"stains", "--seed", "7", "--quiet", "-o", folder / "seven.png"}).err.empty());
  CHECK(contents(folder / "seven.png") != contents(folder / "stains.png"));
  CHECK(run({"stains", "-o", folder / "stains.jpg"}).status == 2);
  CHECK(run({"stains"}).status == 2);
  CHECK(run({"stains", "-o", folder / "nowhere/stains.png"}).status == 1);
  CHECK(files_in(folder) == 2);

  // One beside the script is taken instead of the library's.
  const std::string own =
      written(folder, "own.style",
              "style A { Mass { FOOTPRINT -> stain(1) extrude(5) comp { side : "
              "subdiv(\"Y\", 3, 0.2, 1r) { WALL | extrude(0.1) { LEDGE } | WALL "
              "} } } }");
  REQUIRE(run({"derive", own, "rect:9x8", "--quiet", "-o", folder / "own.obj"}).status == 0);
  CHECK(contents(folder / "own_stains.png") == contents(folder / "stains.png"));
}
