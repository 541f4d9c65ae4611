#include "cli/explain_lines.hpp"

#include <algorithm>
#include <utility>

namespace mansard {

namespace {

std::string label_of(Fate fate) {
  constexpr std::string_view labels[] = {"", "super", "hides", "drops", "asked", "asked"};
  return "  " + std::string(labels[static_cast<int>(fate)]);
}

std::string style_name(const Origin& from) { return std::string(from.style->name.text); }

/// Writings of one style with one fate, as the productions of a rule are.
std::vector<std::vector<const Writing*>> grouped(const std::vector<Writing>& writings) {
  std::vector<std::vector<const Writing*>> groups;
  for (const Writing& writing : writings) {
    const Writing* last = groups.empty() ? nullptr : groups.back().front();
    if (!last || last->rank != writing.rank || last->fate != writing.fate ||
        last->syntax.index() != writing.syntax.index())
      groups.emplace_back();
    groups.back().push_back(&writing);
  }
  return groups;
}

class Lines {
 public:
  explicit Lines(const Explained& explained) : explained_(explained) {}

  std::vector<MemberLine> of(const Story& story) {
    value_ = explained_.value(story);
    if (value_ && value_->giver != VariableValue::Giver::style) add_outside_giver();
    if (lines_.empty()) add_nobody(story);
    for (const auto& group : grouped(story.writings)) {
      add_group(group);
      if (group.front()->fate == Fate::in_force) add_settings(story);
    }
    if (value_ && !value_->problem.empty())
      lines_.push_back({"  but", printable(value_->problem), {}, {}, {}, true});
    return named(short_title(story));
  }

  std::vector<MemberLine> of_entries(const Story& symbol,
                                     const std::vector<Alternative>& alternatives, bool rests,
                                     const std::string& draws) {
    if (rests && !alternatives.empty()) {
      const Writing& rule = *symbol.in_force();
      add("", "rests: it has rules", rule.from, rule.at());
    }
    for (const Alternative& alternative : alternatives) {
      if (alternative.fate == Fate::in_force) {
        const bool first = lines_.empty() || (rests && lines_.size() == 1);
        const std::string how = first && !draws.empty() ? "  " + draws : "";
        add(rests && first ? "  rests" : "", alternative.text + how, alternative.from,
            alternative.at, alternative.share.text())
            .in_force = !rests;
      } else {
        add_ended(alternative);
      }
    }
    return named(std::string(symbol.name));
  }

 private:
  std::vector<MemberLine> named(std::string name) {
    if (!lines_.empty()) lines_.front().label = std::move(name);
    return std::move(lines_);
  }

  MemberLine& add(std::string label, std::string what, const Origin& from, Span at,
                  std::string share = {}) {
    return lines_.emplace_back(MemberLine{std::move(label), std::move(what), style_name(from),
                                          explained_.place(at), std::move(share), false});
  }

  /// --set and properties are stronger than any writing.
  void add_outside_giver() {
    const bool line = value_->giver == VariableValue::Giver::command_line;
    lines_.push_back({{},
                      outside_text(*value_),
                      line ? "--set" : "property",
                      line ? "command line" : "footprint",
                      {},
                      true});
    if (line && value_->property)
      lines_.push_back(
          {"  hides", printable(*value_->property), "property", "footprint", {}, false});
  }

  /// Says so when no writing is in force.
  void add_nobody(const Story& story) {
    if (story.in_force()) return;
    const auto asked = std::ranges::find(story.writings, Fate::unanswered, &Writing::fate);
    if (asked != story.writings.end()) return add_abstract(*asked);
    const Writing& first = story.writings.front();
    if (first.fate == Fate::dropped)
      add("", "nothing is left", first.replaced_by, first.replaced_by.block->replace);
  }

  void add_abstract(const Writing& asked) {
    add("", "abstract: a child has to give it", asked.from, asked.at());
  }

  void add_group(const std::vector<const Writing*>& group) {
    if (group.front()->fate == Fate::unanswered) return;
    const Fate fate = group.front()->fate;
    const bool outside = value_ && value_->giver != VariableValue::Giver::style;
    const bool in_force = fate == Fate::in_force && !outside;
    std::string label = in_force ? "" : label_of(fate == Fate::in_force ? Fate::hidden : fate);
    if (std::holds_alternative<const syntax::Rule*>(group.front()->syntax))
      return add_rules(group, std::move(label), in_force);
    for (const Writing* writing : group)
      add(std::exchange(label, ""), value_of(*writing, in_force), writing->from, writing->at())
          .in_force = in_force;
  }

  void add_rules(const std::vector<const Writing*>& rules, std::string label, bool in_force) {
    const std::vector<Share> parts = shares(explained_, rules);
    for (std::size_t i = 0; i < rules.size(); ++i) {
      const auto& rule = *std::get<const syntax::Rule*>(rules[i]->syntax);
      const bool told = parts[i].part || parts[i].alone;
      add(std::exchange(label, ""), behind_the_name(rule, !told), rules[i]->from, rules[i]->at(),
          parts[i].text())
          .in_force = in_force;
    }
  }

  /// The expression, and what it is worth where that is settled and something else.
  std::string value_of(const Writing& writing, bool in_force) const {
    if (const auto* function = std::get_if<const syntax::Function*>(&writing.syntax))
      return (*function)->value ? one_line((*function)->value->at) : std::string();
    const auto* variable = std::get_if<const syntax::Variable*>(&writing.syntax);
    if (!variable || !(*variable)->value) return "abstract";
    const std::string text = one_line((*variable)->value->at);
    const bool known = in_force && value_ && explained_.settled(*value_);
    return known && !is_literal(*(*variable)->value) ? *value_->value + "  = " + text : text;
  }

  /// set() in rules that can be chosen.
  void add_settings(const Story& story) {
    std::string label = "  set()";
    for (const Use& use : story.uses) {
      const Writing& writing = explained_.stories.writing(use);
      const bool alive = writing.fate == Fate::in_force || writing.fate == Fate::by_super;
      if (use.kind != UseKind::sets || !alive) continue;
      add(std::exchange(label, ""),
          one_line(use.value) + "  in " + explained_.stories.speaker(use).full_name(), writing.from,
          use.at);
    }
  }

  void add_ended(const Alternative& alternative) {
    const Ending& ended = alternative.ended;
    if (lines_.empty()) add("", "nothing is left", ended.from, ended.at);
    const bool set = ended.how == syntax::EntryKind::set;
    std::string what = alternative.text;
    if (!set) what += "  by " + style_name(ended.from) + ", " + explained_.place(ended.at);
    const bool dropped = alternative.fate == Fate::dropped;
    add(dropped ? label_of(Fate::dropped)
        : set   ? label_of(Fate::hidden)
                : "  taken",
        what, alternative.from, alternative.at);
  }

  const Explained& explained_;
  std::optional<VariableValue> value_;
  std::vector<MemberLine> lines_;
};

}  // namespace

std::vector<MemberLine> lines_of(const Explained& explained, const Story& story) {
  if (story.writings.empty()) return {};
  return Lines(explained).of(story);
}

std::vector<MemberLine> element_lines(const Explained& explained, const Story& symbol) {
  return Lines(explained).of_entries(symbol, elements_of(explained.style, symbol),
                                     symbol.in_force() != nullptr, {});
}

std::vector<MemberLine> material_lines(const Explained& explained, const Story& symbol) {
  return Lines(explained).of_entries(symbol, materials_of(explained.style, symbol), false,
                                     material_draws(explained.style, symbol.name));
}

}  // namespace mansard
