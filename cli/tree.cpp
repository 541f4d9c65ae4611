// mansard tree
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "cli/remarks.hpp"
#include "cli/session.hpp"
#include "interpreter/messages.hpp"

namespace mansard {
namespace {

struct Tree {
  const Program& program;
  const std::vector<TreeNode>& nodes;
  std::vector<std::vector<uint32_t>> children;
  long long depth;

  Tree(const Program& p, const std::vector<TreeNode>& n, long long d)
      : program(p), nodes(n), children(n.size()), depth(d) {
    for (uint32_t i = 0; i < nodes.size(); ++i) {
      if (nodes[i].parent != Shape::none) children[nodes[i].parent].push_back(i);
    }
  }
  std::string symbol(uint32_t i) const {
    return std::string(program.symbols[nodes[i].shape.symbol]);
  }

  /// Depth-first, without recursion: f(node, level).
  template <class F>
  void walk(uint32_t root, F f) const {
    std::vector<std::pair<uint32_t, long long>> stack{{root, 0}};
    while (!stack.empty()) {
      const auto [i, level] = stack.back();
      stack.pop_back();
      f(i, level);
      if (level + 1 >= depth) continue;
      for (auto c = children[i].rbegin(); c != children[i].rend(); ++c)
        stack.emplace_back(*c, level + 1);
    }
  }
};

std::string number(double v) {
  char text[32];
  std::snprintf(text, sizeof text, "%.6g", std::abs(v) < 1e-9 ? 0.0 : v);
  return text;
}

std::string_view form_name(Form form) {
  constexpr std::string_view names[] = {"nothing", "line",  "rectangle", "polygon",
                                        "box",     "prism", "mesh"};
  return names[static_cast<int>(form)];
}

std::string line_of(const Tree& tree, uint32_t i) {
  const Shape& s = tree.nodes[i].shape;
  std::string line = tree.symbol(i);
  if (!std::isnan(s.index)) line += "[" + number(s.index) + "]";
  line += "  " + number(s.scope.size.x) + " x " + number(s.scope.size.y) + " x " +
          number(s.scope.size.z);
  if (s.style != tree.program.main_style)
    line += "  (" + std::string(tree.program.styles[s.style].name) + ")";
  return line;
}

void print_text(const Tree& tree, uint32_t root) {
  tree.walk(root, [&](uint32_t i, long long level) {
    std::printf("%*s%s\n", static_cast<int>(2 * level), "", line_of(tree, i).c_str());
  });
}

void print_dot(const Tree& tree, const std::vector<uint32_t>& roots) {
  std::printf("digraph shapes {\n  node [shape=box, fontname=\"sans-serif\"];\n");
  for (const uint32_t root : roots) {
    tree.walk(root, [&](uint32_t i, long long level) {
      std::printf("  n%u [label=\"%s\"];\n", i, line_of(tree, i).c_str());
      if (level > 0) std::printf("  n%u -> n%u;\n", tree.nodes[i].parent, i);
    });
  }
  std::printf("}\n");
}

void print_json(const Tree& tree, const std::vector<uint32_t>& roots) {
  auto all = nlohmann::ordered_json::array();
  for (const uint32_t root : roots) {
    tree.walk(root, [&](uint32_t i, long long level) {
      const TreeNode& node = tree.nodes[i];
      const Vec3 o = node.shape.scope.origin, s = node.shape.scope.size;
      nlohmann::ordered_json json{{"node", i},
                                  {"symbol", tree.symbol(i)},
                                  {"terminal", node.terminal},
                                  {"form", form_name(node.shape.form)},
                                  {"size", {s.x, s.y, s.z}},
                                  {"origin", {o.x, o.y, o.z}},
                                  {"style", tree.program.styles[node.shape.style].name}};
      json["parent"] =
          level > 0 ? nlohmann::ordered_json(node.parent) : nlohmann::ordered_json(nullptr);
      if (!std::isnan(node.shape.index)) json["index"] = node.shape.index;
      if (node.shape.label != Shape::none) json["label"] = tree.program.symbols[node.shape.label];
      all.push_back(std::move(json));
    });
  }
  std::printf("%s\n",
              all.dump(1, ' ', false, nlohmann::ordered_json::error_handler_t::replace).c_str());
}

/// The lines that a split saw, and which of them it has a boundary at.
void print_snapping(const Tree& tree, const Snapping& snapping) {
  const auto used = std::ranges::count(snapping.lines, true, &Snapping::Line::used);
  std::printf("  %s (node %u): %s snaps to %zu of %s\n", tree.symbol(snapping.node).c_str(),
              snapping.node, snapping.split.c_str(), static_cast<std::size_t>(used),
              count_text(snapping.lines.size(), "line").c_str());
  for (const Snapping::Line& line : snapping.lines) {
    std::printf("    %s m%s: %s\n", number(line.at).c_str(), line.used ? "" : ", not taken",
                line.by.c_str());
  }
}

/// What was asked, answered and why, round by round.
void print_rounds(const Tree& tree, const Building& building) {
  if (building.rounds.empty()) std::printf("nothing was asked\n");
  for (std::size_t i = 0; i < building.rounds.size(); ++i) {
    const Round& round = building.rounds[i];
    std::printf("round %zu, stage %d: %s waited\n", i + 1, round.stage,
                count_text(round.shapes, "shape").c_str());
    for (const Answer& answer : round.answers) {
      std::printf("  %s (node %u): %s is %s%s%s\n", tree.symbol(answer.node).c_str(), answer.node,
                  answer.asked.c_str(), answer.answer.c_str(), answer.why.empty() ? "" : ", by ",
                  answer.why.c_str());
    }
    for (const Snapping& snapping : round.snappings) print_snapping(tree, snapping);
  }
}

nlohmann::ordered_json to_json(const Tree& tree, const Answer& answer) {
  return {{"node", answer.node},
          {"symbol", tree.symbol(answer.node)},
          {"asked", answer.asked},
          {"answer", answer.answer},
          {"by", answer.why}};
}

nlohmann::ordered_json to_json(const Tree& tree, const Snapping& snapping) {
  auto lines = nlohmann::ordered_json::array();
  for (const Snapping::Line& line : snapping.lines)
    lines.push_back({{"at", line.at}, {"taken", line.used}, {"by", line.by}});
  return {{"node", snapping.node},
          {"symbol", tree.symbol(snapping.node)},
          {"split", snapping.split},
          {"lines", lines}};
}

void print_rounds_json(const Tree& tree, const Building& building) {
  auto all = nlohmann::ordered_json::array();
  for (const Round& round : building.rounds) {
    auto answers = nlohmann::ordered_json::array();
    for (const Answer& answer : round.answers) answers.push_back(to_json(tree, answer));
    auto snaps = nlohmann::ordered_json::array();
    for (const Snapping& snapping : round.snappings) snaps.push_back(to_json(tree, snapping));
    all.push_back(
        {{"stage", round.stage}, {"shapes", round.shapes}, {"answers", answers}, {"snaps", snaps}});
  }
  std::printf("%s\n",
              all.dump(1, ' ', false, nlohmann::ordered_json::error_handler_t::replace).c_str());
}

/// "exactly 1.2 m", "0.6 to 2 m, 1.2 preferred".
std::string natural_text(const NaturalSize& natural) {
  if (natural.minimum == natural.maximum) return "exactly " + number(natural.preferred) + " m";
  const std::string most = natural.maximum < NaturalSize::unbounded
                               ? number(natural.minimum) + " to " + number(natural.maximum) + " m"
                               : "at least " + number(natural.minimum) + " m";
  return most + ", " + number(natural.preferred) + " preferred";
}

/// What came of the sizes ':', split by split.
void print_sizes(const Tree& tree, const Building& building) {
  if (building.measures.empty()) std::printf("no size ':' was measured\n");
  for (const MeasuredPart& measured : building.measures) {
    std::printf("%s (node %u): part %zu of %s along %c needs %s, got %s m\n",
                tree.symbol(measured.node).c_str(), measured.node, measured.part + 1,
                std::string(measured.split.text()).c_str(), letter_of(measured.axis),
                natural_text(measured.natural).c_str(), number(measured.got).c_str());
  }
}

void print_sizes_json(const Tree& tree, const Building& building) {
  auto all = nlohmann::ordered_json::array();
  for (const MeasuredPart& measured : building.measures) {
    const NaturalSize& natural = measured.natural;
    nlohmann::ordered_json json{{"node", measured.node},
                                {"symbol", tree.symbol(measured.node)},
                                {"operation", measured.split.text()},
                                {"axis", std::string(1, letter_of(measured.axis))},
                                {"part", measured.part},
                                {"minimum", natural.minimum},
                                {"preferred", natural.preferred}};
    json["maximum"] = natural.maximum < NaturalSize::unbounded
                          ? nlohmann::ordered_json(natural.maximum)
                          : nlohmann::ordered_json(nullptr);
    json["got"] = measured.got;
    all.push_back(std::move(json));
  }
  std::printf("%s\n",
              all.dump(1, ' ', false, nlohmann::ordered_json::error_handler_t::replace).c_str());
}

/// The topmost shapes of a symbol.
std::vector<uint32_t> roots_of(const Tree& tree, const std::string& symbol) {
  std::vector<uint32_t> roots;
  std::vector<bool> covered(tree.nodes.size(), false);
  for (uint32_t i = 0; i < tree.nodes.size(); ++i) {  // parents come before their children
    const uint32_t parent = tree.nodes[i].parent;
    covered[i] = parent != Shape::none && covered[parent];
    if (!covered[i] && tree.symbol(i) == symbol) {
      roots.push_back(i);
      covered[i] = true;
    }
  }
  return roots;
}

int tree(Session& session, const Arguments& arguments) {
  if (!session.compile(arguments.positional()[0], compile_options(arguments))) return exit_input;
  std::size_t broken = 0;
  const FootprintSet set = footprints(session, arguments.positional()[1], arguments, broken);
  if (set.footprints.empty()) {
    Diagnostic d;
    d.text = "there is no footprint to derive";
    throw Failure(std::move(d));
  }
  if (set.footprints.size() > 1) {
    session.say("note: the tree is of the first of " + std::to_string(set.footprints.size()) +
                " footprints, '" + set.footprints[0].id + "'; --select id=ID chooses another");
  }
  DeriveOptions options = derive_options(arguments, session.program());
  options.keep_tree = true;
  Derivation derivation(session.program(), session.meshes(), options);
  Building building;
  derivation.derive(set.footprints[0], building);
  Remarks remarks(session);
  remarks.add(building);
  remarks.finish(session.program());
  const Tree tree(session.program(), building.tree,
                  arguments.number("--depth", 1'000'000, 1, 1'000'000));
  if (arguments.has("--rounds")) {
    arguments.has("--json") ? print_rounds_json(tree, building) : print_rounds(tree, building);
    return exit_done;
  }
  if (arguments.has("--sizes")) {
    arguments.has("--json") ? print_sizes_json(tree, building) : print_sizes(tree, building);
    return exit_done;
  }
  std::vector<uint32_t> roots{0};
  if (const auto symbol = arguments.value("--symbol")) {
    roots = roots_of(tree, *symbol);
    if (roots.empty()) {
      Diagnostic d;
      d.text = "no shape of symbol '" + *symbol + "' was derived";
      throw Failure(std::move(d));
    }
  }
  if (arguments.has("--json")) {
    print_json(tree, roots);
  } else if (arguments.has("--dot")) {
    print_dot(tree, roots);
  } else {
    for (const uint32_t root : roots) print_text(tree, root);
  }
  return exit_done;
}

}  // namespace

int run_tree(const Arguments& arguments) {
  Session session(arguments);
  return session.guard([&] { return tree(session, arguments); });
}

}  // namespace mansard
