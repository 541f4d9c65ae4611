// W026: a symbol is emitted with an index that none of its productions takes.
#include "interpreter/indices.hpp"
#include "interpreter/lint/linting.hpp"
#include "interpreter/lint/walk.hpp"

namespace mansard {
namespace {

/// Looks at what one style's rules emit.
class Indices {
 public:
  explicit Indices(Linting& linting) : linting_(linting) {}

  void step(const Step& step) {
    if (step.kind != StepKind::emit || step.index == none || step.style_of != none) return;
    const Program& program = linting_.program;
    const ExprNode& node = program.nodes[step.index];
    const Span at = program.spans[step.index];
    if (node.kind != ExprKind::constant || !linting_.here(at)) return;
    const CompiledStyle& under = program.styles[step.style == 0xffff ? style_ : step.style];
    const uint32_t set = under.rules[step.what];
    const double index = program.constants[node.first].number;
    if (set == none || takes_index(program, program.rule_sets[set], index)) return;
    Diagnostic d = untaken_index(program, program.rule_sets[set], index);
    if (!told_.insert(at.begin).second) return;
    if (linting_.program.styles.size() > 1)
      d.notes.push_back({"in style '" + std::string(under.name) + "'", {}});
    linting_.warn("W026", at, d.text, d.help, d.notes);
  }
  void expression(ExprId) {}

  void look_through(uint16_t style) {
    style_ = style;
    const Program& program = linting_.program;
    for (uint32_t symbol = 0; symbol < program.symbols.size(); ++symbol) {
      const uint32_t set = program.styles[style].rules[symbol];
      if (set != none && linting_.reach.reached(style, symbol)) walk_rules(program, set, *this);
    }
  }

 private:
  Linting& linting_;
  uint16_t style_ = 0;
  std::set<uint32_t> told_;  ///< by place in the script
};

}  // namespace

void warn_of_indices(Linting& linting) {
  Indices indices(linting);
  const auto styles = static_cast<uint16_t>(linting.program.styles.size());
  for (uint16_t style = 0; style < styles; ++style) {
    if (linting.reach.live(style)) indices.look_through(style);
  }
}

}  // namespace mansard
