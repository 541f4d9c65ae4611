#include "dump.hpp"

#include <array>
#include <charconv>

namespace mansard {

using namespace syntax;  // NOLINT: this file is about them

namespace {

template <class... F>
struct Overload : F... {
  using F::operator()...;
};
template <class... F>
Overload(F...) -> Overload<F...>;

class Dumper {
 public:
  std::string out;

  void file(const File& file) {
    for (const Import& import : file.imports) line(0, "import", [&] { value(*import.path); });
    for (const Style& style : file.styles) this->style(style);
  }
  void value(const Expr& expr) {
    std::visit([&](const auto& is) { one(is); }, expr.is);
  }

 private:
  template <class Inside>
  void line(int depth, std::string_view head, Inside inside) {
    out.append(static_cast<std::size_t>(depth) * 2, ' ').append("(").append(head);
    inside();
    out.append(")\n");
  }
  void put(std::string_view word) { out.append(" ").append(word); }

  void preamble(const Preamble& pre) {
    for (const Span& doc : pre.docs) put("/" + std::string(doc.text()) + "/");
    for (const Annotation& annotation : pre.annotations) {
      put("@" + std::string(annotation.name.text));
      if (!annotation.args.empty()) args(annotation.args);
    }
    for (const Span& word : {pre.final, pre.override, pre.abstract}) {
      if (word) put(word.text());
    }
  }

  void style(const Style& style) {
    line(0, "style", [&] {
      preamble(style.pre);
      put(style.name.text);
      for (const Name& parent : style.parents) put(": " + std::string(parent.text));
    });
    for (const StyleMember& member : style.members) {
      std::visit([&](const auto& made) { this->member(made, 1); }, member);
    }
  }
  void member(const Start& start, int depth) {
    line(depth, "start", [&] { put(start.symbol.text); });
  }
  void member(const Block& block, int depth) {
    constexpr std::array kinds{"block", "elements", "materials"};
    line(depth, kinds[static_cast<std::size_t>(block.kind)], [&] {
      preamble(block.pre);
      if (block.replace) put("replace");
      put(block.name.text);
    });
    for (const BlockItem& item : block.items) {
      std::visit([&](const auto& made) { member(made, depth + 1); }, item);
    }
    for (const ElementEntry& entry : block.elements) member(entry, depth + 1);
    for (const MaterialEntry& entry : block.materials) member(entry, depth + 1);
  }
  void member(const Variable& made, int depth) {
    line(depth, "var", [&] {
      preamble(made.pre);
      put(made.name.text);
      if (made.value) value(*made.value);
    });
  }
  void member(const Function& made, int depth) {
    line(depth, "def", [&] {
      preamble(made.pre);
      put(made.name.text);
      names(made.params);
      value(*made.value);
    });
  }
  void member(const AbstractSymbol& made, int depth) {
    line(depth, "symbol", [&] {
      preamble(made.pre);
      put(made.name.text);
      if (!made.params.empty()) names(made.params);
    });
  }
  void member(const Rule& rule, int depth) {
    line(depth, "rule", [&] {
      preamble(rule.pre);
      put(rule.name.text);
      if (rule.has_params) names(rule.params);
      if (rule.index) index(*rule.index);
      if (rule.guard_else) put("else");
      if (rule.guard) put(":"), value(*rule.guard);
      put("->");
      body(rule.successor);
      if (rule.probability) put(":"), value(*rule.probability);
    });
  }
  void kind(EntryKind kind) {
    constexpr std::array words{"set", "add", "take", "remove"};
    put(words[static_cast<std::size_t>(kind)]);
  }
  void weight(const ExprPtr& weight) {
    if (weight) put(":"), value(*weight);
  }
  void member(const ElementEntry& entry, int depth) {
    line(depth, "element", [&] {
      preamble(entry.pre);
      put(entry.symbol.text);
      kind(entry.kind);
      for (const ElementAlternative& alternative : entry.alternatives) {
        out += " (";
        for (const ExprPtr& mesh : alternative.meshes) value(*mesh);
        weight(alternative.weight);
        out += ")";
      }
    });
  }
  void member(const MaterialEntry& entry, int depth) {
    line(depth, "material", [&] {
      preamble(entry.pre);
      put(entry.symbol.text);
      kind(entry.kind);
      for (const MaterialAlternative& alternative : entry.alternatives) {
        out += " (";
        for (const Emit& look : alternative.looks) emit(look);
        weight(alternative.weight);
        out += ")";
      }
      if (entry.per) put("per"), value(*entry.per);
    });
  }

  // ---- successors

  void body(const Body& body) {
    for (const Element& element : body) {
      std::visit(Overload{[&](const Emit& made) { emit(made); },
                          [&](const Push& made) {
                            out += " [";
                            this->body(made.body);
                            out += " ]";
                          },
                          [&](const Super&) { put("super"); },
                          [&](const If& made) {
                            out += " (if";
                            for (const IfArm& arm : made.arms) {
                              if (arm.condition) {
                                value(*arm.condition);
                              } else {
                                put("else");
                              }
                              out += " {";
                              this->body(arm.body);
                              out += " }";
                            }
                            out += ")";
                          }},
                 element.is);
    }
  }
  void emit(const Emit& emit) {
    std::string name = emit.style ? std::string(emit.style.text) + "::" : std::string();
    name += emit.name.text;
    const bool bare = !emit.args && !emit.index && !emit.parts && !emit.style_of;
    if (bare) return put(name);
    out += " (";
    if (emit.style_of) {
      out += "style";
      value(*emit.style_of);
      out += "::";
    }
    out += name;
    if (emit.args) args(*emit.args);
    if (emit.index) index(*emit.index);
    if (emit.parts) parts(*emit.parts);
    out += ")";
  }
  void parts(const Parts& parts) {
    group(parts.parts);
    if (parts.starred) out += "*";
  }
  void group(const std::vector<Part>& parts) {
    out += " {";
    for (std::size_t i = 0; i < parts.size(); ++i) {
      if (i > 0) out += " |";
      if (parts[i].label) size(*parts[i].label), out += ":";
      if (!parts[i].group.empty()) {
        group(parts[i].group);
        out += "*";
      }
      body(parts[i].body);
    }
    out += " }";
  }

  // ---- values

  void names(const std::vector<Name>& names) {
    out += " (";
    for (std::size_t i = 0; i < names.size(); ++i) out.append(i ? " " : "").append(names[i].text);
    out += ")";
  }
  void index(const Expr& expr) {
    out += " #[";
    value(expr);
    out += " ]";
  }
  void args(const std::vector<Arg>& args) {
    out += " (";
    for (const Arg& arg : args) {
      if (arg.name) put(std::string(arg.name.text) + "=");
      size(arg.value);
    }
    out += " )";
  }
  void size(const Size& size) {
    constexpr std::array marks{"", " %", " r", " ~", " :"};
    out += marks[static_cast<std::size_t>(size.kind)];
    if (size.value) value(*size.value);
  }
  void one(const Number& is) {
    std::array<char, 40> buffer;
    const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), is.value).ptr;
    put({buffer.data(), static_cast<std::size_t>(end - buffer.data())});
  }
  void one(const Text& is) { put("\"" + is.value + "\""); }
  void one(const Boolean& is) { put(is.value ? "true" : "false"); }
  void one(const List& is) {
    out += " (list";
    for (const ExprPtr& item : is.items) value(*item);
    out += ")";
  }
  void one(const Reference& is) { put(path(is)); }
  void one(const Call& is) {
    out += " (" + path(is.callee);
    args(is.args);
    out += ")";
  }
  void one(const Subscript& is) {
    out += " (at";
    value(*is.list), value(*is.index);
    out += ")";
  }
  void one(const Unary& is) {
    out += " (";
    for (const Prefix prefix : is.operators) out += prefix == Prefix::minus ? "-" : "!";
    value(*is.operand);
    out += ")";
  }
  void one(const Chain& is) {
    constexpr std::array signs{"+", "-", "*", "/", "<", "<=", ">", ">=", "==", "!=", "&&", "||"};
    out += " (";
    for (std::size_t i = 0; i < is.operands.size(); ++i) {
      if (i > 0) put(signs[static_cast<std::size_t>(is.operators[i - 1])]);
      value(*is.operands[i]);
    }
    out += " )";
  }
  void one(const Conditional& is) {
    out += " (cond";
    value(*is.condition), value(*is.then), value(*is.otherwise);
    out += ")";
  }
  static std::string path(const Reference& reference) {
    std::string path = reference.style ? std::string(reference.style.text) + "::" : std::string();
    for (std::size_t i = 0; i < reference.names.size(); ++i) {
      path.append(i ? "." : "").append(reference.names[i].text);
    }
    return path;
  }
};

}  // namespace

std::string dump(const File& file) {
  Dumper dumper;
  dumper.file(file);
  return std::move(dumper.out);
}

std::string dump(const Expr& expr) {
  Dumper dumper;
  dumper.value(expr);
  return dumper.out.substr(1);
}

}  // namespace mansard
