// How the program behaves as a program: help, JSON, files, threads.
#include <doctest/doctest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <sstream>

#include "interpreter/function.hpp"
#include "interpreter/operation.hpp"
#include "tests/cli/run.hpp"

namespace {

using mansard::test::contents;
using mansard::test::files_in;
using mansard::test::Run;
using mansard::test::run;
using mansard::test::TemporaryFolder;
using mansard::test::written;
using nlohmann::json;

const std::string root = MANSARD_ROOT;
const std::string box = root + "/bench/facade_box.style";
const std::string listings = root + "/styles/library/listings.style";

}  // namespace

TEST_CASE("a model appears whole or not at all") {
  const TemporaryFolder folder;
  const std::string fails = written(folder, "fails.style",
                                    "style A { Plot { FOOTPRINT : area > 50 -> fail(\"too large\") "
                                    "  FOOTPRINT : else -> PLOT } }");
  const std::string plots =
      "WKT:MULTIPOLYGON(((0 0,4 0,4 4,0 4,0 0)),((10 0,30 0,30 9,10 9,10 0)))";
  const std::string model = folder / "model.obj";
  const Run all = run({"derive", fails, plots, "-o", model});
  CHECK(all.status == 1);
  CHECK(files_in(folder) == 1);
  written(folder, "model.obj", "what was here before");
  CHECK(run({"derive", fails, plots, "-o", model}).status == 1);
  CHECK(contents(model) == "what was here before");
  CHECK(files_in(folder) == 2);
  const Run going = run(
      {"derive", fails, plots, "-o", model, "--keep-going", "--report", folder / "report.json"});
  CHECK(going.status == 1);
  CHECK(going.err.find("too large") != std::string::npos);
  const json report = json::parse(contents(folder / "report.json"));
  CHECK(report["buildings"] == 1);
  CHECK(report["failed"].size() == 1);
  CHECK(contents(model).find("f ") != std::string::npos);
  CHECK(run({"derive", box, "rect:10x8", "-o", folder / "no/such/folder/model.obj"}).status == 1);
}

TEST_CASE("small footprints are left out when asked, before party walls are found") {
  const TemporaryFolder folder;
  const std::string houses =
      "WKT:MULTIPOLYGON(((0 0,10 0,10 10,0 10,0 0)),((10 0,20 0,20 10,10 10,10 0)),"
      "((20 0,22 0,22 2,20 2,20 0)))";
  const auto report = [&](const std::vector<std::string>& flags, const std::string& err) {
    std::vector<std::string> words{
        "derive", box, houses, "-o", folder / "model.obj", "--report", folder / "report.json"};
    words.insert(words.end(), flags.begin(), flags.end());
    const Run all = run(words);
    CHECK(all.status == 0);
    CHECK(all.err.find(err) != std::string::npos);
    return json::parse(contents(folder / "report.json"));
  };
  const json all = report({}, "3 buildings");
  CHECK(all["dropped_small"] == 0);
  CHECK(all["walls"] == 13);  // the shed's neighbour has two on its east side
  CHECK(all["party_walls"] == 4);
  const json large = report({"--drop-small"},
                            "1 footprint under 6.8 square metres, a tenth of the mean, left out");
  CHECK(large["buildings"] == 2);
  CHECK(large["dropped_small"] == 1);
  CHECK(large["walls"] == 8);
  CHECK(large["party_walls"] == 2);
  CHECK(report({"--drop-small", "--limit", "1"}, "1 building,")["party_walls"] == 1);
  const Run shed =
      run({"derive", box, houses, "--drop-small", "--select", "id=0:3", "-o", folder / "shed.obj"});
  CHECK(shed.status == 1);
  CHECK(shed.err.find("'0:3' has less than a tenth of the mean area") != std::string::npos);
}

TEST_CASE("the same bytes on one thread and on two") {
  const TemporaryFolder folder;
  const std::string quarter = root + "/examples/quarter/";
  const auto derive = [&](const std::string& name, const std::string& threads) {
    CHECK(run({"derive", quarter + "quarter.style", quarter + "footprints.geojson", "--threads",
               threads, "--limit", "40", "--quiet", "--seed", "3", "-o", folder / name})
              .status == 0);
    std::string text = contents(folder / name);
    return text.substr(
        std::min(text.find("\no "), text.size()));  // after the head with its own name
  };
  const std::string one = derive("one.obj", "1"), two = derive("two.obj", "2");
  CHECK(one.size() > 100'000);
  CHECK(one == two);
  CHECK(one == derive("again.obj", "1"));
}

TEST_CASE("many small buildings, some of which fail, are the same on any number of threads") {
  const TemporaryFolder folder;
  const std::string script = written(
      folder, "some.style",
      "style A { Plot { FOOTPRINT : area > 50 -> fail(\"too large\") "
      "  FOOTPRINT : area > 20 -> print(area) color(\"red\") LAWN  FOOTPRINT : else -> PLOT } }");
  std::string plots = "WKT:MULTIPOLYGON(";
  for (int i = 0; i < 500; ++i) {
    const std::string west = std::to_string(20 * i), east = std::to_string(20 * i + 3 + i % 11);
    plots += (i == 0 ? "((" : ",((") + west + " 0," + east + " 0," + east + " 4," + west + " 4," +
             west + " 0))";
  }
  plots += ")";
  const auto derive = [&](const std::string& threads, std::vector<std::string> flags) {
    std::vector<std::string> words{"derive", script, plots,           "--threads",
                                   threads,  "-o",   folder / "m.obj"};
    words.insert(words.end(), flags.begin(), flags.end());
    const Run made = run(words);
    CHECK(made.status == 1);
    return made.err + (flags.empty() ? "" : contents(folder / "m.obj"));
  };
  const std::string first = derive("1", {}), all = derive("1", {"--keep-going"});
  CHECK(first.find("for footprint") == first.rfind("for footprint"));
  CHECK(first.find("for footprint '0:11'") != std::string::npos);
  CHECK(all.find("o 0:500\n") != std::string::npos);
  for (int i = 0; i < 5; ++i) {
    CHECK(derive("7", {}) == first);
    CHECK(derive("7", {"--keep-going"}) == all);
  }
}

TEST_CASE("the report's numbers agree with each other") {
  const TemporaryFolder folder;
  REQUIRE(run({"derive", box, "rect:10x8", "-o", folder / "model.obj", "--report",
               folder / "report.json"})
              .status == 0);
  const json report = json::parse(contents(folder / "report.json"));
  CHECK(report["buildings"] == 1);
  CHECK(report["failed"].empty());
  CHECK(report["polygons"] > 600);
  CHECK(report["vertices"] == 4 * report["polygons"].get<int>());
  CHECK(report["shapes"] > 650);
  CHECK(report["seconds"] > 0);
  std::size_t terminals = 0;
  double area = 0;
  for (const auto& [symbol, is] : report["terminals"].items()) {
    terminals += is["count"].get<std::size_t>();
    area += is["area"].get<double>();
  }
  CHECK(terminals == report["polygons"]);  // every terminal is one rectangle here
  const double windows = report["terminals"]["WINDOW"]["count"];
  CHECK(area == doctest::Approx(80 + 36 * 12 + windows * 2 * 0.1 * (0.75 + 1.5)));
  std::istringstream model(contents(folder / "model.obj"));
  std::size_t faces = 0;
  for (std::string line; std::getline(model, line);) faces += line.starts_with("f ");
  CHECK(faces == report["polygons"]);
}

TEST_CASE("diagnostics are JSON for machines") {
  const TemporaryFolder folder;
  const std::string bad = written(
      folder, "bad.style",
      "style A { Plot { FOOTPRINT -> extrud(3) A\n A -> subdiv(\"X\", 1, 1r) { B | B | B } } }");
  const Run check = run({"check", bad, "--json"});
  CHECK(check.status == 1);
  std::istringstream lines(check.err + check.out);
  std::size_t errors = 0;
  for (std::string line; std::getline(lines, line);) {
    const json diagnostic = json::parse(line, nullptr, false);
    REQUIRE_MESSAGE(!diagnostic.is_discarded(), line);
    errors += diagnostic["severity"] == "error";
  }
  CHECK(errors == 2);
}

TEST_CASE("with --json every line beside the results is JSON") {
  const TemporaryFolder folder;
  const Run derive = run({"derive", box, "rect:10x8", "--json", "-o", folder / "model.obj"});
  CHECK(derive.status == 0);
  std::istringstream lines(derive.err);
  int notes = 0;
  for (std::string line; std::getline(lines, line); ++notes) {
    CHECK(json::parse(line, nullptr, false).value("severity", "") == "note");
  }
  CHECK(notes > 0);
}

TEST_CASE("the tree as JSON and as a graph") {
  const Run tree = run({"tree", listings, "rect:10x8", "--attr", "height=5", "--json"});
  REQUIRE(tree.status == 0);
  const json nodes = json::parse(tree.out);
  CHECK(nodes[0]["symbol"] == "FOOTPRINT");
  CHECK(nodes[0]["parent"].is_null());
  CHECK(nodes[1]["symbol"] == "BuildingVol");
  CHECK(nodes[1]["size"][1] == 5);
  std::size_t terminals = 0;
  for (const json& node : nodes) terminals += node["terminal"].get<bool>();
  CHECK(terminals > 500);
  const Run graph = run({"tree", box, "rect:10x8", "--dot", "--depth", "3"});
  CHECK(graph.out.starts_with("digraph"));
  CHECK(graph.out.find("n0 -> n1") != std::string::npos);
  CHECK(std::ranges::count(graph.out, '{') == std::ranges::count(graph.out, '}'));
  const Run text = run({"tree", box, "rect:10x8", "--symbol", "FLOORS", "--depth", "1"});
  CHECK(text.out ==
        "FLOORS  10 x 9 x 0\nFLOORS  8 x 9 x 0\nFLOORS  10 x 9 x 0\nFLOORS  8 x 9 x 0\n");
}

TEST_CASE("the rounds of questions, as text and as JSON") {
  const std::string script = root + "/tests/golden/derive/rounds_stages.style";
  const Run text = run({"tree", script, "rect:10x8", "--rounds"});
  CHECK(text.status == 0);
  CHECK(text.out ==
        "round 1, stage 1: 1 shape waited\n"
        "  First (node 7): Shape.occ(\"noparent\") is none\n"
        "round 2, stage 2: 1 shape waited\n"
        "  Second (node 6): Shape.occ(\"noparent\") is part, by BAY (node 9)\n");
  const json rounds = json::parse(run({"tree", script, "rect:10x8", "--rounds", "--json"}).out);
  REQUIRE(rounds.size() == 2);
  CHECK(rounds[1]["stage"] == 2);
  CHECK(rounds[1]["answers"][0]["symbol"] == "Second");
  CHECK(rounds[1]["answers"][0]["answer"] == "part");
  CHECK(run({"tree", box, "rect:10x8", "--rounds"}).out == "nothing was asked\n");
}

TEST_CASE("what sizes ':' measured, as text and as JSON") {
  const TemporaryFolder folder;
  const std::string script = written(folder, "groups.style", R"(style Groups { Front {
    FOOTPRINT -> extrude(3) comp { front : FACADE }
    FACADE    -> subdiv("X", 6, :, :) { WALL | Elastic | Stiff }
    Elastic   -> subdiv("X", ~2, 0.5) { WALL | Stiff }
    Stiff     -> subdiv("X", 0.8) { WINDOW }
    WINDOW    -> repeat("X", :) { Pane }
    Pane      -> subdiv("X", ~0.2) { GLASS }
  } })");
  const Run text = run({"tree", script, "rect:8x8", "--sizes"});
  CHECK(text.status == 0);
  CHECK(
      text.out ==
      "FACADE (node 1): part 2 of subdiv along X needs at least 0.5 m, 2.5 preferred, got 1.2 m\n"
      "FACADE (node 1): part 3 of subdiv along X needs exactly 0.8 m, got 0.8 m\n"
      "WINDOW (node 7): part 1 of repeat along X needs at least 0 m, 0.2 preferred, got 0.166667 "
      "m\n"
      "WINDOW (node 14): part 1 of repeat along X needs at least 0 m, 0.2 preferred, got 0.2 m\n");
  const json sizes = json::parse(run({"tree", script, "rect:8x8", "--sizes", "--json"}).out);
  REQUIRE(sizes.size() == 4);
  CHECK(sizes[0]["symbol"] == "FACADE");
  CHECK(sizes[0]["part"] == 1);
  CHECK(sizes[0]["maximum"].is_null());
  CHECK(sizes[1]["maximum"] == 0.8);
  CHECK(run({"tree", box, "rect:10x8", "--sizes"}).out == "no size ':' was measured\n");
}

TEST_CASE("buildings that ask are the same on any number of threads") {
  const TemporaryFolder folder;
  const std::string script = written(folder, "ask.style", R"(style Ask {
    Mass   { FOOTPRINT -> extrude(BUILDING_HEIGHT) comp { side : FACADE | top : DECK } }
    Facade { FACADE -> [ s(1.5, 2, 0) extrude(rand(0.1, 1)) BAY ] repeat("X", 2) { TILE } }
    Tile   { TILE : Shape.occ("all") == "none" -> WINDOW  TILE : inside("neighbours") -> NIL  TILE : else -> WALL }
})");
  const auto derive = [&](const std::string& name, const std::string& threads) {
    const Run made = run({"derive", script, root + "/examples/quarter/footprints.geojson",
                          "--threads", threads, "--quiet", "-o", folder / name});
    CHECK_MESSAGE(made.status == 0, made.err);
    return contents(folder / name);
  };
  const std::string one = derive("one.obj", "1");
  CHECK(one.find("g WINDOW") != std::string::npos);
  CHECK(one.find("g WALL") != std::string::npos);
  for (const char* const threads : {"2", "7"}) {
    std::string more = derive("more.obj", threads);
    for (auto at = more.find("more."); at != std::string::npos; at = more.find("more.", at))
      more.replace(at, 4, "one");
    CHECK(more == one);
  }
}

TEST_CASE("the lines that splits snapped to, as text and as JSON") {
  const std::string script = root + "/tests/golden/derive/snap_tolerance.style";
  const std::string text = run({"tree", script, "rect:8x8", "--rounds"}).out;
  CHECK(
      text.starts_with("round 1, stage 1: 4 shapes waited\n"
                       "  FIRST (node 3): subdiv(\"XS\", 2.2, 2.5, 1r) snaps to 3 of 4 lines\n"
                       "    0 m: snap in RECORD (node 2)\n"
                       "    2 m: snap in RECORD (node 2)\n"
                       "    4 m, not taken: snap in RECORD (node 2)\n"
                       "    5 m: snap in RECORD (node 2)\n"));
  const json rounds = json::parse(run({"tree", script, "rect:8x8", "--rounds", "--json"}).out);
  const json& first = rounds[0]["snaps"][0];
  CHECK(first["symbol"] == "FIRST");
  CHECK(first["split"] == "subdiv(\"XS\", 2.2, 2.5, 1r)");
  CHECK(first["lines"][2] ==
        json{{"at", 4.0}, {"taken", false}, {"by", "snap in RECORD (node 2)"}});
  const std::string masses =
      run({"tree", root + "/tests/golden/derive/snap_masses.style", "rect:10x4", "--rounds"}).out;
  CHECK(masses.find("snaps to 2 of 2 lines\n    0 m: a face of LOW (node 2)\n") !=
        std::string::npos);
}

TEST_CASE("buildings that snap are the same on any number of threads") {
  const TemporaryFolder folder;
  const std::string script = written(folder, "snap.style", R"(style Snap {
    Mass   { FOOTPRINT -> [ extrude(BUILDING_HEIGHT) MASS ] s(50%, 100%, 50%) extrude(rand(3, 5)) MASS   MASS -> comp { side : FACADE } }
    Facade { FACADE -> subdiv("YS", 3, 1r) { repeat("X", rand(2, 3)) { snap("YZ") SHOP } | repeat("XS", 1.3) { TILE } }
             @stage(2) TILE -> subdiv("XS", 1r, 0.7, 1r) { WALL | PANE | WALL } }
})");
  const auto derive = [&](const std::string& name, const std::string& threads) {
    const Run made = run({"derive", script, root + "/examples/quarter/footprints.geojson",
                          "--threads", threads, "--quiet", "-o", folder / name});
    CHECK_MESSAGE(made.status == 0, made.err);
    return contents(folder / name);
  };
  const std::string one = derive("one.obj", "1");
  CHECK(one.find("g PANE") != std::string::npos);
  for (const char* const threads : {"2", "7"}) {
    std::string more = derive("more.obj", threads);
    for (auto at = more.find("more."); at != std::string::npos; at = more.find("more.", at))
      more.replace(at, 4, "one");
    CHECK(more == one);
  }
}

TEST_CASE("help knows every command, operation, function and topic") {
  std::vector<std::string> words{"derive",     "check",     "tree",     "render", "help",
                                 "operations", "functions", "warnings", "W001"};
  for (const mansard::Operation& o : mansard::operations()) words.emplace_back(o.name);
  for (const mansard::Function& f : mansard::functions()) words.emplace_back(f.name);
  const std::string overview = run({"help"}).out;
  std::istringstream topics(overview.substr(overview.find("Topics: ") + 8));
  for (std::string topic; topics >> topic && topic != "mansard";) words.push_back(topic);
  CHECK(words.size() > 70);
  for (const std::string& word : words) {
    CAPTURE(word);
    const Run help = run({"help", word});
    CHECK(help.status == 0);
    CHECK(help.err.empty());
    CHECK(help.out.size() > 40);
  }
  const json all = json::parse(run({"help", "--json"}).out, nullptr, false);
  CHECK_FALSE(all.is_discarded());
}
