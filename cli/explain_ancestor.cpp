// The page of an ancestor: what it gives to a style, and what has become of it there.
#include <algorithm>
#include <utility>

#include "cli/explain.hpp"
#include "cli/table.hpp"

namespace mansard {

namespace {

/// Not an entry that only adds or takes.
bool begins_anew(const Writing& writing) {
  const auto begins = [](const auto* is) {
    if constexpr (requires { is->kind; }) {
      return is->kind == syntax::EntryKind::set || is->kind == syntax::EntryKind::remove;
    } else {
      return true;
    }
  };
  return std::visit(begins, writing.syntax);
}

/// "hidden by Sills, sills.style:7".
std::string fate_of(const Explained& explained, const Writing& writing,
                    const std::vector<Writing>& all) {
  const auto by = [&](const Origin& from, Span at) {
    return " by " + std::string(from.style->name.text) + ", " + explained.place(at);
  };
  if (writing.fate == Fate::dropped)
    return "dropped" + by(writing.replaced_by, writing.replaced_by.block->replace);
  if (writing.fate == Fate::in_force || writing.fate == Fate::unanswered)
    return std::string(name_of(writing.fate));
  const Writing* nearest = nullptr;  // the least derived of those that are more derived
  for (const Writing& other : all) {
    if (other.rank < writing.rank && other.fate != Fate::dropped && begins_anew(other))
      nearest = &other;
  }
  std::string text(name_of(writing.fate));
  if (!nearest) return text;
  return writing.fate == Fate::by_super
             ? "reached by super of " + std::string(nearest->from.style->name.text)
             : text + by(nearest->from, nearest->at());
}

std::string text_of(const Writing& writing) {
  if (const auto* rule = std::get_if<const syntax::Rule*>(&writing.syntax))
    return behind_the_name(**rule, true);
  if (const auto* variable = std::get_if<const syntax::Variable*>(&writing.syntax))
    return (*variable)->value ? one_line((*variable)->value->at) : "abstract";
  if (const auto* function = std::get_if<const syntax::Function*>(&writing.syntax))
    return one_line((*function)->value->at);
  if (std::holds_alternative<const syntax::AbstractSymbol*>(writing.syntax)) return "abstract";
  const Span at = writing.at();
  std::string text = one_line({at.source, writing.name().end, at.end});
  if (text.starts_with(":")) text.erase(0, std::min<std::size_t>(2, text.size()));
  return text.empty() ? "removed" : text;
}

}  // namespace

std::string ancestor_page(const Explained& explained, const syntax::Style& ancestor) {
  Table table(1);
  table.line({"what style " + std::string(ancestor.name.text) + " gives to style " +
                  std::string(explained.style.name()),
              Ink::strong});
  std::string_view block;
  bool begun = false;
  const auto add = [&](const Story& story, const std::vector<Writing>& writings,
                       std::string_view heading) {
    std::string label = short_title(story);
    for (const Writing& writing : writings) {
      if (writing.from.style != &ancestor) continue;
      if (!begun || block != heading) {
        table.line();
        table.line({heading.empty() ? "Style-wide" : std::string(heading), Ink::strong});
        block = heading;
        begun = true;
      }
      const bool alive = writing.fate == Fate::in_force || writing.fate == Fate::by_super;
      const Ink ink = alive ? Ink::plain : Ink::faint;
      table.row({{"  " + std::exchange(label, {}), ink},
                 {text_of(writing), ink},
                 {explained.place(writing.at()), Ink::faint},
                 {fate_of(explained, writing, writings), ink}});
    }
  };
  const auto& stories = explained.stories.all();
  std::vector<std::string_view> blocks{{}};
  blocks.insert(blocks.end(), explained.style.blocks.begin(), explained.style.blocks.end());
  for (const std::string_view name : blocks) {
    for (const Story& story : stories) {
      if (story.block == name) add(story, story.writings, name);
    }
  }
  for (const Story& story : stories) add(story, story.elements, "Elements");
  for (const Story& story : stories) add(story, story.materials, "Materials");
  if (!begun) table.line({"nothing: it has no members of its own"});
  return table.text(explained.color);
}

}  // namespace mansard
