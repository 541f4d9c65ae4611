// Finds the stories of a style.

#include <algorithm>
#include <functional>
#include <utility>

#include "styles/members.hpp"
#include "styles/mentions.hpp"
#include "styles/reserved.hpp"
#include "styles/story.hpp"

namespace mansard {

/// Tells the stories of one style: first the writings of every member, then who speaks of whom.
class Teller {
 public:
  explicit Teller(Stories& stories) : stories_(stories), style_(stories.style()) {}

  void tell() {
    const Members members = gather(style_.order);
    for (const auto& slot : members.variables) tell_variable(slot, members.replaced);
    for (const auto& slot : members.functions) tell_function(slot, members.replaced);
    for (const auto& slot : members.symbols) tell_rules(slot, members.replaced);
    for (const auto& slot : members.abstract_symbols) tell_abstract(slot, members.replaced);
    for (const auto& slot : members.elements) {
      tell_entries(slot, members.replaced, style_.ended_elements, &Story::elements);
    }
    for (const auto& slot : members.materials) {
      tell_entries(slot, members.replaced, style_.ended_materials, &Story::materials);
    }
    settle_abstract();
    for (uint32_t i = 0; i < all().size(); ++i) find_uses(i);
    add_symbol_values();
    index_places();
  }

 private:
  std::vector<Story>& all() { return stories_.stories_; }

  // ---- writings

  uint32_t number(MemberKind kind, std::string_view block, std::string_view name) {
    const auto [found, is_new] =
        stories_.numbers_.emplace(key(kind, block, name), static_cast<uint32_t>(all().size()));
    if (is_new) {
      Story& story = all().emplace_back();
      story.kind = kind;
      story.block = block;
      story.name = name;
      stories_.by_name_.emplace(name, found->second);
    }
    return found->second;
  }

  static Stories::Key key(MemberKind kind, std::string_view block, std::string_view name) {
    return {kind, kind == MemberKind::symbol ? std::string_view() : block, name};
  }

  template <class T>
  static Writing writing(const Given<T>& given, Fate fate, const Replacements& replaced) {
    Writing writing{given.syntax, given.from, static_cast<uint32_t>(given.rank), fate, {}};
    if (given.dropped) {
      writing.fate = Fate::dropped;
      writing.replaced_by = replaced.replacer(given.from.block->name.text);
    }
    return writing;
  }

  void tell_variable(const Slot<syntax::Variable>& slot, const Replacements& replaced) {
    Story& story = all()[number(MemberKind::variable, slot.block, slot.name)];
    const VariableBinding* binding = style_.find_variable(slot.block, slot.name);
    const bool given_a_value = binding && binding->syntax->value;
    for (const auto& given : slot.given) {
      Fate fate = Fate::hidden;
      if (!given.syntax->value) {
        fate = given_a_value ? Fate::answered : Fate::unanswered;
      } else if (binding && given.syntax == binding->syntax) {
        fate = Fate::in_force;
      }
      story.writings.push_back(writing(given, fate, replaced));
    }
  }

  void tell_function(const Slot<syntax::Function>& slot, const Replacements& replaced) {
    Story& story = all()[number(MemberKind::function, slot.block, slot.name)];
    const FunctionBinding* binding = style_.find_function(slot.block, slot.name);
    for (const auto& given : slot.given) {
      const bool wins = binding && given.syntax == binding->syntax;
      story.writings.push_back(writing(given, wins ? Fate::in_force : Fate::hidden, replaced));
    }
  }

  void tell_rules(const Slot<syntax::Rule>& slot, const Replacements& replaced) {
    Story& story = all()[number(MemberKind::symbol, {}, slot.name)];
    std::unordered_map<const syntax::Style*, Fate> fates;
    if (const SymbolRules* rules = style_.find_symbol(slot.name)) {
      story.block = rules->generations[0].from.block->name.text;
      Fate fate = Fate::in_force;
      for (const Generation& generation : rules->generations) {
        fates.emplace(generation.from.style, fate);
        fate = fate != Fate::hidden && uses_super(generation) ? Fate::by_super : Fate::hidden;
      }
    } else {
      story.block = slot.given.front().from.block->name.text;
    }
    for (const auto& given : slot.given) {
      const Fate fate = given.dropped ? Fate::dropped : fates.at(given.from.style);
      story.writings.push_back(writing(given, fate, replaced));
    }
  }

  void tell_abstract(const Slot<syntax::AbstractSymbol>& slot, const Replacements& replaced) {
    Story& story = all()[number(MemberKind::symbol, {}, slot.name)];
    const auto* block = slot.given.front().from.block;
    if (story.block.empty() && block) story.block = block->name.text;
    for (const auto& given : slot.given) {
      story.writings.push_back(writing(given, Fate::unanswered, replaced));
    }
    std::ranges::stable_sort(story.writings, {}, &Writing::rank);
  }

  /// An `abstract` is answered by a rule or by an element.
  void settle_abstract() {
    for (Story& story : all()) {
      if (story.kind != MemberKind::symbol) continue;
      const auto given = [](const Writing& w) { return w.fate == Fate::in_force; };
      const bool answered =
          std::ranges::any_of(story.writings, given) || std::ranges::any_of(story.elements, given);
      for (Writing& writing : story.writings) {
        if (answered && writing.fate == Fate::unanswered) writing.fate = Fate::answered;
      }
    }
  }

  /// An entry is in force as long as an alternative of it is; one that takes away, until a more
  /// derived one begins anew.
  template <class Entry, class Alternative>
  void tell_entries(const Slot<Entry>& slot, const Replacements& replaced,
                    const std::unordered_map<const Alternative*, Ending>& ended,
                    std::vector<Writing> Story::*entries) {
    Story& story = all()[number(MemberKind::symbol, {}, slot.name)];
    auto& writings = story.*entries;
    for (const auto& given : slot.given) writings.push_back(writing(given, Fate::hidden, replaced));
    std::vector<const Writing*> order = from_the_base(writings);
    bool anew = false;
    for (auto at = order.rbegin(); at != order.rend(); ++at) {
      Writing& w = writings[static_cast<std::size_t>(*at - writings.data())];
      if (w.fate == Fate::dropped) continue;
      const Entry& entry = *std::get<const Entry*>(w.syntax);
      const bool gives =
          entry.kind == syntax::EntryKind::set || entry.kind == syntax::EntryKind::add;
      const bool lives = !gives || std::ranges::any_of(entry.alternatives, [&](const auto& a) {
        return !ended.contains(&a);
      });
      if (!anew && lives) w.fate = Fate::in_force;
      anew =
          anew || entry.kind == syntax::EntryKind::set || entry.kind == syntax::EntryKind::remove;
    }
  }

  // ---- uses

  void find_uses(uint32_t speaker) {
    for (uint32_t i = 0; i < all()[speaker].writings.size(); ++i) {
      const Writing writing = all()[speaker].writings[i];
      speaker_ = speaker;
      writing_ = i;
      block_ = writing.from.block ? writing.from.block->name.text : std::string_view();
      std::visit([&](const auto* is) { add_uses(*is); }, writing.syntax);
    }
  }

  template <class T>
  void add_uses(const T& syntax) {
    if constexpr (requires { mentions_of(syntax); }) {
      for (const Mention& mention : mentions_of(syntax)) add_use(mention);
    }
  }

  void add_use(const Mention& mention) {
    switch (mention.kind) {
      case MentionKind::value:
        if (add_variable(mention, UseKind::reads) || !mention.block.empty()) return;
        symbol_values_.push_back({mention, {UseKind::names, mention.at, {}, speaker_, writing_}});
        return;
      case MentionKind::set:
        add_variable(mention, UseKind::sets);
        return;
      case MentionKind::call:
        add_in_force(MemberKind::function, mention, UseKind::calls);
        return;
      case MentionKind::apply:
        if (style_.find_symbol(mention.name)) add_symbol(mention.name, mention.at);
        return;
      case MentionKind::emit:
        if (style_.find_symbol(mention.name)) return add_symbol(mention.name, mention.at);
        if (!add_variable(mention, UseKind::reads)) add_symbol(mention.name, mention.at);
        return;
    }
  }

  bool add_variable(const Mention& mention, UseKind kind) {
    return add_in_force(MemberKind::variable, mention, kind);
  }

  /// As the compiler looks for names: with the block it was written with, else in the block it
  /// stands in and then in the style.
  bool add_in_force(MemberKind kind, const Mention& mention, UseKind how) {
    const bool qualified = !mention.block.empty();
    if (add(kind, qualified ? mention.block : block_, mention, how)) return true;
    const bool style_too = !qualified || kind == MemberKind::function;
    return style_too && add(kind, {}, mention, how);
  }

  bool add(MemberKind kind, std::string_view block, const Mention& mention, UseKind how) {
    const auto found = stories_.numbers_.find(key(kind, block, mention.name));
    if (found == stories_.numbers_.end()) return false;
    all()[found->second].uses.push_back({how, mention.at, mention.value, speaker_, writing_});
    return true;
  }

  void add_symbol(std::string_view name, Span at) {
    if (name == "NIL") return;
    const uint32_t symbol = number(MemberKind::symbol, {}, name);
    all()[symbol].uses.push_back({UseKind::emits, at, {}, speaker_, writing_});
  }

  /// A bare name in an expression is a symbol when one is called so, or when it is in capitals as
  /// terminals are.
  void add_symbol_values() {
    for (const auto& [mention, use] : symbol_values_) {
      const auto known = stories_.numbers_.find(key(MemberKind::symbol, {}, mention.name));
      if (known == stories_.numbers_.end() && !in_capitals(mention.name)) continue;
      all()[number(MemberKind::symbol, {}, mention.name)].uses.push_back(use);
    }
  }

  static bool in_capitals(std::string_view name) {
    constexpr std::string_view capitals = "ABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_";
    return name.size() > 1 && name.find_first_not_of(capitals) == std::string_view::npos &&
           name != "NIL" && !is_reserved(name);
  }

  // ---- places

  void index_places() {
    auto& places = stories_.places_;
    for (uint32_t i = 0; i < all().size(); ++i) {
      const Story& story = all()[i];
      for (const auto* writings : {&story.writings, &story.elements, &story.materials}) {
        for (const Writing& writing : *writings) places.push_back({writing.name(), i});
      }
      for (const Use& use : story.uses) places.push_back({use.at, i});
    }
    std::ranges::sort(places, Stories::earlier, &Stories::Place::at);
  }

  struct SymbolValue {
    Mention mention;
    Use use;
  };

  Stories& stories_;
  const LinkedStyle& style_;
  std::vector<SymbolValue> symbol_values_;
  uint32_t speaker_ = 0, writing_ = 0;
  std::string_view block_;
};

Stories::Stories(const LinkedStyle& style) : style_(&style) { Teller(*this).tell(); }

}  // namespace mansard
