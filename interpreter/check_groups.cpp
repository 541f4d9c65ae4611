// Misspelt words in what is asked of groups and of alternatives.
#include <algorithm>

#include "interpreter/compiler.hpp"
#include "interpreter/messages.hpp"

namespace mansard {

/// A constant text that names no symbol of any style.
void Compiler::check_symbol_word(ExprId id, std::string_view what) {
  const ExprNode& node = program_.nodes[id];
  if (node.kind != ExprKind::constant) return;
  const Value& word = program_.constants[node.first];
  if (word.type != Type::string || known_symbols_.contains(word.string())) return;
  const std::vector<std::string_view> known(known_symbols_.begin(), known_symbols_.end());
  const std::string help = meant(word.string(), known);
  refuse(program_.spans[id], "no rule emits a symbol \"" + std::string(word.string()) + "\"",
         help.empty() ? std::string(what) : help);
}

void Compiler::check_group(ExprId id) {
  const ExprNode& node = program_.nodes[id];
  const Function& function = functions()[node.aux];
  const ExprId each = program_.children[node.children];
  const Type wanted =
      function.parameters[0].type == ArgType::boolean ? Type::boolean : Type::number;
  const auto type = static_type(each);
  if (type && *type != wanted) {
    refuse(program_.spans[each],
           "'" + std::string(function.name) + "' expects " + std::string(described(wanted)) +
               " of each shape, not " + std::string(described(*type)),
           function.name == "group.count" ? "group.count(true) is how many there are" : "");
  }
  if (node.count > 1)
    check_symbol_word(program_.children[node.children + 1],
                      "the symbol of an ancestor of the group");
}

void Compiler::check_outcome(ExprId id) {
  const ExprNode& node = program_.nodes[id];
  const ExprId argument = program_.children[node.children];
  if (functions()[node.aux].name == "made") return check_symbol_word(argument, "a terminal's name");
  const auto text = [&](ExprId of) -> std::optional<std::string_view> {
    const ExprNode& n = program_.nodes[of];
    if (n.kind != ExprKind::constant || program_.constants[n.first].type != Type::string)
      return std::nullopt;
    return program_.constants[n.first].string();
  };
  const auto key = text(argument);
  if (!key) return;
  std::vector<std::string_view> known;
  for (const Call& call : program_.calls) {
    if (call.operation->name != "report") continue;
    const auto reported = text(call.args[0].value);
    if (!reported || *reported == *key) return;
    known.push_back(*reported);
  }
  refuse(program_.spans[argument], "no report() has the key \"" + std::string(*key) + "\"",
         meant(*key, known));
}

}  // namespace mansard
