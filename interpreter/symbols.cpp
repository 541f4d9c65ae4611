// Which names are symbols: those that have rules or entries, or are emitted somewhere.
#include <algorithm>
#include <cctype>

#include "interpreter/compiler.hpp"

namespace mansard {

void Compiler::collect_symbols() {
  known_symbols_.insert("NIL");
  for (const syntax::Style* style : library_.styles()) {
    for (const syntax::StyleMember& member : style->members) {
      if (const auto* abstract = std::get_if<syntax::AbstractSymbol>(&member))
        known_symbols_.insert(abstract->name.text);
      const auto* block = std::get_if<syntax::Block>(&member);
      if (!block) continue;
      for (const auto& entry : block->elements) known_symbols_.insert(entry.symbol.text);
      for (const auto& entry : block->materials) known_symbols_.insert(entry.symbol.text);
      for (const syntax::BlockItem& item : block->items) {
        if (const auto* abstract = std::get_if<syntax::AbstractSymbol>(&item))
          known_symbols_.insert(abstract->name.text);
        if (const auto* rule = std::get_if<syntax::Rule>(&item)) {
          known_symbols_.insert(rule->name.text);
          collect(rule->successor);
        }
      }
    }
  }
}

void Compiler::collect(const syntax::Body& body) {
  const auto collect_parts = [this](const auto& self,
                                    const std::vector<syntax::Part>& parts) -> void {
    for (const syntax::Part& part : parts) {
      collect(part.body);
      self(self, part.group);
    }
  };
  for (const syntax::Element& element : body) {
    if (const auto* emit = std::get_if<syntax::Emit>(&element.is)) {
      if (!find_operation(emit->name.text)) known_symbols_.insert(emit->name.text);
      if (emit->parts) collect_parts(collect_parts, emit->parts->parts);
    } else if (const auto* push = std::get_if<syntax::Push>(&element.is)) {
      collect(push->body);
    } else if (const auto* branch = std::get_if<syntax::If>(&element.is)) {
      for (const syntax::IfArm& arm : branch->arms) collect(arm.body);
    }
  }
}

/// A name in capitals, as terminals are written, or one that is a symbol elsewhere.
bool Compiler::looks_like_symbol(std::string_view name) const {
  if (known_symbols_.contains(name)) return true;
  return name.size() > 1 && std::ranges::all_of(name, [](unsigned char c) {
           return std::isupper(c) || std::isdigit(c) || c == '_';
         });
}

}  // namespace mansard
