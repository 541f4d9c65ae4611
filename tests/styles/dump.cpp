#include "tests/styles/dump.hpp"

#include "styles/complaint.hpp"

namespace mansard {

namespace {

/// The user's text on one line.
std::string one_line(Span at) {
  std::string line;
  for (const char c : at.text()) {
    const bool space = c == ' ' || c == '\n' || c == '\t';
    if (!space) {
      line += c;
    } else if (!line.empty() && line.back() != ' ') {
      line += ' ';
    }
  }
  return line;
}

std::string place(const Origin& from) {
  std::string text(from.style->name.text);
  if (from.block) text.append(".").append(from.block->name.text);
  return text;
}

std::string dump(const SymbolRules& symbol) {
  std::string text = "rule " + std::string(symbol.name) + "\n";
  const char* lead = "  ";
  for (const Generation& generation : symbol.generations) {
    for (std::size_t i = 0; i < generation.productions.size(); ++i) {
      text += lead + place(generation.origins[i]) + ": " + one_line(generation.productions[i]->at) +
              "\n";
    }
    lead = "  super ";
  }
  return text;
}

std::string dump(const VariableBinding& variable) {
  std::string text = "var ";
  if (!variable.block.empty()) text += std::string(variable.block) + ".";
  text += std::string(variable.name) + " = ";
  text += variable.syntax->value ? one_line(variable.syntax->value->at) : "abstract";
  text += " from " + place(variable.from);
  const char* lead = ", hides ";
  for (const Origin& hidden : variable.overrides) {
    text += lead + place(hidden);
    lead = ", ";
  }
  return text + "\n";
}

std::string dump(const FunctionBinding& function) {
  return "def " + (function.block.empty() ? "" : std::string(function.block) + ".") +
         std::string(function.name) + ": " + one_line(function.syntax->at) + " from " +
         place(function.from) + "\n";
}

template <class Binding>
std::string dump_list(const char* kind, const Binding& binding) {
  std::string text = kind + std::string(binding.symbol) + "\n";
  for (const auto& choice : binding.alternatives) {
    text += "  " + one_line(choice.syntax->at) + " from " +
            std::string(choice.from.style->name.text) + "\n";
  }
  return text;
}

}  // namespace

std::string dump_head(const LinkedStyle& style) {
  return "style " + std::string(style.name()) + "\norder " + listed(style.order) + "\n";
}

std::string dump_body(const LinkedStyle& style) {
  std::string text = "start " + std::string(style.start);
  if (style.seed) text += "\nseed " + std::to_string(*style.seed);
  text += "\nblocks";
  for (const std::string_view block : style.blocks) text.append(" ").append(block);
  text += "\n";
  for (const auto& variable : style.variables) text += dump(variable);
  for (const auto& function : style.functions) text += dump(function);
  for (const auto& symbol : style.symbols) text += dump(symbol);
  for (const auto& binding : style.elements) text += dump_list("element ", binding);
  for (const auto& binding : style.materials) {
    text += dump_list("material ", binding);
    if (binding.entry->per) text += "  per " + one_line(binding.entry->per->at) + "\n";
  }
  return text;
}

std::string dump(Diagnostics& diagnostics) {
  diagnostics.sort();
  std::string text;
  for (const Diagnostic& diagnostic : diagnostics.all()) text += to_text(diagnostic);
  return text;
}

}  // namespace mansard
