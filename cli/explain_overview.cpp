// The page of a style: its order drawn, then every member with what is in force and what is not.
#include <algorithm>
#include <utility>

#include "cli/explain_lines.hpp"
#include "cli/order_drawing.hpp"
#include "cli/table.hpp"

namespace mansard {

namespace {

/// Rows of members under the headings of their blocks; a block without rows has no heading.
class MemberTable {
 public:
  explicit MemberTable(bool color) : color_(color) {}

  void begin(std::string heading) { heading_ = std::move(heading); }

  void add(const std::vector<MemberLine>& lines) {
    if (lines.empty()) return;
    if (!heading_.empty()) {
      table_.line();
      table_.line({std::exchange(heading_, {}), Ink::strong});
    }
    for (const MemberLine& line : lines) {
      const Ink ink = line.in_force ? Ink::plain : Ink::faint;
      table_.row({{"  " + line.label, ink},
                  {line.share, ink, true},
                  {line.what, ink},
                  {line.who, ink},
                  {line.where, Ink::faint}});
    }
  }

  std::string text() const { return table_.text(color_); }

 private:
  Table table_{2};
  std::string heading_;
  bool color_;
};

/// "Tile", and who replaces what it inherits.
std::string heading_of(const Explained& explained, std::string_view block) {
  std::string heading(block);
  for (const syntax::Style* style : explained.style.order) {
    for (const syntax::StyleMember& member : style->members) {
      const auto* written = std::get_if<syntax::Block>(&member);
      if (!written || !written->replace || written->name.text != block) continue;
      return heading + ", replaced by " + std::string(style->name.text) + ", " +
             explained.place(written->replace);
    }
  }
  return heading;
}

void add_block(MemberTable& table, const Explained& explained, std::string_view block) {
  for (const Story& story : explained.stories.all()) {
    if (block == "Elements")
      table.add(element_lines(explained, story));
    else if (block == "Materials")
      table.add(material_lines(explained, story));
    else if (story.block == block)
      table.add(lines_of(explained, story));
  }
}

std::string order_text(const Explained& explained) {
  if (explained.standings.size() < 2) return {};
  Table table(4);
  table.line();
  std::size_t place = 0;
  for (const DrawnLine& line : drawn_order(explained.standings)) {
    if (!line.standing) {
      table.row({{}, {line.lanes, Ink::faint}, {}, {}, {}});
      continue;
    }
    const syntax::Style& style = *line.standing->style;
    table.row({{"  " + std::to_string(place + 1), Ink::faint, true},
               {line.lanes},
               {std::string(style.name.text), place == 0 ? Ink::strong : Ink::plain},
               {full_place(style.name.at), Ink::faint},
               {why(explained.standings, place), Ink::faint}});
    ++place;
  }
  return table.text(explained.color);
}

std::string head(const Explained& explained) {
  const syntax::Style& style = *explained.style.syntax;
  Table table(0);
  table.row({{"style " + std::string(style.name.text), Ink::strong},
             {full_place(style.name.at), Ink::faint}});
  for (const Span& doc : style.pre.docs) table.line({"/// " + printable(doc.text()), Ink::faint});
  if (!explained.circumstances.empty()) table.line({explained.circumstances});
  if (!explained.style.missing.empty())
    table.line({"abstract: it can not be derived before a child gives what is missing"});
  return table.text(explained.color);
}

std::string block_head(const Explained& explained, std::string_view block) {
  Table table(0);
  table.line(
      {"style " + std::string(explained.style.name()) + ", block " + heading_of(explained, block),
       Ink::strong});
  if (!explained.circumstances.empty()) table.line({explained.circumstances});
  return table.text(explained.color);
}

/// Symbols that are drawn as they are, a few lines of names.
std::string terminals(const Explained& explained) {
  Table table(0);
  std::string line;
  const auto flush = [&] {
    if (!line.empty()) table.line({std::exchange(line, {})});
  };
  for (const Story& story : explained.stories.all()) {
    if (!story.terminal() || !story.writings.empty() || !story.elements.empty() ||
        !story.materials.empty())
      continue;
    if (table.empty() && line.empty()) {
      table.line();
      table.line({"Terminals without elements or materials", Ink::strong});
    }
    constexpr std::size_t page_width = 100;
    if (width_of(line) + story.name.size() + 4 > page_width) flush();
    line.append("  ").append(story.name);
  }
  flush();
  return table.empty() ? std::string() : table.text(explained.color);
}

}  // namespace

std::string overview_page(const Explained& explained, std::string_view block) {
  MemberTable table(explained.color);
  if (!block.empty()) {
    add_block(table, explained, block);
    return block_head(explained, block) + "\n" + table.text();
  }
  table.begin("Style-wide");
  add_block(table, explained, {});
  std::vector<std::string_view> blocks = explained.style.blocks;
  blocks.insert(blocks.end(), {"Elements", "Materials"});
  for (const std::string_view name : blocks) {
    table.begin(heading_of(explained, name));
    add_block(table, explained, name);
  }
  return head(explained) + order_text(explained) + table.text() + terminals(explained);
}

}  // namespace mansard
