#include "cli/lsp/known_value.hpp"

#include <cmath>

#include "interpreter/messages.hpp"

namespace mansard::lsp {

namespace {

class Reckoning {
 public:
  Reckoning(const Meanings& meanings, const syntax::Style& style)
      : meanings_(meanings), style_(style) {}

  std::optional<double> variable(std::string_view block, std::string_view name) {
    constexpr int deepest = 50;
    const Meaning meaning{Kind::variable, block, name, &style_, nullptr};
    const auto found = meanings_.definition(meaning);
    if (found.empty() || depth_ >= deepest) return std::nullopt;
    const auto* declared = std::get_if<const syntax::Variable*>(&found.front()->declares);
    if (!declared || !(*declared)->value) return std::nullopt;
    ++depth_;
    const auto value = of(*(*declared)->value, block);
    --depth_;
    return value;
  }

 private:
  std::optional<double> of(const syntax::Expr& expr, std::string_view block) {
    if (const auto* number = std::get_if<syntax::Number>(&expr.is)) return number->value;
    if (const auto* chain = std::get_if<syntax::Chain>(&expr.is)) return of_chain(*chain, block);
    if (const auto* unary = std::get_if<syntax::Unary>(&expr.is)) {
      auto value = of(*unary->operand, block);
      for (const syntax::Prefix prefix : unary->operators) {
        if (prefix != syntax::Prefix::minus || !value) return std::nullopt;
        value = -*value;
      }
      return value;
    }
    const auto* reference = std::get_if<syntax::Reference>(&expr.is);
    if (!reference || reference->style) return std::nullopt;
    if (reference->names.size() == 2)
      return variable(reference->names[0].text, reference->names[1].text);
    const std::string_view name = reference->names[0].text;
    const Meaning own{Kind::variable, block, name, &style_, nullptr};
    return variable(meanings_.definition(own).empty() ? std::string_view{} : block, name);
  }

  std::optional<double> of_chain(const syntax::Chain& chain, std::string_view block) {
    std::optional<double> left = of(*chain.operands[0], block);
    for (std::size_t i = 0; left && i < chain.operators.size(); ++i) {
      const std::optional<double> right = of(*chain.operands[i + 1], block);
      if (!right) return std::nullopt;
      switch (chain.operators[i]) {
        case syntax::Infix::add:
          *left += *right;
          break;
        case syntax::Infix::subtract:
          *left -= *right;
          break;
        case syntax::Infix::multiply:
          *left *= *right;
          break;
        case syntax::Infix::divide:
          *left /= *right;
          break;
        default:
          return std::nullopt;
      }
    }
    return left;
  }

  const Meanings& meanings_;
  const syntax::Style& style_;
  int depth_ = 0;
};

}  // namespace

std::optional<std::string> known_value(const Meanings& meanings, const Meaning& variable) {
  if (variable.kind != Kind::variable || !variable.style) return std::nullopt;
  const auto found = meanings.definition(variable);
  if (found.empty()) return std::nullopt;
  const auto* declared = std::get_if<const syntax::Variable*>(&found.front()->declares);
  if (!declared || !(*declared)->value ||
      std::holds_alternative<syntax::Number>((*declared)->value->is))
    return std::nullopt;
  const auto value = Reckoning(meanings, *variable.style).variable(variable.block, variable.name);
  if (!value || !std::isfinite(*value)) return std::nullopt;
  return number_text(*value);
}

}  // namespace mansard::lsp
