#include "cli/lsp/describe.hpp"

#include <algorithm>
#include <filesystem>
#include <set>
#include <utility>

#include "cli/lsp/pages.hpp"
#include "styles/members.hpp"

namespace mansard::lsp {

namespace {

const syntax::Preamble* preamble_of(const Word& word) {
  return std::visit(
      [](const auto& made) -> const syntax::Preamble* {
        if constexpr (std::is_same_v<std::decay_t<decltype(made)>, std::monostate>) {
          return nullptr;
        } else {
          return &made->pre;
        }
      },
      word.declares);
}

/// Of styles and blocks the head only.
Span text_of(const Word& word) {
  return std::visit(
      [&](const auto& made) -> Span {
        using Made = std::decay_t<decltype(made)>;
        if constexpr (std::is_same_v<Made, std::monostate>) {
          return word.at;
        } else if constexpr (std::is_same_v<Made, const syntax::Style*>) {
          return {made->at.source, made->at.begin,
                  made->parents.empty() ? made->name.at.end : made->parents.back().at.end};
        } else if constexpr (std::is_same_v<Made, const syntax::Block*>) {
          return {made->at.source, made->at.begin, made->name.at.end};
        } else {
          return made->at;
        }
      },
      word.declares);
}

/// "(terrace.style:12)"
std::string file_and_line(View& view, Span at) {
  return "(" + std::filesystem::path(at.source->name()).filename().string() + ":" +
         std::to_string(view.range(at).start.line + 1) + ")";
}

std::string place(View& view, const Word& word) {
  std::string text = word.style ? "`" + std::string(word.style->name.text) : "`";
  if (word.style && word.block && word.site != Site::block)
    text.append(".").append(word.block->name.text);
  return text + "` " + file_and_line(view, word.at);
}

/// "overrides `Terrace.Tile` (terrace.style:12), …", a style once, not more than a few.
std::string listing(View& view, std::string_view title, const std::vector<const Word*>& words) {
  constexpr std::size_t most = 6;
  std::vector<std::string> places;
  const syntax::Style* last = nullptr;
  for (const Word* word : words) {
    if (std::exchange(last, word->style) != word->style) places.push_back(place(view, *word));
  }
  if (places.empty()) return {};
  std::string text = "\n\n" + std::string(title) + " ";
  for (std::size_t i = 0; i < std::min(most, places.size()); ++i)
    text += (i ? ", " : "") + places[i];
  if (places.size() > most) text += " and " + std::to_string(places.size() - most) + " more";
  return text;
}

/// "Keeps `@range(0.6, 2)` of `Terrace.Tile` (terrace.style:12)": a child says anew only what is
/// other, save how often a variable is drawn.
std::string kept_annotations(View& view, const std::vector<const Word*>& own,
                             const std::vector<const Word*>& overridden) {
  std::set<std::string_view> said{"per"};
  const auto note = [&](const Word& word) {
    std::string fresh;
    const syntax::Preamble* const pre = preamble_of(word);
    if (!pre) return fresh;
    for (const syntax::Annotation& annotation : pre->annotations) {
      if (said.insert(annotation.name.text).second)
        fresh += "`" + std::string(annotation.at.text()) + "` ";
    }
    return fresh;
  };
  for (const Word* word : own) note(*word);
  std::string text;
  for (const Word* word : overridden) {
    if (const std::string kept = note(*word); !kept.empty())
      text.append("\n\nKeeps ").append(kept).append("of ").append(place(view, *word));
  }
  return text;
}

bool is_alive(const Writing& writing) {
  return writing.fate == Fate::in_force || writing.fate == Fate::by_super;
}

/// "Set by `FLOORS` (terrace.style:31) to `2.6`".
std::string settings(View& view, const Resolved& resolved, const Story& story) {
  std::string text;
  for (const Use& use : story.uses) {
    if (use.kind != UseKind::sets || !is_alive(resolved.stories().writing(use))) continue;
    text.append(text.empty() ? "\n\nSet for some shapes by `" : ", `")
        .append(resolved.stories().speaker(use).full_name() + "` ")
        .append(file_and_line(view, use.at) + " to `")
        .append(std::string(use.value.text()) + "`");
  }
  return text;
}

/// What only a style without errors tells: values, who sets them, and where `super` leads.
std::string resolution(View& view, const Meaning& meaning) {
  Resolved* const resolved = meaning.style ? view.resolved(*meaning.style) : nullptr;
  const Story* const story = resolved ? resolved->story(meaning) : nullptr;
  if (!story) return {};
  if (meaning.kind == Kind::variable) {
    const std::string worth = resolved->worth(meaning);
    return (worth.empty() ? std::string() : "\n\n= " + worth) + settings(view, *resolved, *story);
  }
  std::string text;
  const syntax::Style* last = nullptr;
  for (const Writing& writing : story->writings) {
    if (writing.fate != Fate::by_super || std::exchange(last, writing.from.style) == last) continue;
    text.append(text.empty() ? "\n\n`super` goes on with `" : ", then `")
        .append(full_name(writing.from.style->name.text, writing.from.block->name.text) + "` ")
        .append(file_and_line(view, writing.name()));
  }
  return text;
}

std::string describe_style(View& view, const Word& declared) {
  const auto* style = *std::get_if<const syntax::Style*>(&declared.declares);
  std::string text = code(declaration_text(declared));
  if (const std::string docs = documentation(declared); !docs.empty()) text += "\n\n" + docs;
  text += "\n\nResolution order:";
  for (const syntax::Style* one : view.meanings().order(*style))
    text += (one == style ? " " : ", ") + ("`" + std::string(one->name.text) + "`");
  return text;
}

std::string describe_parameter(const Meaning& meaning, const Word& declared) {
  const std::string_view owner = declared.rule       ? declared.rule->name.text
                                 : declared.function ? declared.function->name.text
                                                     : std::string_view{};
  return code(std::string(meaning.name)) + "\n\nA parameter of `" + std::string(owner) + "`.";
}

}  // namespace

std::string documentation(const Word& declared) {
  std::string text;
  if (const syntax::Preamble* pre = preamble_of(declared)) {
    for (const Span& line : pre->docs) text.append(line.text()).append("\n");
  }
  while (!text.empty() && text.back() == '\n') text.pop_back();
  return text;
}

std::string declaration_text(const Word& declared, std::size_t most_lines) {
  const Span at = text_of(declared);
  const std::size_t before = at.source->text().rfind('\n', at.begin);
  const std::size_t indent = at.begin - (before == std::string_view::npos ? 0 : before + 1);
  std::string text;
  std::string_view rest = at.text();
  for (std::size_t lines = 0; !rest.empty(); ++lines) {
    if (lines == most_lines) return text + "\n…";
    std::string_view line = rest.substr(0, rest.find('\n'));
    rest.remove_prefix(std::min(rest.size(), line.size() + 1));
    if (lines > 0) {
      const auto begin = line.find_first_not_of(' ');
      line.remove_prefix(std::min({indent, begin == line.npos ? line.size() : begin, line.size()}));
      text += '\n';
    }
    text += line;
  }
  return text;
}

std::string describe(View& view, const Meaning& meaning) {
  const Meanings& meanings = view.meanings();
  const std::vector<const Word*> found = meanings.definition(meaning);
  if (found.empty()) {
    return meaning.kind == Kind::symbol
               ? code(meaning.name) + "\n\nA terminal: no rule rewrites it."
               : std::string();
  }
  if (meaning.kind == Kind::style) return describe_style(view, *found.front());
  if (meaning.kind == Kind::parameter) return describe_parameter(meaning, *found.front());
  std::string text, docs;
  for (const Word* word : found) {
    text += (text.empty() ? "" : "\n") + declaration_text(*word);
    if (docs.empty()) docs = documentation(*word);
  }
  const std::vector<const Word*> overridden = meanings.overridden(meaning);
  for (const Word* word : overridden) {
    if (docs.empty()) docs = documentation(*word);
  }
  text = code(text);
  if (!docs.empty()) text += "\n\n" + docs;
  text += resolution(view, meaning);
  text += "\n\nGiven by " + place(view, *found.front());
  if (meaning.style && meaning.style != found.front()->style)
    text += ", inherited by `" + std::string(meaning.style->name.text) + "`";
  if (meaning.kind == Kind::variable) text += kept_annotations(view, found, overridden);
  text += listing(view, "Overrides", overridden);
  text += listing(view, "Overridden by", meanings.overriding(meaning));
  return text;
}

}  // namespace mansard::lsp
