// What the pages of `mansard explain` say alike.
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <map>
#include <set>

#include "cli/explain.hpp"

namespace mansard {

namespace {

bool is_space(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }

/// Where a comment that begins at `at` ends; `at` when none does.
std::size_t after_comment(std::string_view text, std::size_t at) {
  if (text.substr(at, 2) == "//") return std::min(text.find('\n', at), text.size());
  if (text.substr(at, 2) != "/*") return at;
  std::size_t depth = 0;
  for (; at < text.size(); ++at) {
    if (text.substr(at, 2) == "/*")
      ++depth, ++at;
    else if (text.substr(at, 2) == "*/" && ++at && --depth == 0)
      return at + 1;
  }
  return at;
}

std::size_t after_string(std::string_view text, std::size_t at) {
  for (++at; at < text.size() && text[at] != '"'; ++at) {
    if (text[at] == '\\') ++at;
  }
  return std::min(at + 1, text.size());
}

double literal_weight(const syntax::ExprPtr& weight) {
  const auto* number = weight ? std::get_if<syntax::Number>(&weight->is) : nullptr;
  return number ? number->value : 1;
}

/// Alternatives of an element or a material; `entry_of` a writing, `text_of` an alternative.
template <class Choices, class Endings>
std::vector<Alternative> alternatives(const Choices* in_force, const Endings& endings,
                                      const std::vector<Writing>& writings, auto entry_of,
                                      auto text_of) {
  std::vector<Alternative> result;
  double total = 0;
  if (in_force) {
    for (const auto& choice : *in_force) total += literal_weight(choice.syntax->weight);
    for (const auto& choice : *in_force) {
      const double weight = literal_weight(choice.syntax->weight);
      const Share share{total > 0 ? weight / total : 0, in_force->size() == 1};
      result.push_back({text_of(*choice.syntax), choice.from, choice.syntax->at, share, {}, {}});
    }
  }
  for (const Writing& writing : writings) {
    const auto& entry = entry_of(writing);
    const bool dropped = writing.fate == Fate::dropped && entry.kind != syntax::EntryKind::take;
    for (const auto& alternative : entry.alternatives) {
      const auto found = endings.find(&alternative);
      if (found == endings.end() && !dropped) continue;
      const Ending ended = dropped ? Ending{writing.replaced_by, writing.replaced_by.block->replace,
                                            syntax::EntryKind::remove}
                                   : found->second;
      result.push_back({text_of(alternative),
                        writing.from,
                        alternative.at,
                        {},
                        dropped ? Fate::dropped : Fate::hidden,
                        ended});
    }
  }
  return result;
}

template <class Binding>
const Binding* binding_of(const std::vector<Binding>& bindings, std::string_view symbol) {
  const auto found = std::ranges::find(bindings, symbol, &Binding::symbol);
  return found == bindings.end() ? nullptr : &*found;
}

}  // namespace

// ---- words

std::string_view name_of(MemberKind kind) {
  constexpr std::string_view names[] = {"variable", "function", "symbol"};
  return names[static_cast<int>(kind)];
}

std::string_view name_of(Fate fate) {
  constexpr std::string_view names[] = {"in force", "by super", "hidden",
                                        "dropped",  "answered", "unanswered"};
  return names[static_cast<int>(fate)];
}

std::string_view name_of(UseKind kind) {
  constexpr std::string_view names[] = {"reads", "sets", "calls", "emits", "names"};
  return names[static_cast<int>(kind)];
}

std::string title(const Story& story) {
  if (story.kind == MemberKind::variable) return "var " + story.full_name();
  if (story.kind == MemberKind::function) return "def " + story.full_name();
  return story.full_name();
}

std::string short_title(const Story& story) {
  std::string name(story.name);
  if (story.kind == MemberKind::variable) return "var " + name;
  if (story.kind == MemberKind::symbol) return name;
  std::string text = "def " + name + "(";
  const auto& function = *std::get<const syntax::Function*>(story.writings.front().syntax);
  for (const syntax::Name& p : function.params)
    text.append(text.back() == '(' ? "" : ", ").append(p.text);
  return text + ")";
}

// ---- places and source text

std::string full_place(Span at) {
  if (!at) return {};
  return at.source->name() + ":" + std::to_string(at.source->line_of(at.begin));
}

std::string Explained::place(Span at) const {
  if (!at) return {};
  const auto file = [](const Source& s) {
    return std::filesystem::path(s.name()).filename().string();
  };
  std::map<std::string, const Source*> files;
  for (const syntax::Style* s : style.order) {
    const auto [known, fresh] = files.emplace(file(*s->name.at.source), s->name.at.source);
    if (!fresh && known->second != s->name.at.source) return full_place(at);
  }
  return file(*at.source) + ":" + std::to_string(at.source->line_of(at.begin));
}

std::string printable(std::string_view text) {
  std::string result(text);
  for (char& c : result) {
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) c = ' ';
  }
  return result;
}

std::string one_line(Span at) {
  const std::string_view text = at.text();
  std::string line;
  bool space = false;
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t end = after_comment(text, i);
    if (end > i || is_space(text[i])) {
      space = true;
      i = std::max(end, i + 1);
      continue;
    }
    if (space && !line.empty()) line += ' ';
    space = false;
    const std::size_t next = text[i] == '"' ? after_string(text, i) : i + 1;
    line += text.substr(i, next - i);
    i = next;
  }
  return printable(line);
}

std::string outside_text(const VariableValue& value) {
  if (value.value) return printable(*value.value);
  return printable(value.command_line ? *value.command_line : value.property.value_or(""));
}

std::string behind_the_name(const syntax::Rule& rule, bool with_probability) {
  if (!rule.probability || with_probability)
    return one_line({rule.at.source, rule.name.at.end, rule.at.end});
  std::string text = one_line({rule.at.source, rule.name.at.end, rule.probability->at.begin});
  text.erase(text.find_last_not_of(" :(") + 1);
  return text;
}

bool is_literal(const syntax::Expr& expr) {
  if (const auto* unary = std::get_if<syntax::Unary>(&expr.is))
    return unary->operand && is_literal(*unary->operand);
  return std::holds_alternative<syntax::Number>(expr.is) ||
         std::holds_alternative<syntax::Text>(expr.is) ||
         std::holds_alternative<syntax::Boolean>(expr.is);
}

std::vector<std::string> source_lines(Span at) {
  std::vector<std::string> lines;
  if (!at) return lines;
  const uint32_t first = at.source->line_of(at.begin), last = at.source->line_of(at.end);
  const std::size_t indent = at.begin - at.source->line_begin(first);
  for (uint32_t n = first; n <= last; ++n) {
    std::string_view line = at.source->line(n);
    if (n == last) line = line.substr(0, at.end - at.source->line_begin(n));
    const std::size_t text = std::min(line.find_first_not_of(" \t"), line.size());
    line.remove_prefix(n == first ? indent : std::min(text, indent));
    const std::size_t end = line.find_last_not_of(" \t\r");
    if (end != std::string_view::npos) lines.push_back(printable(line.substr(0, end + 1)));
  }
  return lines;
}

// ---- values and shares

std::optional<VariableValue> Explained::value(const Story& variable) const {
  if (!values || variable.kind != MemberKind::variable) return std::nullopt;
  return values->variable(variable.block, variable.name);
}

bool Explained::settled(const VariableValue& value) const {
  return value.value && (footprint || !value.dependence.random) &&
         (properties || !value.dependence.footprint);
}

std::string Share::text() const {
  if (alone || !part) return {};
  char text[32];
  std::snprintf(text, sizeof text, "%.3g%%", *part * 100);
  return text;
}

std::vector<Share> shares(const Explained& explained, const std::vector<const Writing*>& rules) {
  struct Draw {
    double total = 0;
    bool known = true;
    std::size_t count = 0;
  };
  const auto rule_of = [](const Writing* w) { return std::get<const syntax::Rule*>(w->syntax); };
  const auto condition = [&](const Writing* w) {
    const syntax::Rule& rule = *rule_of(w);
    return (rule.guard_else ? "else " : "") + (rule.guard ? one_line(rule.guard->at) : "") + "[" +
           (rule.index ? one_line(rule.index->at) : "");
  };
  const auto weight = [&](const Writing* w) -> std::optional<double> {
    const syntax::ExprPtr& written = rule_of(w)->probability;
    if (explained.values) return explained.values->weight(*rule_of(w));
    if (written && !std::holds_alternative<syntax::Number>(written->is)) return std::nullopt;
    return literal_weight(written);
  };
  std::map<std::string, Draw> draws;
  for (const Writing* rule : rules) {
    Draw& draw = draws[condition(rule)];
    const auto w = weight(rule);
    draw.total += w.value_or(0);
    draw.known = draw.known && w;
    ++draw.count;
  }
  std::vector<Share> result;
  for (const Writing* rule : rules) {
    const Draw& draw = draws.at(condition(rule));
    Share& share = result.emplace_back();
    share.alone = draw.count == 1;
    if (draw.known) share.part = draw.total > 0 ? *weight(rule) / draw.total : 0;
  }
  return result;
}

// ---- alternatives

std::vector<Alternative> elements_of(const LinkedStyle& style, const Story& symbol) {
  const ElementBinding* binding = binding_of(style.elements, symbol.name);
  return alternatives(
      binding ? &binding->alternatives : nullptr, style.ended_elements, symbol.elements,
      [](const Writing& w) -> const auto& {
        return *std::get<const syntax::ElementEntry*>(w.syntax);
      },
      [](const syntax::ElementAlternative& a) {
        std::string text;
        for (const syntax::ExprPtr& mesh : a.meshes) {
          if (mesh) text += (text.empty() ? "" : " ") + one_line(mesh->at);
        }
        return text;
      });
}

std::vector<Alternative> materials_of(const LinkedStyle& style, const Story& symbol) {
  const MaterialBinding* binding = binding_of(style.materials, symbol.name);
  return alternatives(
      binding ? &binding->alternatives : nullptr, style.ended_materials, symbol.materials,
      [](const Writing& w) -> const auto& {
        return *std::get<const syntax::MaterialEntry*>(w.syntax);
      },
      [](const syntax::MaterialAlternative& a) {
        std::string text;
        for (const Span& look : a.look_spans) text += (text.empty() ? "" : " ") + one_line(look);
        return text;
      });
}

std::string material_draws(const LinkedStyle& style, std::string_view symbol) {
  const MaterialBinding* binding = binding_of(style.materials, symbol);
  if (!binding || !binding->entry || !binding->entry->per) return {};
  return "per " + one_line(binding->entry->per->at);
}

// ---- what a member speaks of

std::vector<StoryUse> readings(const Stories& stories, const Story& speaker) {
  std::vector<StoryUse> result;
  for (const Story& story : stories.all()) {
    std::set<UseKind> kinds;
    for (const Use& use : story.uses) {
      if (&stories.speaker(use) != &speaker) continue;
      const Fate fate = stories.writing(use).fate;
      if (fate != Fate::in_force && fate != Fate::by_super) continue;
      if (kinds.insert(use.kind).second) result.push_back({&story, use.kind});
    }
  }
  return result;
}

}  // namespace mansard
