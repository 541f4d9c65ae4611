// How the program behaves as a program: exit statuses, help, JSON, files, start-up time.
#include <doctest/doctest.h>
#include <sys/resource.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <sstream>

#include "interpreter/function.hpp"
#include "interpreter/operation.hpp"
#include "tests/cli/run.hpp"

namespace {

namespace fs = std::filesystem;
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

TEST_CASE("exit statuses: 0 done, 1 wrong input, 2 wrong usage") {
  const TemporaryFolder folder;
  const std::string bad =
      written(folder, "bad.style", "style A { Plot { FOOTPRINT -> extrud(3) A } }");
  CHECK(run({}).status == 0);
  CHECK(run({"help"}).status == 0);
  CHECK(run({"--version"}).status == 0);
  CHECK(run({"derive", "--help"}).status == 0);
  CHECK(run({"check", box}).status == 0);
  CHECK(run({"check", bad}).status == 1);
  CHECK(run({"check", folder / "none.style"}).status == 1);
  CHECK(run({"check"}).status == 2);
  CHECK(run({"chek", box}).status == 2);
  CHECK(run({"check", box, "--what"}).status == 2);
  CHECK(run({"derive", box}).status == 2);
  CHECK(run({"derive", box, "rect:10x8"}).status == 2);  // no -o
  CHECK(run({"derive", box, "rect:10x8", "-o", folder / "model.fbx"}).status == 2);
  CHECK(run({"derive", box, "rect:10x8", "-o", folder / "model.obj", "--up", "x"}).status == 2);
  CHECK(run({"derive", bad, "rect:10x8", "-o", folder / "model.obj"}).status == 1);
  CHECK(run({"tree", box, "rect:10by8"}).status == 1);
  CHECK(run({"tree", box, "rect:10x8", "--symbol", "NOTHING"}).status == 1);
  CHECK(run({"help", "nonsense"}).status != 0);
}

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

TEST_CASE("nothing that is read is written over, and no device replaced") {
  const TemporaryFolder folder;
  const char* const corners = "v 0 0 0\nv 0 0 9\nv 9 0 9\nv 9 0 0\nf 1 2 3 4\n";
  const std::string plot = written(folder, "plot.obj", corners);
  const std::string model = folder / "model.obj";
  CHECK(run({"derive", box, plot, "-o", plot}).status == 2);
  CHECK(run({"derive", box, plot, "-o", model, "--report", plot}).status == 2);
  CHECK(run({"derive", box, plot, "-o", model, "--report", model}).status == 2);
  CHECK(contents(plot) == corners);
  CHECK(files_in(folder) == 1);
  fs::create_symlink("/dev/full", folder / "full.json");
  const Run full = run({"derive", box, plot, "-o", model, "--report", folder / "full.json"});
  CHECK(full.status == 1);
  CHECK(full.err.find("No space left on device") != std::string::npos);
  CHECK(fs::is_character_file(folder / "full.json"));
  const std::string endless = written(
      folder, "endless.style", "style S { Plot { FOOTPRINT -> texture(\"/dev/zero\") PLOT } }");
  const Run zeros = run({"derive", endless, "rect:10x8", "-o", model});
  CHECK(zeros.status == 0);
  CHECK(zeros.err.find("W020") != std::string::npos);
}

TEST_CASE("variables that read others twice are checked at once and bounded where derived") {
  const auto doubling = [](const std::string& first) {
    std::string text = "style S { var v0 = " + first;
    for (int i = 1; i < 64; ++i) {
      const std::string before = "v" + std::to_string(i - 1);
      text += " var v" + std::to_string(i) + " = " + before + " + " + before;
    }
    return text + " Plot { FOOTPRINT -> extrude(v63 / 1e18) { MASS } } }";
  };
  const TemporaryFolder folder;
  const std::string once = written(folder, "once.style", doubling("1"));
  CHECK(run({"tree", once, "rect:10x8"}).status == 0);
  const std::string each = written(folder, "each.style", doubling("W"));
  CHECK(run({"check", each}).status == 0);
  const Run tree = run({"tree", each, "rect:10x8"});
  CHECK(tree.status == 1);
  CHECK(tree.err.find("more than 20 million calls") != std::string::npos);
}

TEST_CASE("what reaches beyond all measure is an error, not a model without numbers") {
  const TemporaryFolder folder;
  for (const char* const rule : {"s(1e200, 1e200, 1e200) sphere() BALL", "r(1e308, 1e308, 0) PLOT",
                                 "extrude(1e300) { MASS }", "t(1e300, 0, 0) PLOT"}) {
    const std::string text = std::string("style S { Plot { FOOTPRINT -> ") + rule + " } }";
    const std::string style = written(folder, "far.style", text);
    const Run far = run({"derive", style, "rect:10x8", "-o", folder / "far.obj"});
    CHECK_MESSAGE(far.status == 1, rule);
    CHECK_MESSAGE(far.err.find("reaches further than") != std::string::npos, far.err);
  }
}

TEST_CASE("results go where -o says and nowhere else") {
  const TemporaryFolder folder;
  const Run derive = run({"derive", box, "rect:10x8", "-o", folder / "model.obj"});
  CHECK(derive.status == 0);
  CHECK(derive.out.empty());
  CHECK(files_in(folder) == 2);  // and its .mtl
  CHECK(run({"derive", box, "rect:10x8", "-o", folder / "model.obj", "--quiet"}).err.empty());
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

TEST_CASE("an abstract style may hand arguments to what its heirs will give") {
  const Run check =
      run({"check", root + "/tests/golden/styles_run/abstract_with_parameters.style"});
  CHECK(check.status == 0);
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

TEST_CASE("a report that can not be written is said before the work") {
  const TemporaryFolder folder;
  const Run derive = run({"derive", box, "rect:10x8", "-o", folder / "model.obj", "--report",
                          folder / "none/report.json"});
  CHECK(derive.status == 1);
  CHECK(derive.err.find("none/report.json") != std::string::npos);
  CHECK(files_in(folder) == 0);
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

TEST_CASE("check takes 10 ms of the processor, three times that on a busy machine") {
  const auto spent = [] {
    rusage children{};
    getrusage(RUSAGE_CHILDREN, &children);
    const auto ms = [](timeval t) {
      return static_cast<double>(t.tv_sec) * 1e3 + static_cast<double>(t.tv_usec) / 1e3;
    };
    return ms(children.ru_utime) + ms(children.ru_stime);
  };
  std::vector<double> times;
  for (int i = 0; i < 9; ++i) {
    const double before = spent();
    CHECK(run({"check", listings}).status == 0);
    times.push_back(spent() - before);
  }
  std::ranges::sort(times);
  MESSAGE("median ", times[4], " ms");
#if !defined(__SANITIZE_ADDRESS__)
  CHECK(times[4] < 3 * 10);
#endif
}
