// Elements and materials: lists that each style, from the base on, sets, adds to or takes from.

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <type_traits>
#include <utility>

#include "styles/complaint.hpp"
#include "styles/members.hpp"

namespace mansard {

namespace {

using syntax::ElementAlternative;
using syntax::EntryKind;
using syntax::MaterialAlternative;
using syntax::Style;

// ---- what the two kinds of list differ in

/// The meshes of an alternative as written, nearest first.
std::vector<std::string_view> words_of(const ElementAlternative& alternative) {
  std::vector<std::string_view> meshes;
  for (const syntax::ExprPtr& mesh : alternative.meshes) {
    if (!mesh) continue;
    const auto* text = std::get_if<syntax::Text>(&mesh->is);
    meshes.push_back(text ? std::string_view(text->value) : mesh->at.text());
  }
  return meshes;
}

/// `"a.obj"` names the alternative `"a.obj" "a_far.obj"`: all meshes asked for are among its own.
bool means(const ElementAlternative& wanted, const ElementAlternative& present) {
  const auto meshes = words_of(present);
  return std::ranges::all_of(words_of(wanted), [&](std::string_view mesh) {
    return std::ranges::find(meshes, mesh) != meshes.end();
  });
}

/// Without the spaces that mean nothing: `color( "#fff" )` is `color("#fff")`.
std::string looks_of(const MaterialAlternative& alternative) {
  std::string looks;
  for (const Span& span : alternative.look_spans) {
    bool in_text = false;
    const std::string_view text = span.text();
    for (std::size_t i = 0; i < text.size(); ++i) {
      if (text[i] == '"' && (i == 0 || text[i - 1] != '\\')) in_text = !in_text;
      if (in_text || std::string_view(" \t\r\n").find(text[i]) == std::string_view::npos)
        looks += text[i];
    }
  }
  return looks;
}

std::vector<std::string_view> words_of(const MaterialAlternative& alternative) {
  std::vector<std::string_view> looks;
  for (const Span& span : alternative.look_spans) looks.push_back(span.text());
  return looks;
}

bool means(const MaterialAlternative& wanted, const MaterialAlternative& present) {
  return looks_of(wanted) == looks_of(present);
}

const auto& entries_of(const syntax::Block& block, const ElementBinding*) { return block.elements; }
const auto& entries_of(const syntax::Block& block, const MaterialBinding*) {
  return block.materials;
}

auto& endings_of(LinkedStyle& style, const ElementBinding*) { return style.ended_elements; }
auto& endings_of(LinkedStyle& style, const MaterialBinding*) { return style.ended_materials; }

void note_entry(ElementBinding&, const syntax::ElementEntry&) {}
void note_entry(MaterialBinding& binding, const syntax::MaterialEntry& entry) {
  if (!binding.entry || entry.kind == EntryKind::set || entry.per) binding.entry = &entry;
}

// ---- what they share

/// Applies the entries of an order, base style first.
template <class Binding>
class Fold {
 public:
  Fold(Linking& linking, const Order& order) : linking_(linking), order_(order), replaced_(order) {}

  /// Bindings in order of first appearance; those left without alternatives are gone.
  std::vector<Binding> run() {
    for (std::size_t rank = order_.size(); rank-- > 0;) {
      for_each_block(*order_[rank], [&](const syntax::Block& block) {
        if (replaced_.drops(block, rank)) return;
        for (const auto& entry : entries_of(block, static_cast<Binding*>(nullptr))) {
          apply(entry, {order_[rank], &block});
        }
      });
    }
    std::erase_if(bindings_, [](const Binding& binding) { return binding.alternatives.empty(); });
    return std::move(bindings_);
  }

  /// Styles that take what is not there. Only the complaints of the order's own style are kept: an
  /// ancestor's entry is right or wrong in its own order, whatever an heir's other parents do.
  const std::set<const Style*>& at_fault() const { return at_fault_; }

  using Endings = std::remove_reference_t<decltype(endings_of(
      std::declval<LinkedStyle&>(), static_cast<const Binding*>(nullptr)))>;
  Endings take_endings() { return std::move(endings_); }
  void warn_of_rivals() {
    for (const auto& [symbol, rivals] : quarrels_) {
      warn_of_two(linking_, symbol, "entry", rivals.first, rivals.second);
    }
  }

 private:
  template <class Entry>
  void apply(const Entry& entry, const Origin& from) {
    const std::string_view symbol = entry.symbol.text;
    const auto place = places_.find(symbol);
    const bool present = place != places_.end() && !bindings_[place->second].alternatives.empty();
    switch (entry.kind) {
      case EntryKind::set:
      case EntryKind::add: {
        Binding& binding = at(symbol);
        if (entry.kind == EntryKind::set) note_rival(binding, entry, from);
        if (entry.kind == EntryKind::set || !present) {
          for (const auto& choice : binding.alternatives) end(choice, entry, from);
          binding = Binding{};
          binding.symbol = symbol;
        }
        note_entry(binding, entry);
        for (const auto& alternative : entry.alternatives) {
          binding.alternatives.push_back({&alternative, from});
        }
        break;
      }
      case EntryKind::take:
        if (!present) return complain_of_symbol(entry, from);
        for (const auto& alternative : entry.alternatives) {
          take(bindings_[place->second], alternative, entry, from);
        }
        break;
      case EntryKind::remove:
        if (!present) return complain_of_symbol(entry, from);
        for (const auto& c : bindings_[place->second].alternatives) end(c, entry, from);
        bindings_[place->second].alternatives.clear();
        quarrels_.erase(symbol);
        break;
    }
  }

  /// An entry that takes the place of one whose style its own does not inherit.
  template <class Entry>
  void note_rival(const Binding& binding, const Entry& entry, const Origin& from) {
    quarrels_.erase(entry.symbol.text);
    for (const auto& choice : binding.alternatives) {
      if (linking_.ancestry.inherits(*from.style, *choice.from.style)) continue;
      quarrels_.insert_or_assign(entry.symbol.text,
                                 std::pair(Rival{from.style, entry.symbol.at},
                                           Rival{choice.from.style, choice.syntax->at}));
      return;
    }
  }

  Binding& at(std::string_view symbol) {
    const auto [place, is_new] = places_.emplace(symbol, bindings_.size());
    if (is_new) bindings_.emplace_back().symbol = symbol;
    return bindings_[place->second];
  }

  template <class Choice, class Entry>
  void end(const Choice& choice, const Entry& entry, const Origin& from) {
    endings_[choice.syntax] = {from, entry.at, entry.kind};
  }

  template <class Alternative, class Entry>
  void take(Binding& binding, const Alternative& wanted, const Entry& entry, const Origin& from) {
    const auto taken = [&](const auto& choice) {
      if (!means(wanted, *choice.syntax)) return false;
      end(choice, entry, from);
      return true;
    };
    if (std::erase_if(binding.alternatives, taken) > 0) return;
    std::vector<std::string_view> candidates;
    std::vector<Note> notes;
    if (!binding.alternatives.empty()) {
      notes.push_back({in_quotes(binding.symbol) + " has its alternatives here",
                       binding.alternatives.front().syntax->at});
    }
    for (const auto& choice : binding.alternatives) {
      if (linking_.suggestions_left <= 0) break;
      const auto words = words_of(*choice.syntax);
      candidates.insert(candidates.end(), words.begin(), words.end());
    }
    const auto words = words_of(wanted);
    const std::string_view word = words.empty() ? std::string_view() : words.front();
    complain(from, wanted.at, in_quotes(binding.symbol) + " has no alternative " + in_quotes(word),
             std::move(notes), word, std::move(candidates));
  }

  template <class Entry>
  void complain_of_symbol(const Entry& entry, const Origin& from) {
    std::vector<std::string_view> candidates;
    for (const Binding& binding : bindings_) {
      if (linking_.suggestions_left <= 0) break;
      if (!binding.alternatives.empty()) candidates.push_back(binding.symbol);
    }
    complain(from, entry.symbol.at,
             "nothing to take away: " + in_quotes(entry.symbol.text) + " has no entry in " +
                 in_quotes(from.block->name.text),
             {}, entry.symbol.text, std::move(candidates));
  }

  void complain(const Origin& from, Span at, std::string text, std::vector<Note> notes,
                std::string_view word, std::vector<std::string_view> candidates) {
    at_fault_.insert(from.style);
    if (from.style != order_.front()) return;
    notes.push_back(while_linking(*from.style));
    std::string help;
    if (linking_.suggestions_left-- > 0) help = did_you_mean(word, std::move(candidates));
    linking_.diagnostics.add(error(at, std::move(text), std::move(notes), std::move(help)));
  }

  Linking& linking_;
  const Order& order_;
  const Replacements replaced_;
  std::vector<Binding> bindings_;
  Endings endings_;
  std::unordered_map<std::string_view, std::size_t> places_;
  std::set<const Style*> at_fault_;
  std::map<std::string_view, std::pair<Rival, Rival>> quarrels_;  ///< winner and loser by symbol
};

template <class Binding>
std::vector<Binding> fold(Linking& linking) {
  const Order& order = linking.ancestry.order();
  Fold<Binding> own(linking, order);
  std::vector<Binding> bindings = own.run();
  endings_of(linking.result, static_cast<const Binding*>(nullptr)) = own.take_endings();
  own.warn_of_rivals();
  for (const Style* style : order) {
    if (style == order.front() || !own.at_fault().contains(style)) continue;
    Fold<Binding>(linking, linking.ancestry.order_of(*style)).run();
  }
  return bindings;
}

}  // namespace

void link_elements(Linking& linking) { linking.result.elements = fold<ElementBinding>(linking); }

void link_materials(Linking& linking) { linking.result.materials = fold<MaterialBinding>(linking); }

}  // namespace mansard
