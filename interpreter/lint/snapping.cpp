// W027: an axis snaps, and nothing records a plane for it.
#include <algorithm>
#include <array>
#include <set>

#include "interpreter/axes.hpp"
#include "interpreter/lint/linting.hpp"
#include "interpreter/operation.hpp"

namespace mansard {

namespace {

/// What a style's derivation can come to: splits that snap, and what gives them planes. A shape is
/// taken to lie flat, so that extrude makes a mass of it, unless `comp` took it as a wall.
class Planes {
 public:
  Planes(const Program& program, uint16_t style)
      : program_(program), style_(style), seen_{marks(), marks()} {
    const uint32_t start = program.styles[style].start;
    expand(start, true, true);
    while (!pending_.empty()) {
      const auto [symbol, flat] = pending_.back();
      pending_.pop_back();
      expand(symbol, flat, false);
    }
  }

  /// No snap(), and one mass at most.
  bool none_at_all() const { return !given_ && masses_ < 2; }
  const std::set<const Call*>& splits() const { return splits_; }

 private:
  std::vector<bool> marks() const { return std::vector<bool>(program_.symbols.size(), false); }

  void expand(uint32_t symbol, bool flat, bool once) {
    for (uint32_t s = program_.styles[style_].rules[symbol]; s != none;) {
      const RuleSet& rules = program_.rule_sets[s];
      for (uint32_t i = rules.first; i < rules.first + rules.count; ++i)
        body(program_.productions[i].body, flat, once && rules.count == 1);
      s = rules.super;
    }
  }

  void body(BodyId id, bool flat, bool once) {
    const Body body = program_.bodies[id];
    for (uint32_t i = body.first; i < body.first + body.count; ++i)
      step(program_.steps[i], flat, once);
  }

  void step(const Step& step, bool flat, bool once) {
    switch (step.kind) {
      case StepKind::emit:
        if (step.style != 0xffff || step.style_of != none) given_ = true;  // who knows
        push(step.what, flat);
        break;
      case StepKind::emit_value:
        given_ = true;
        break;
      case StepKind::operation:
        call(program_.calls[step.what], flat, once);
        break;
      case StepKind::push:
        body(step.what, flat, once);
        break;
      case StepKind::branch:
        for (const BranchArm& arm : program_.branches[step.what].arms) body(arm.body, flat, false);
        break;
      case StepKind::super:
        break;
    }
  }

  void call(const Call& call, bool flat, bool once) {
    const std::string_view name = call.operation->name;
    const bool mass = name == "extrude" || name == "box";
    if (name == "snap") given_ = true;
    if (mass && flat) masses_ += once ? 1 : 2;
    const ExprNode* axis = call.args.empty() || call.args[0].value == none
                               ? nullptr
                               : &program_.nodes[call.args[0].value];
    if (axis && axis->kind == ExprKind::constant &&
        call.operation->find_parameter("tolerance") < call.operation->count) {
      const Value& word = program_.constants[axis->first];
      if (word.type == Type::string && is_snapping_axis(word.string())) splits_.insert(&call);
    }
    parts(call, call.parts, flat, once && mass);
  }

  void parts(const Call& call, const std::vector<CallPart>& list, bool flat, bool once) {
    for (const CallPart& part : list) {
      if (part.group.empty()) body(part.body, flat && !is_wall(call, part), once);
      parts(call, part.group, flat, false);
    }
  }

  /// A part of `comp` that takes faces which stand.
  bool is_wall(const Call& call, const CallPart& part) const {
    static constexpr std::array<std::string_view, 12> walls{
        "side",  "facades",  "sidefaces", "front", "back",   "left",
        "right", "vertical", "party",     "court", "street", "main"};
    if (call.operation->rule != PartRule::selectors) return false;
    std::string_view word = part.name == none ? std::string_view() : program_.symbols[part.name];
    if (call.args[0].value != none) {
      const ExprNode& node = program_.nodes[call.args[0].value];
      if (node.kind != ExprKind::constant || program_.constants[node.first].type != Type::string)
        return false;
      word = program_.constants[node.first].string();
    }
    return std::find(walls.begin(), walls.end(), word) != walls.end();
  }

  void push(uint32_t symbol, bool flat) {
    if (seen_[flat][symbol]) return;
    seen_[flat][symbol] = true;
    pending_.emplace_back(symbol, flat);
  }

  const Program& program_;
  uint16_t style_;
  std::array<std::vector<bool>, 2> seen_;  ///< symbols, upright and flat
  std::vector<std::pair<uint32_t, bool>> pending_;
  std::set<const Call*> splits_;
  bool given_ = false;
  int masses_ = 0;
};

}  // namespace

void warn_of_snapping(Linting& linting) {
  const Program& program = linting.program;
  if (!program.snaps) return;
  std::set<const Call*> lost, met;
  const auto styles = static_cast<uint16_t>(program.styles.size());
  for (uint16_t style = 0; style < styles; ++style) {
    if (!linting.reach.live(style)) continue;
    const Planes planes(program, style);
    (planes.none_at_all() ? lost : met).insert(planes.splits().begin(), planes.splits().end());
  }
  for (const Call& call : program.calls) {
    if (!lost.contains(&call) || met.contains(&call)) continue;
    const Span at = program.spans[call.args[0].value];
    if (!linting.here(at)) continue;
    linting.warn("W027", at, "nothing records a plane for this axis to snap to",
                 "snap(\"YZ\") records the left and right of a shape, snap(\"XZ\") its lower and "
                 "upper end");
  }
}

}  // namespace mansard
