#include "interpreter/placeable.hpp"

#include <algorithm>
#include <array>
#include <string_view>

#include "interpreter/function.hpp"
#include "interpreter/operation.hpp"
#include "interpreter/program.hpp"

namespace mansard {
namespace {

/// Operations that look at nothing but their shape and leave nothing but shapes.
constexpr std::array<std::string_view, 26> flat{
    "subdiv", "repeat",          "split",  "comp",  "detrude", "offset",  "setback",  "chamfer",
    "shapeL", "shapeU",          "shapeO", "cut",   "quad",    "t",       "r",        "s",
    "center", "inner_rectangle", "align",  "pivot", "color",   "texture", "material", "uv",
    "stain"};
/// The same, but they make solids, which enter the world of a style that asks.
constexpr std::array<std::string_view, 12> solid{"extrude", "taper",    "roof",     "upright",
                                                 "insert",  "box",      "cylinder", "sphere",
                                                 "cone",    "occluder", "label",    "set"};

/// Walks the rules of every symbol once.
class Walk {
 public:
  explicit Walk(const Program& program)
      : program_(program),
        symbols_(program.symbols.size()),
        nodes_(program.nodes.size(), Known::open),
        pairs_(program.styles.size() * symbols_) {}

  std::vector<std::vector<bool>> run() {
    for (uint32_t pair = 0; pair < pairs_.size(); ++pair) {
      walk(static_cast<uint16_t>(pair / symbols_), static_cast<uint32_t>(pair % symbols_));
    }
    spread();
    want_what_varies_above();
    std::vector<std::vector<bool>> found(program_.styles.size(), std::vector<bool>(symbols_));
    for (uint32_t pair = 0; pair < pairs_.size(); ++pair) {
      const Pair& p = pairs_[pair];
      if (!p.barred && p.divides && p.wanted && !leads_to_itself(pair))
        found[pair / symbols_][pair % symbols_] = true;
    }
    return found;
  }

 private:
  enum class Known : uint8_t { open, free, barred };
  /// A symbol in a style.
  struct Pair {
    bool barred = false, divides = false;
    bool draws = false;   ///< one of several productions
    bool wanted = false;  ///< it comes several times, or what it comes of is not copied as a whole
    std::vector<uint32_t> next;  ///< pairs that its rules emit
  };

  void walk(uint16_t style, uint32_t symbol) {
    const uint32_t rule_set = program_.styles[style].rules[symbol];
    if (rule_set == none) return;
    style_ = style;
    at_ = &pairs_[pair_of(style, symbol)];
    for (uint32_t set = rule_set; set != none; set = program_.rule_sets[set].super) {
      const RuleSet& rules = program_.rule_sets[set];
      at_->barred |= rules.waits;
      for (uint32_t i = 0; i < rules.count; ++i) {
        const Production& p = program_.productions[rules.first + i];
        for (const ExprId e : {p.guard, p.index_test, p.probability}) read(e);
        at_->draws |= p.probability != none;
        body(p.body);
      }
    }
    std::ranges::sort(at_->next);
    at_->next.erase(std::unique(at_->next.begin(), at_->next.end()), at_->next.end());
  }

  void body(BodyId id) {
    const Body& b = program_.bodies[id];
    for (uint32_t i = b.first; i < b.first + b.count; ++i) step(program_.steps[i]);
  }

  void step(const Step& s) {
    read(s.index);
    for (uint32_t i = 0; i < s.argument_count; ++i) read(program_.arguments[s.arguments + i]);
    switch (s.kind) {
      case StepKind::emit:
        if (s.style_of != none) at_->barred = true;  // a style that is not known before
        if (s.what == nil_symbol) return;
        at_->next.push_back(pair_of(s.style == 0xffff ? style_ : s.style, s.what));
        pairs_[at_->next.back()].wanted |= several_;
        return;
      case StepKind::emit_value:
        at_->barred = true;
        return;
      case StepKind::operation:
        return call(program_.calls[s.what]);
      case StepKind::push:
        return body(s.what);
      case StepKind::super:
        return;
      case StepKind::branch:
        for (const BranchArm& arm : program_.branches[s.what].arms) {
          read(arm.condition);
          body(arm.body);
        }
    }
  }

  void call(const Call& c) {
    const auto is_of = [&](const auto& names) {
      return std::ranges::find(names, c.operation->name) != names.end();
    };
    if (!is_of(flat) && (program_.asks || !is_of(solid))) at_->barred = true;
    at_->divides |= c.has_parts;
    for (const SizeExpr& arg : c.args) read(arg.value);
    const bool outside = several_;
    several_ = several_ || c.parts_repeat || c.starred ||
               c.operation->rule == PartRule::selectors ||
               (c.operation->is_split && c.operation->rule == PartRule::body);
    for (const CallPart& p : c.parts) part(p);
    several_ = outside;
  }

  void part(const CallPart& p) {
    read(p.size.value);
    for (const CallPart& inner : p.group) part(inner);
    if (p.group.empty()) body(p.body);
  }

  void read(ExprId id) {
    if (id != none && !free(id)) at_->barred = true;
  }

  bool free(ExprId id) {
    if (nodes_[id] == Known::open) {
      nodes_[id] = Known::free;  // a function that calls itself
      nodes_[id] = looks_at_shape_only(program_.nodes[id]) ? Known::free : Known::barred;
    }
    return nodes_[id] == Known::free;
  }

  bool looks_at_shape_only(const ExprNode& n) {
    const auto all = [&](const auto& args) {
      return std::ranges::all_of(
          args, [&](const SizeExpr& e) { return e.value == none || free(e.value); });
    };
    switch (n.kind) {
      case ExprKind::attribute: {
        const auto a = static_cast<Attribute>(n.aux);
        return a != Attribute::tx && a != Attribute::ty && a != Attribute::tz &&
               a != Attribute::elevation;
      }
      case ExprKind::variable: {
        const ExprId value = program_.variables[n.first].value;
        if (value != none && !free(value)) return false;
        break;
      }
      case ExprKind::definition:
        if (!free(program_.functions[n.first].value)) return false;
        break;
      case ExprKind::fits: {
        const Call& c = program_.calls[n.first];
        if (!all(c.args) || !std::ranges::all_of(c.parts, [&](const CallPart& p) {
              return p.size.value == none || free(p.size.value);
            }))
          return false;
        break;
      }
      case ExprKind::call:
        if (functions()[n.aux].asks != Asks::nothing) return false;
        break;
      default:
        break;
    }
    for (uint32_t i = 0; i < n.count; ++i) {
      if (!free(program_.children[n.children + i])) return false;
    }
    return true;
  }

  /// What leads to a barred symbol is barred.
  void spread() {
    for (bool changed = true; changed;) {
      changed = false;
      for (Pair& p : pairs_) {
        if (p.barred || std::ranges::none_of(p.next, [&](uint32_t n) { return pairs_[n].barred; }))
          continue;
        p.barred = changed = true;
      }
    }
  }

  /// Below what is not copied as a whole, parts of it may be.
  void want_what_varies_above() {
    for (const Pair& p : pairs_) {
      if (!p.barred && !p.draws) continue;
      for (const uint32_t next : p.next) pairs_[next].wanted = true;
    }
  }

  uint32_t pair_of(uint16_t style, uint32_t symbol) const {
    return static_cast<uint32_t>(style * symbols_ + symbol);
  }

  bool leads_to_itself(uint32_t pair) const {
    std::vector<uint32_t> reached{pair};
    for (std::size_t i = 0; i < reached.size(); ++i) {
      for (const uint32_t next : pairs_[reached[i]].next) {
        if (next == pair) return true;
        if (std::ranges::find(reached, next) == reached.end()) reached.push_back(next);
      }
    }
    return false;
  }

  const Program& program_;
  std::size_t symbols_;
  std::vector<Known> nodes_;
  std::vector<Pair> pairs_;  ///< by style, then symbol
  uint16_t style_ = 0;
  Pair* at_ = nullptr;
  bool several_ = false;  ///< what is emitted here may come several times
};

}  // namespace

std::vector<std::vector<bool>> placeable_symbols(const Program& program) {
  if (program.snaps)
    return std::vector(program.styles.size(), std::vector<bool>(program.symbols.size()));
  return Walk(program).run();
}

}  // namespace mansard
