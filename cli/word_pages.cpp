#include "cli/word_pages.hpp"

#include <algorithm>

#include "cli/argument_table.hpp"
#include "cli/command.hpp"
#include "cli/vocabulary.hpp"
#include "interpreter/attribute_table.hpp"
#include "interpreter/selectors.hpp"
#include "styles/annotations.hpp"

namespace mansard {
namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// The sign in `1r`, `30%`, `~1.2`, `House::ROOF`; else the word as it is.
std::string_view sign_in(std::string_view word) {
  if (word.starts_with('~')) return "~";
  if (word.size() > 2 && word.find("::") != word.npos) return "::";
  const bool counts = !word.empty() && (is_digit(word[0]) || word[0] == '(');
  if (counts && word.ends_with('r')) return "r";
  if (counts && word.ends_with('%')) return "%";
  return word;
}

class Page {
 public:
  explicit Page(std::string_view word) : word_(word) {}

  std::string text() {
    language();
    operations_with();
    annotation();
    flags();
    return text_;
  }

 private:
  void add(std::string_view title, std::string_view summary, std::string_view topic) {
    text_ += text_.empty() ? "" : "\n";
    text_.append(title).append("\n    ").append(summary).append("\n");
    if (!topic.empty()) text_.append("    more: mansard help ").append(topic).append("\n");
  }

  void language() {
    if (const WordRow* row = find_word(word_)) add(row->name, row->summary, row->topic);
    const std::string_view sign = sign_in(word_);
    if (const WordRow* row = find_sign(sign)) add(word_, row->summary, row->topic);
    if (const AttributeRow* row = find_attribute(word_))
      add(std::string(word_) + ", in expressions", row->summary, "attributes");
    if (const InputRow* row = find_input(word_))
      add(std::string(word_) + ", in expressions", row->summary, "variables");
    if (const auto selector = find_selector(word_)) {
      add(std::string(word_) + ", a selector: comp { " + std::string(word_) + " : PART }",
          selector_summary(*selector), "selectors");
    }
  }

  void operations_with() {
    for (const Operation& o : operations()) {
      const std::string of = " of " + usage(o);
      for (std::size_t i = 0; i < o.count; ++i) {
        const std::string_view name = o.parameter_name(i), summary = argument_summary(o, name);
        if (name == word_) add(std::string(word_) + ", an argument" + of, summary, o.name);
        if (summary.find("\"" + std::string(word_) + "\"") != summary.npos)
          add("\"" + std::string(word_) + "\", for the " + std::string(name) + of, summary, o.name);
      }
      for (std::size_t i = 0; i < parts_in(o.parts); ++i) {
        const std::string_view name = part_name(o.parts, i);
        if (name == word_) add(std::string(word_) + ", a part" + of, part_summary(o, name), o.name);
      }
    }
  }

  void annotation() {
    const bool marked = word_.starts_with('@');
    const AnnotationRow* const row = find_annotation_row(word_.substr(marked ? 1 : 0));
    if (row) add(usage(*row), row->summary, "annotations");
  }

  /// `--camera`, and `camera` where that means nothing else.
  void flags() {
    if (!word_.starts_with('-') && !text_.empty()) return;
    std::vector<std::pair<const Flag*, std::string>> found;
    for (const Command& command : commands()) {
      for (const Flag& flag : command.flags) {
        if (!is_named(flag)) continue;
        const auto same = std::ranges::find_if(
            found, [&](const auto& known) { return known.first->summary == flag.summary; });
        if (same == found.end()) {
          found.emplace_back(&flag, command.name);
        } else {
          same->second.append(", ").append(command.name);
        }
      }
    }
    for (const auto& [flag, users] : found) {
      const std::string value = flag->value.empty() ? "" : " " + std::string(flag->value);
      add(std::string(flag->name) + value + ", a flag of " + users, flag->summary,
          users.substr(0, users.find(',')));
    }
  }

  bool is_named(const Flag& flag) const {
    const auto comma = std::min(flag.name.find(','), flag.name.size());
    for (const std::string_view name :
         {flag.name.substr(0, comma), flag.name.substr(std::min(comma + 1, flag.name.size()))}) {
      if (!name.empty() && (name == word_ || name == "--" + std::string(word_))) return true;
    }
    return false;
  }

  std::string_view word_;
  std::string text_;
};

/// Without the quotes that a script writes around it.
std::string_view bare(std::string_view word) {
  if (word.size() > 2 && word.starts_with('"') && word.ends_with('"'))
    word = word.substr(1, word.size() - 2);
  return word;
}

}  // namespace

std::string word_page(std::string_view word) { return Page(bare(word)).text(); }

std::vector<std::string_view> words_with_pages() {
  std::vector<std::string_view> all;
  for (const WordRow& row : word_rows()) all.push_back(row.name);
  for (const AttributeRow& row : attributes()) all.push_back(row.name);
  for (const InputRow& row : inputs()) all.push_back(row.name);
  all.insert(all.end(), selector_words.begin(), selector_words.end());
  for (const Operation& o : operations()) {
    for (std::size_t i = 0; i < o.count; ++i) all.push_back(o.parameter_name(i));
    for (std::size_t i = 0; i < parts_in(o.parts); ++i) all.push_back(part_name(o.parts, i));
  }
  for (const AnnotationRow& row : annotation_rows()) all.push_back(row.name);
  for (const Command& command : commands()) {
    for (const Flag& flag : command.flags)
      all.push_back(
          flag.name.substr(flag.name.find(',') == flag.name.npos ? 0 : flag.name.find(',') + 1));
  }
  return all;
}

}  // namespace mansard
