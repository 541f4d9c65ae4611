#include "interpreter/properties.hpp"

#include <algorithm>
#include <cctype>
#include <optional>
#include <set>
#include <string>
#include <utility>

namespace mansard {

namespace {

class Misnamed {
 public:
  explicit Misnamed(const Program& program) {
    for (const VariableSlot& v : program.variables) {
      names_.insert(v.name);
      blocks_.insert(v.binding->block);
      (v.binding->block.empty() ? style_wide_ : in_blocks_).insert(v.binding->name);
    }
    blocks_.erase(std::string_view());
    for (uint32_t i = 0; i < program.properties.size(); ++i) read_.insert(program.properties[i]);
  }

  /// What to say of a property; nothing when it gives a variable its value, or looks like none.
  std::optional<Diagnostic> check(std::string_view name) const {
    const bool measures = name == "height" || name == "min_height";  // read for BUILDING_HEIGHT
    if (measures || names_.contains(name) || read_.contains(name)) return std::nullopt;
    const auto same =
        std::ranges::find_if(read_, [&](auto read) { return differ_in_case(read, name); });
    if (same != read_.end()) {
      return warning(
          "property '" + std::string(name) + "' is not '" + std::string(*same) +
              "', which a style reads",
          "names of properties are told apart by case: write '" + std::string(*same) + "'");
    }
    const auto dot = name.find('.');
    const auto help = dot == std::string_view::npos
                          ? bare(name)
                          : dotted(name.substr(0, dot), name.substr(dot + 1));
    if (!help) return std::nullopt;
    return warning("property '" + std::string(name) + "' gives no variable its value", *help);
  }

 private:
  using Words = std::set<std::string_view>;

  static Diagnostic warning(std::string text, std::string help) {
    Diagnostic d;
    d.severity = Severity::warning;
    d.code = "W021";
    d.text = std::move(text);
    d.help = std::move(help);
    return d;
  }

  static bool differ_in_case(std::string_view a, std::string_view b) {
    return std::ranges::equal(
        a, b, [](unsigned char x, unsigned char y) { return std::tolower(x) == std::tolower(y); });
  }

  static std::string_view nearest_in(const Words& words, std::string_view word) {
    if (words.contains(word)) return word;
    const std::vector<std::string_view> candidates(words.begin(), words.end());
    return nearest(word, candidates).value_or(std::string_view());
  }

  static std::string meant(std::string_view name) {
    return "did you mean '" + std::string(name) + "'?";
  }

  std::optional<std::string> dotted(std::string_view block, std::string_view name) const {
    const std::string_view near = nearest_in(blocks_, block);
    if (near.empty()) return std::nullopt;
    const std::string start = std::string(near) + ".";
    Words variables;
    for (const std::string_view full : names_) {
      if (full.starts_with(start)) variables.insert(full.substr(start.size()));
    }
    const std::string_view variable = nearest_in(variables, name);
    if (!variable.empty()) return meant(start + std::string(variable));
    if (near != block) return std::nullopt;
    return "block '" + std::string(block) + "' has no such variable";
  }

  std::optional<std::string> bare(std::string_view name) const {
    const auto is_upper = [](unsigned char c) { return std::isupper(c) != 0; };
    const auto is_lower = [](unsigned char c) { return std::islower(c) != 0; };
    const bool mixed = name.size() > 3 && is_upper(name[0]) && std::ranges::any_of(name, is_lower);
    if (!mixed) return std::nullopt;  // as variables are written, and the keys of maps are not
    if (in_blocks_.contains(name)) {
      return "a bare name is a variable of the style: write '" + std::string(block_of(name)) + "." +
             std::string(name) + "'";
    }
    const std::string_view near = nearest_in(style_wide_, name);
    return near.empty() ? std::nullopt : std::optional(meant(near));
  }

  std::string_view block_of(std::string_view name) const {
    for (const std::string_view full : names_) {
      const auto dot = full.find('.');
      if (dot != std::string_view::npos && full.substr(dot + 1) == name) return full.substr(0, dot);
    }
    return {};
  }

  Words names_, blocks_, style_wide_, in_blocks_;
  Words read_;  ///< by attr() and for variables
};

}  // namespace

std::vector<Diagnostic> misnamed_properties(const Program& program,
                                            std::span<const std::string> names) {
  const Misnamed misnamed(program);
  std::vector<Diagnostic> found;
  for (const std::string& name : names) {
    if (auto d = misnamed.check(name)) found.push_back(std::move(*d));
  }
  return found;
}

}  // namespace mansard
