// W015: a name that hides another one of the same spelling.
#include <algorithm>

#include "interpreter/lint/linting.hpp"

namespace mansard {

namespace {

std::string quoted(std::string_view text) { return "'" + std::string(text) + "'"; }

class Shadows {
 public:
  Shadows(Linting& linting, const syntax::Style& style, const LinkedStyle& linked)
      : linting_(linting), style_(style), linked_(linked) {}

  void warn() {
    for (const VariableBinding& v : linked_.variables) {
      is_symbol(v);
      if (!v.block.empty()) hides(v, linked_.find_variable({}, v.name), "variable");
    }
    for (const FunctionBinding& f : linked_.functions) {
      if (!f.block.empty()) hides(f, linked_.find_function({}, f.name), "function");
    }
    for (const syntax::StyleMember& member : style_.members) {
      if (const auto* function = std::get_if<syntax::Function>(&member)) check(*function, {});
      if (const auto* block = std::get_if<syntax::Block>(&member)) check(*block);
    }
  }

 private:
  /// Said of the member that this style adds; where it adds neither, a parent's check has said it.
  template <class Binding>
  void hides(const Binding& inner, const Binding* outer, const std::string& noun) {
    if (!outer) return;
    const bool is_inner = inner.from.style == &style_, is_outer = outer->from.style == &style_;
    if (is_inner && inner.overrides.empty()) {
      complain(inner.syntax->name,
               noun + " " + quoted(inner.name) + " of block " + quoted(inner.block) +
                   " hides the style's " + noun,
               outer->syntax->name.at);
    } else if (is_outer && outer->overrides.empty() && !is_inner) {
      complain(outer->syntax->name,
               "block " + quoted(inner.block) + " has a " + noun + " " + quoted(inner.name) +
                   " of its own, which hides this one",
               inner.syntax->name.at);
    }
  }

  /// `var Infill` beside rules for Infill: where it stands as a symbol, the rules are meant.
  void is_symbol(const VariableBinding& v) {
    const SymbolRules* const rules = linked_.find_symbol(v.name);
    if (!rules || v.from.style != &style_ || !v.overrides.empty()) return;
    complain(v.syntax->name,
             "variable " + quoted(v.name) +
                 " bears the name of a symbol with rules: where it stands "
                 "as a symbol, the rules are taken",
             rules->generations.front().productions.front()->name.at);
  }

  void check(const syntax::Block& block) {
    for (const syntax::BlockItem& item : block.items) {
      if (const auto* function = std::get_if<syntax::Function>(&item)) {
        check(*function, block.name.text);
      }
      const auto* rule = std::get_if<syntax::Rule>(&item);
      if (!rule) continue;
      for (const syntax::Name& name : rule->params) parameter(name, block.name.text, true);
      const auto* bound = rule->index ? std::get_if<syntax::Reference>(&rule->index->is) : nullptr;
      if (bound && bound->names.size() == 1) parameter(bound->names[0], block.name.text, true);
    }
  }

  void check(const syntax::Function& function, std::string_view block) {
    for (const syntax::Name& name : function.params) parameter(name, block, false);
  }

  void parameter(const syntax::Name& name, std::string_view block, bool of_rule) {
    const VariableBinding* hidden = linked_.find_variable(block, name.text);
    if (!hidden) hidden = linked_.find_variable({}, name.text);
    if (hidden) {
      return complain(
          name,
          "parameter " + quoted(name.text) + " hides the variable " +
              (hidden->block.empty() ? "of the style" : "of block " + quoted(hidden->block)),
          hidden->syntax->name.at);
    }
    const SymbolRules* const rules = of_rule ? linked_.find_symbol(name.text) : nullptr;
    if (!rules) return;
    complain(name, "parameter " + quoted(name.text) + " hides the symbol of that name",
             rules->generations.front().productions.front()->name.at);
  }

  void complain(const syntax::Name& name, std::string text, Span hidden) {
    if (!linting_.here(name.at) || is_explained(name.at)) return;
    linting_.warn("W015", name.at, std::move(text), "give one of them another name",
                  {{"the other one is here", hidden}});
  }

  /// A variable that is not read at all has been told so.
  bool is_explained(Span at) const {
    return std::ranges::any_of(linting_.diagnostics.all(),
                               [&](const Diagnostic& d) { return d.at == at; });
  }

  Linting& linting_;
  const syntax::Style& style_;
  const LinkedStyle& linked_;
};

}  // namespace

void warn_of_shadows(Linting& linting) {
  for (const syntax::Style& style : linting.file.styles) {
    if (const LinkedStyle* const linked = linting.linked(style)) {
      Shadows(linting, style, *linked).warn();
    }
  }
}

}  // namespace mansard
