// W006, and W004 and W016 for variables and functions: what nothing reads, and what was meant
// instead.
#include <algorithm>

#include "grammar/enumerate.hpp"
#include "interpreter/lint/linting.hpp"

namespace mansard {

namespace {

std::string quoted(std::string_view text) { return "'" + std::string(text) + "'"; }

std::string full_name(std::string_view block, std::string_view name) {
  return block.empty() ? std::string(name) : std::string(block) + "." + std::string(name);
}

// ---- what variables and functions differ in

struct Variables {
  using Syntax = syntax::Variable;
  static constexpr const char *noun = "variable", *reads = "reads", *read = "read";
  static const auto& all(const LinkedStyle& style) { return style.variables; }
  static const auto* find(const LinkedStyle& style, std::string_view block, std::string_view name) {
    return style.find_variable(block, name);
  }
  static bool is_read(const Reads& all_reads, const syntax::Style& style, const std::string& name) {
    return all_reads.variable(style, name);
  }
};

struct Functions {
  using Syntax = syntax::Function;
  static constexpr const char *noun = "function", *reads = "calls", *read = "called";
  static const auto& all(const LinkedStyle& style) { return style.functions; }
  static const auto* find(const LinkedStyle& style, std::string_view block, std::string_view name) {
    return style.find_function(block, name);
  }
  static bool is_read(const Reads& all_reads, const syntax::Style& style, const std::string& name) {
    return all_reads.function(style, name);
  }
};

class Unread {
 public:
  Unread(Linting& linting, const syntax::Style& style, const LinkedStyle& linked)
      : linting_(linting), style_(style), linked_(linked) {}

  void warn() {
    for (const syntax::StyleMember& member : style_.members) {
      if (const auto* variable = std::get_if<syntax::Variable>(&member)) check(*variable, {});
      if (const auto* function = std::get_if<syntax::Function>(&member)) check(*function, {});
      const auto* block = std::get_if<syntax::Block>(&member);
      if (!block || is_slip(*block)) continue;
      for (const syntax::BlockItem& item : block->items) {
        if (const auto* v = std::get_if<syntax::Variable>(&item)) check(*v, block->name.text);
        if (const auto* f = std::get_if<syntax::Function>(&item)) check(*f, block->name.text);
      }
    }
  }

 private:
  /// The block's own name has been complained of.
  bool is_slip(const syntax::Block& block) const {
    return std::ranges::any_of(linting_.diagnostics.all(), [&](const Diagnostic& d) {
      return d.code == "W016" && d.at == block.name.at;
    });
  }

  void check(const syntax::Variable& variable, std::string_view block) {
    // Beside rules of its name W015 says that those are taken.
    if (!variable.value || linked_.find_symbol(variable.name.text)) return;
    check_as<Variables>(variable, block);
  }
  void check(const syntax::Function& function, std::string_view block) {
    check_as<Functions>(function, block);
  }

  template <class Kind>
  void check_as(const typename Kind::Syntax& member, std::string_view block) {
    const std::string name = full_name(block, member.name.text);
    if (Kind::is_read(linting_.reads, style_, name)) return;
    const auto* binding = Kind::find(linked_, block, member.name.text);
    if (!binding) return;
    const bool is_told = std::ranges::any_of(binding->overrides, [&](const Origin& origin) {
      return linting_.here(origin.style->name.at) &&
             !Kind::is_read(linting_.reads, *origin.style, name);
    });
    if (is_told) return;
    const bool is_new = binding->overrides.empty() && linked_.order.size() > 1;
    if (is_new && is_in_another_block<Kind>(member.name, block)) return;
    if (is_new && is_misspelt<Kind>(member.name, block)) return;
    const bool overrides = !binding->overrides.empty();
    linting_.warn("W006", member.name.at,
                  overrides
                      ? "nothing in style " + quoted(style_.name.text) + " " + Kind::reads + " " +
                            Kind::noun + " " + quoted(name)
                      : std::string(Kind::noun) + " " + quoted(name) + " is never " + Kind::read,
                  "take it away, or use it in a rule");
  }

  template <class Kind>
  bool is_inherited(const auto& binding) const {
    return binding.from.style != &style_ || !binding.overrides.empty();
  }

  /// An inherited one of this name belongs to another block, so this one overrides nothing.
  template <class Kind>
  bool is_in_another_block(const syntax::Name& name, std::string_view block) {
    std::vector<std::string> homes;
    std::vector<Note> notes;
    bool in_style = false;
    for (const auto& binding : Kind::all(linked_)) {
      if (binding.name != name.text || binding.block == block || !is_inherited<Kind>(binding))
        continue;
      in_style = in_style || binding.block.empty();
      if (!binding.block.empty()) homes.push_back(quoted(binding.block));
      notes.push_back({"inherited from here", binding.syntax->name.at});
    }
    if (notes.empty()) return false;
    const std::string home =
        in_style ? "the style"
                 : (homes.size() == 1 ? "block " : "blocks ") + enumerate(homes, "and");
    linting_.warn("W004", name.at,
                  quoted(name.text) + " is a " + Kind::noun + " of " + home + "; given " +
                      (block.empty() ? "in the style" : "in block " + quoted(block)) +
                      " it is a new one, which nothing " + Kind::reads,
                  in_style ? "move it out of the block" : "move it into " + enumerate(homes, "or"),
                  std::move(notes));
    return true;
  }

  template <class Kind>
  bool is_misspelt(const syntax::Name& name, std::string_view block) {
    std::vector<std::string_view> names;
    for (const auto& binding : Kind::all(linked_)) {
      if (binding.block == block && is_inherited<Kind>(binding)) names.push_back(binding.name);
    }
    const std::string_view near = names.empty() ? "" : linting_.nearest_of(name.text, names);
    if (near.empty()) return false;
    linting_.warn("W016", name.at,
                  std::string("nothing ") + Kind::reads + " " +
                      quoted(full_name(block, name.text)) + ", which is nearly the inherited " +
                      quoted(near),
                  "did you mean to override " + quoted(near) + "?");
    return true;
  }

  Linting& linting_;
  const syntax::Style& style_;
  const LinkedStyle& linked_;
};

}  // namespace

void warn_of_unread(Linting& linting) {
  for (const syntax::Style& style : linting.file.styles) {
    const LinkedStyle* const linked = linting.linked(style);
    if (linked && !linting.live_heirs(style).empty()) Unread(linting, style, *linked).warn();
  }
}

}  // namespace mansard
