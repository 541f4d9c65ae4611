#include "cli/vary_child.hpp"

#include <algorithm>

#include "styles/library.hpp"

namespace mansard {
namespace {

std::string two_digits(std::size_t number) {
  return (number < 10 ? "0" : "") + std::to_string(number);
}

/// What may stand in a file's name anywhere.
std::string file_words(std::string_view text) {
  constexpr std::size_t longest = 60;
  std::string words;
  for (const char c : text) {
    const bool is_plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') ||
                          (c >= '0' && c <= '9') || c == '_' || c == '.';
    if (is_plain) {
      words += c;
    } else if (!words.empty() && words.back() != '-') {
      words += '-';
    }
  }
  words.resize(std::min(words.size(), longest));
  while (words.ends_with('-') || words.ends_with('.')) words.pop_back();
  return words;
}

std::string free_style_name(const std::string& base, std::size_t number, const Library& library) {
  std::string name = base + "_" + two_digits(number);
  while (library.find(name)) name += "_";
  return name;
}

std::string escaped(std::string_view text) {
  std::string out;
  for (const char c : text) {
    if (c == '"' || c == '\\') out += '\\';
    out += c;
  }
  return out;
}

/// The changes, those of one block together: `Tile { var A = 1  var B = 2 } var Height = 9 `.
std::string members(const std::vector<Change>& changes) {
  std::vector<std::pair<std::string, std::string>> blocks;
  for (const Change& change : changes) {
    const auto dot = change.name.find('.');
    const std::string block = dot == std::string::npos ? "" : change.name.substr(0, dot);
    const std::string name = dot == std::string::npos ? change.name : change.name.substr(dot + 1);
    auto it = std::ranges::find(blocks, block, &std::pair<std::string, std::string>::first);
    if (it == blocks.end()) it = blocks.insert(it, {block, ""});
    it->second += "var " + name + " = " + change.value + " ";
  }
  std::string text;
  for (const auto& [block, variables] : blocks)
    text += block.empty() ? variables : block + " { " + variables + "} ";
  return text;
}

}  // namespace

Child child_of(const Variation& variation, std::size_t number, const std::string& import,
               const Library& library) {
  Child child;
  child.stem = two_digits(number);
  if (const std::string words = file_words(variation.caption); !words.empty())
    child.stem += "-" + words;
  child.style = free_style_name(variation.base, number, library);
  child.text = std::string(child_mark) + "\nimport \"" + escaped(import) + "\"\n";
  if (variation.seed) child.text += "@seed(" + std::to_string(*variation.seed) + ") ";
  child.text +=
      "style " + child.style + " : " + variation.base + " { " + members(variation.changes) + "}\n";
  return child;
}

}  // namespace mansard
