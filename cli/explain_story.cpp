// The page of one member: all its writings, what else could give it, who speaks of it.
#include <algorithm>
#include <set>
#include <utility>

#include "cli/explain.hpp"
#include "cli/table.hpp"

namespace mansard {

namespace {

using Group = std::vector<const Writing*>;

std::string style_name(const Origin& from) { return std::string(from.style->name.text); }

bool alive(Fate fate) { return fate == Fate::in_force || fate == Fate::by_super; }

std::string counted(std::size_t n, const std::string& noun) {
  return std::to_string(n) + " " + noun + (n == 1 ? "" : "s");
}

/// Writings of one style with one fate, base style first.
std::vector<Group> groups_from_the_base(const std::vector<Writing>& writings) {
  std::vector<Group> groups;
  for (const Writing* writing : from_the_base(writings)) {
    const Writing* last = groups.empty() ? nullptr : groups.back().front();
    if (!last || last->rank != writing->rank || last->fate != writing->fate ||
        last->syntax.index() != writing->syntax.index())
      groups.emplace_back();
    groups.back().push_back(writing);
  }
  return groups;
}

/// Columns: what it is, style, place, text.
class StoryPage {
 public:
  StoryPage(const Explained& explained, const Story& story)
      : explained_(explained),
        story_(story),
        value_(explained.value(story)),
        outside_(value_ && value_->giver != VariableValue::Giver::style) {
    constexpr std::size_t longest = 36;
    for (const syntax::Style* style : explained.style.order)
      short_places_ = short_places_ || style->name.at.source->name().size() > longest;
  }

  std::string text() {
    headline();
    preamble();
    writings();
    if (story_.kind == MemberKind::symbol) entries();
    reads();
    uses(UseKind::reads, "Read by");
    uses(UseKind::calls, "Called by");
    uses(UseKind::emits, "Emitted by");
    uses(UseKind::names, "Named by");
    return table_.text(explained_.color);
  }

 private:
  void section(const std::string& title) {
    table_.line();
    table_.line({title, Ink::strong});
  }

  void row(const std::string& what, const std::string& who, const std::string& where,
           const std::string& text, Ink ink) {
    table_.row({{"  " + what, ink}, {who, ink}, {where, Ink::faint}, {text, ink}});
  }

  std::string where(Span at) const { return short_places_ ? explained_.place(at) : full_place(at); }

  // ---- who it is

  void headline() {
    table_.line({std::string(name_of(story_.kind)) + " " + story_.full_name() + " of style " +
                     std::string(explained_.style.name()) + ": " + verdict(),
                 Ink::strong});
    if (!explained_.circumstances.empty()) table_.line({explained_.circumstances});
    if (explained_.style.start == story_.name && story_.kind == MemberKind::symbol)
      table_.line({"Derivation begins with it."});
    if (value_ && !value_->problem.empty()) table_.line({printable(value_->problem)});
  }

  /// "0.9, from Sills", "a terminal".
  std::string verdict() const {
    if (outside_) {
      return outside_text(*value_) + (value_->giver == VariableValue::Giver::command_line
                                          ? ", from the command line"
                                          : ", from a property of the footprint");
    }
    const Writing* writing = story_.in_force();
    if (!writing) return without_writing();
    std::string from = "from " + style_name(writing->from);
    if (story_.kind == MemberKind::function) return from;
    if (story_.kind == MemberKind::variable) return value_ ? worth() + ", " + from : from;
    const auto rules = std::ranges::count(story_.writings, Fate::in_force, &Writing::fate);
    return counted(static_cast<std::size_t>(rules), "rule") + ", " + from;
  }

  std::string worth() const {
    if (explained_.settled(*value_)) return *value_->value;
    if (value_->dependence.abstract) return "waits for what a child has to give";
    if (value_->dependence.shape) return "depends on the shape";
    return value_->dependence.random ? "drawn once a building (--footprint shows it)"
                                     : "depends on the footprint (--footprint shows it)";
  }

  std::string without_writing() const {
    const auto asks = [](const Writing& w) { return w.fate == Fate::unanswered; };
    if (std::ranges::any_of(story_.writings, asks)) return "abstract, a child has to give it";
    const auto elements = elements_of(explained_.style, story_);
    if (!elements.empty() && elements.front().fate == Fate::in_force)
      return "a terminal with elements";
    if (story_.kind == MemberKind::symbol) return "a terminal";
    return "nothing is left of it";
  }

  /// Of the writing in force; where it has none, of the nearest that it hides.
  void preamble() {
    for (const auto* writings : {&story_.writings, &story_.elements, &story_.materials}) {
      for (const Writing& writing : *writings) {
        const syntax::Preamble& pre = writing.preamble();
        if (pre.docs.empty() && pre.annotations.empty()) continue;
        for (const Span& doc : pre.docs) table_.line({"/// " + printable(doc.text())});
        std::string line;
        for (const syntax::Annotation& annotation : pre.annotations)
          line.append(line.empty() ? "" : " ").append(one_line(annotation.at));
        if (!line.empty()) table_.line({line});
        return;
      }
    }
  }

  // ---- from the base on

  void writings() {
    if (story_.writings.empty()) return;
    section(story_.kind == MemberKind::variable ? "From the weakest to the strongest"
                                                : "Written, from the base on");
    for (const Group& group : groups_from_the_base(story_.writings)) add_group(group);
    if (story_.kind != MemberKind::variable) return;
    property_row();
    set_rows();
    command_line_row();
  }

  void add_group(const Group& group) {
    const Writing& first = *group.front();
    const bool in_force = first.fate == Fate::in_force && !outside_;
    const Ink ink = in_force || first.fate == Fate::by_super ? Ink::plain : Ink::faint;
    const std::string who = style_name(first.from), place = where(first.at());
    const std::string state = in_force ? "> in force" : "  " + state_of(first);
    if (std::holds_alternative<const syntax::Rule*>(first.syntax)) {
      row(state, who, place, aside(first), ink);
      const std::vector<Share> parts = shares(explained_, group);
      std::size_t widest = 0;
      for (const Share& part : parts) widest = std::max(widest, part.text().size());
      for (std::size_t i = 0; i < group.size(); ++i)
        source(*group[i], parts[i].text(), widest, ink);
      return;
    }
    const std::string text = one_line(first.at());
    constexpr std::size_t widest = 48;
    const bool fits = width_of(text) <= widest;
    const std::string more = aside(first);
    row(state, who, place, fits ? text + (more.empty() ? "" : "  " + more) : more, ink);
    if (!fits) source(first, {}, 0, ink);
  }

  std::string state_of(const Writing& writing) const {
    if (writing.fate == Fate::in_force) return "hidden";  // by the command line or a property
    if (writing.fate == Fate::answered || writing.fate == Fate::unanswered) return "asked for";
    return std::string(name_of(writing.fate));
  }

  /// Where `super` leads, or who dropped it.
  std::string aside(const Writing& writing) const {
    if (writing.fate == Fate::dropped) {
      return "by replace of " + style_name(writing.replaced_by) + ", line " +
             std::to_string(writing.replaced_by.block->replace.source->line_of(
                 writing.replaced_by.block->replace.begin));
    }
    if (!alive(writing.fate) || story_.kind != MemberKind::symbol) return {};
    const SymbolRules* rules = explained_.style.find_symbol(story_.name);
    const auto& all = rules->generations;
    const auto own = std::ranges::find_if(
        all, [&](const Generation& g) { return g.from.style == writing.from.style; });
    if (own == all.end() || !uses_super(*own)) return {};
    const auto next = std::next(own);
    return next == all.end() ? "super: the plain terminal" : "super: " + style_name(next->from);
  }

  /// Its own lines with their numbers, and how often it is drawn.
  void source(const Writing& writing, const std::string& share, std::size_t share_width, Ink ink) {
    constexpr std::size_t page_width = 100, numbers = 8;
    uint32_t number = writing.at().source->line_of(writing.at().begin);
    const std::size_t left = numbers + 2 + (share_width > 0 ? share_width + 2 : 0);
    std::string drawn(share_width - share.size(), ' ');
    drawn += share;
    for (const std::string& line : source_lines(writing.at())) {
      std::string front = std::to_string(number++);
      front.insert(0, numbers - std::min(numbers, front.size()), ' ');
      front.append("  ").append(std::exchange(drawn, {}));
      for (const std::string& piece : wrapped(line, page_width - left)) {
        front.resize(left, ' ');
        table_.line({std::exchange(front, {}) + piece, ink});
      }
    }
  }

  // ---- what is stronger than the style

  void property_row() {
    const std::string name = story_.full_name();
    if (!value_ || !value_->property) {
      row("  not given", "property", "of the footprint", name, Ink::faint);
      return;
    }
    const bool wins = value_->giver == VariableValue::Giver::property;
    row(wins       ? "> in force"
        : outside_ ? "  hidden"
                   : "  not taken",
        "property", "of the footprint", name + " = " + printable(*value_->property),
        wins ? Ink::plain : Ink::faint);
  }

  void set_rows() {
    const bool too_weak = outside_ && value_->giver == VariableValue::Giver::command_line;
    bool any = false;
    for (const Use& use : story_.uses) {
      const Writing& writing = explained_.stories.writing(use);
      if (use.kind != UseKind::sets || !alive(writing.fate)) continue;
      any = true;
      row(too_weak ? "  hidden" : "  set()", style_name(writing.from), where(use.at),
          "set(" + one_line(use.at) + ", " + one_line(use.value) + ") in " +
              explained_.stories.speaker(use).full_name(),
          too_weak ? Ink::faint : Ink::plain);
    }
    if (!any)
      row("  not said", "set()", "in a rule", "set(" + story_.full_name() + ", …)", Ink::faint);
  }

  void command_line_row() {
    const bool given = outside_ && value_->giver == VariableValue::Giver::command_line;
    row(given ? "> in force" : "  not given", "--set", "command line",
        "--set " + story_.full_name() + "=" + (given ? printable(*value_->command_line) : "…"),
        given ? Ink::plain : Ink::faint);
  }

  // ---- elements and materials

  void entries() {
    alternatives("Elements", elements_of(explained_.style, story_),
                 story_.in_force() ? "they rest: it has rules" : "");
    alternatives("Materials", materials_of(explained_.style, story_),
                 material_draws(explained_.style, story_.name));
  }

  void alternatives(const std::string& title, const std::vector<Alternative>& all,
                    const std::string& remark) {
    if (all.empty()) return;
    section(remark.empty() ? title : title + ", " + remark);
    for (const Alternative& alternative : all) {
      const bool in_force = alternative.fate == Fate::in_force;
      std::string text = alternative.text;
      if (!in_force) {
        const bool set = alternative.ended.how == syntax::EntryKind::set;
        text += alternative.fate == Fate::dropped ? "  dropped by "
                : set                             ? "  replaced by "
                                                  : "  taken away by ";
        text += style_name(alternative.ended.from);
        if (!set) text += ", " + explained_.place(alternative.ended.at);
      }
      const std::string share = alternative.share.text();
      row(in_force ? "> " + (share.empty() ? "in force" : share) : "  hidden",
          style_name(alternative.from), where(alternative.at), text,
          in_force ? Ink::plain : Ink::faint);
    }
  }

  // ---- who speaks of whom

  void reads() {
    bool begun = false;
    for (const StoryUse& reading : readings(explained_.stories, story_)) {
      const Story& read = *reading.of;
      if (read.kind == MemberKind::symbol || reading.kind == UseKind::sets) continue;
      if (!std::exchange(begun, true)) section("Reads");
      const auto value = explained_.value(read);
      const Writing* writing = read.in_force();
      const bool outside = value && value->giver != VariableValue::Giver::style;
      const bool line = outside && value->giver == VariableValue::Giver::command_line;
      row("  " + title(read), outside ? (line ? "--set" : "property") : giver(writing),
          outside ? (line ? "command line" : "of the footprint")
                  : (writing ? where(writing->at()) : std::string()),
          value_text(value, writing), Ink::plain);
    }
  }

  static std::string giver(const Writing* writing) {
    return writing ? style_name(writing->from) : "nobody";
  }

  std::string value_text(const std::optional<VariableValue>& value, const Writing* writing) const {
    if (value && explained_.settled(*value)) return printable(*value->value);
    if (!writing) return {};
    if (const auto* variable = std::get_if<const syntax::Variable*>(&writing->syntax))
      return (*variable)->value ? one_line((*variable)->value->at) : std::string();
    return one_line(writing->at());
  }

  void uses(UseKind kind, const std::string& title) {
    std::set<std::pair<const Source*, uint32_t>> lines;
    std::size_t hidden = 0;
    bool begun = false;
    for (const Use& use : story_.uses) {
      if (use.kind != kind) continue;
      const Writing& writing = explained_.stories.writing(use);
      if (!lines.emplace(use.at.source, use.at.source->line_of(use.at.begin)).second) continue;
      if (!alive(writing.fate)) {
        ++hidden;
        continue;
      }
      if (!std::exchange(begun, true)) section(title);
      row("  " + mansard::title(explained_.stories.speaker(use)), style_name(writing.from),
          where(use.at), excerpt(use.at), Ink::plain);
    }
    if (hidden == 0) return;
    if (!begun) section(title);
    table_.line({"    " + counted(hidden, "place") + " in what is not in force", Ink::faint});
  }

  /// The line on which it stands, from a little before it when it is far behind.
  static std::string excerpt(Span at) {
    constexpr std::size_t near = 30, before = 10;
    const Source& source = *at.source;
    const uint32_t number = source.line_of(at.begin);
    const uint32_t begin = source.line_begin(number);
    const auto end = static_cast<uint32_t>(begin + source.line(number).size());
    if (one_line({&source, begin, at.end}).size() <= near) return one_line({&source, begin, end});
    std::size_t from =
        source.text().rfind(' ', at.begin - std::min(before, std::size_t(at.begin - begin)));
    if (from == std::string_view::npos || from < begin) from = at.begin;
    return "… " + one_line({&source, static_cast<uint32_t>(from), end});
  }

  const Explained& explained_;
  const Story& story_;
  const std::optional<VariableValue> value_;
  const bool outside_;  ///< the command line or a property gives it
  bool short_places_ = false;
  Table table_{3};
};

}  // namespace

std::string story_page(const Explained& explained, const Story& story) {
  return StoryPage(explained, story).text();
}

}  // namespace mansard
