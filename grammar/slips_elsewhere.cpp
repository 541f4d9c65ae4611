#include "grammar/slips_elsewhere.hpp"

#include <algorithm>
#include <array>

#include "grammar/in_quotes.hpp"
#include "grammar/parse.hpp"

namespace mansard {
namespace {

constexpr std::string_view blanks = " \t\r\n";

bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_in(std::string_view word, std::initializer_list<std::string_view> words) {
  return std::ranges::find(words, word) != words.end();
}

/// The place, with what stands around it.
struct Scene {
  explicit Scene(const Stuck& s) : stuck(s) {
    const std::size_t end = stuck.text.substr(0, stuck.at).find_last_not_of(blanks);
    before_end = end == stuck.text.npos ? 0 : end + 1;
    behind = stuck.text.substr(std::min(stuck.at + stuck.found.size(), stuck.text.size()));
  }

  /// The word, number or sign that ends before the place.
  std::string_view before() const {
    std::size_t begin = before_end;
    const auto belongs = [&](char c) { return Reading::is_word(c) || c == '.'; };
    while (begin > 0 && belongs(stuck.text[begin - 1])) --begin;
    if (begin == before_end && begin > 0) --begin;
    return stuck.text.substr(begin, before_end - begin);
  }
  bool name_before() const {
    const std::string_view word = before();
    return !word.empty() && Reading::is_word(word[0]) && !is_digit(word[0]);
  }
  bool value_before() const {
    const std::string_view word = before();
    return !word.empty() && (is_digit(word[0]) || word[0] == '"');
  }
  char first() const { return stuck.found.empty() ? '\0' : stuck.found[0]; }
  bool starts_word() const { return Reading::is_word(first()) && !is_digit(first()); }

  std::string_view next() const {
    const std::size_t at = behind.find_first_not_of(blanks);
    return at == behind.npos ? std::string_view{} : behind.substr(at);
  }
  /// `= 1.0` and no comparison.
  bool assigns(std::string_view rest) const {
    return rest.starts_with('=') && !rest.starts_with("==");
  }
  /// The value that ends with its line, a ';' or a '}'; "value" when it is long.
  static std::string value_in(std::string_view rest) {
    constexpr std::size_t longest = 40;
    std::string_view value = rest.substr(0, rest.find_first_of("\n;}"));
    const std::size_t begin = value.find_first_not_of(blanks);
    if (begin == value.npos) return "value";
    value = value.substr(begin, value.find_last_not_of(blanks) + 1 - begin);
    return value.size() > longest || value.find("//") != value.npos ? "value" : std::string(value);
  }
  /// What stands behind the member's first word, up to the place.
  std::string_view of_member() const {
    if (stuck.word.empty()) return {};
    const auto end =
        static_cast<std::size_t>(stuck.word.data() - stuck.text.data()) + stuck.word.size();
    return end <= stuck.at ? stuck.text.substr(end, stuck.at - end) : std::string_view{};
  }

  const Stuck& stuck;
  std::size_t before_end = 0;
  std::string_view behind;
};

std::string variable(std::string_view name, const std::string& value) {
  return "a variable is written: var " + std::string(name) + " = " + value;
}

std::string of_file(const Scene& scene) {
  const Stuck& stuck = scene.stuck;
  if (stuck.level != Level::file) return {};
  const std::string_view next = scene.next();
  if (stuck.word == "import" && stuck.wanted("a string") && scene.starts_word()) {
    return "the name of a file stands in quotes: import \"" + std::string(stuck.found) + ".style\"";
  }
  if (is_in(stuck.found, {"include", "use", "using", "require", "load"}) ||
      (stuck.found == "#" && next.starts_with("include"))) {
    return "another script is read by: import \"house.style\"";
  }
  if (stuck.wanted("'style' or 'import'") && stuck.found == ".")
    return "a style begins with its word: style " + std::string(found_at(next, 0)) + " { … }";
  if (stuck.wanted("'style' or 'import'") && scene.starts_word() &&
      (next.starts_with('{') || next.starts_with(':'))) {
    return "a style begins with its word: style " + std::string(stuck.found) + " …";
  }
  if (stuck.wanted("'{'") && is_in(stuck.found, {"(", "<"}))
    return "a parent stands behind a ':': style Mine : House { … }";
  if (stuck.wanted("'{'") && stuck.wanted("','") && (scene.starts_word() || stuck.found == "&"))
    return "several parents are separated by ',': style Mine : Cornice, House { … }";
  if (stuck.wanted("'{'") && stuck.found == "-")
    return "names are of ASCII letters, digits and '_'";
  if (stuck.wanted("a name") && scene.first() == '"') return "a name bears no quotes";
  return {};
}

std::string of_variables(const Scene& scene) {
  const Stuck& stuck = scene.stuck;
  if (stuck.level == Level::elements || stuck.level == Level::materials) return {};
  const std::string_view next = scene.next();
  if (stuck.found == "." && stuck.open != '(' && scene.name_before()) {
    // `var Tile.Width = 1`, `Tile.Width = 1`
    const std::string_view name = found_at(next, 0);
    const std::size_t equals = scene.behind.find_first_not_of(blanks, name.size());
    const bool given = equals != scene.behind.npos && scene.assigns(scene.behind.substr(equals));
    if ((stuck.word == "var" || stuck.word == scene.before()) && given) {
      return "the variable of a block is written in the block: " + std::string(scene.before()) +
             " { var " + std::string(name) + " = " +
             Scene::value_in(scene.behind.substr(equals + 1)) + " }";
    }
  }
  if (stuck.word == "var" && stuck.found == ":" && stuck.wanted("'='"))
    return variable(scene.before(), Scene::value_in(next));
  if (stuck.wanted("'->'") && scene.starts_word() && scene.assigns(next) &&
      stuck.word == scene.before()) {
    return variable(stuck.found, Scene::value_in(next.substr(1)));  // `let Width = 1`
  }
  const std::string_view written = scene.of_member();
  if (stuck.wanted("'->'") && is_digit(scene.first()) &&
      written.find_first_not_of(blanks) == written.npos && !stuck.word.empty()) {
    return variable(stuck.word, std::string(stuck.found));  // `Width 1.0`
  }
  if (stuck.wanted("'->'") && written.starts_with(':')) {  // `Width: 1.0;`
    const std::string value = Scene::value_in(written.substr(1));
    const bool literal = is_digit(value[0]) || value[0] == '"' || stuck.found == ";";
    if (literal && value.find('=') == value.npos) return variable(stuck.word, value);
  }
  if (stuck.word == "def" && stuck.found == "=" && stuck.wanted("'('"))
    return variable(scene.before(), Scene::value_in(next)) + ", a function: def name(a) = value";
  return {};
}

std::string of_commas(const Scene& scene) {
  const Stuck& stuck = scene.stuck;
  if (stuck.found != "," || stuck.level == Level::file) return {};
  if (stuck.open == '{' && stuck.wanted("'|'")) return "parts are separated by '|': { A | B }";
  const std::size_t line = stuck.text.rfind('\n', stuck.at == 0 ? 0 : stuck.at - 1) + 1;
  const std::string_view so_far = stuck.text.substr(line, stuck.at - line);
  if (stuck.open != '{' || so_far.find("var ") == so_far.npos) return {};
  const bool decimal = scene.value_before() && !scene.behind.empty() && is_digit(scene.behind[0]) &&
                       scene.before_end == stuck.at;
  if (decimal)
    return "decimals have a point: " + std::string(scene.before()) + "." +
           std::string(found_at(scene.behind, 0));
  return "no ',' is needed between variables";
}

std::string of_arguments(const Scene& scene) {
  const Stuck& stuck = scene.stuck;
  if (stuck.found.starts_with("\xC2\xB0")) return "angles are in degrees and bear no unit";
  if (stuck.open != '(' || !stuck.wanted("','") || stuck.level == Level::file) return {};
  if (stuck.found == ":" && scene.name_before()) {
    return "an argument with a name is written: " + std::string(scene.before()) + " = " +
           std::string(found_at(scene.next(), 0));
  }
  const bool begins =
      (Reading::is_word(scene.first()) && stuck.found != "r") || scene.first() == '"';
  if (begins && (scene.value_before() || (scene.starts_word() && scene.assigns(scene.next()))))
    return "is a ',' missing before this?";
  return {};
}

std::string of_parts(const Scene& scene) {
  const Stuck& stuck = scene.stuck;
  if (stuck.level != Level::rules || stuck.open != '{' || !stuck.wanted("'|'")) return {};
  if (!scene.name_before()) return {};
  const std::string word(scene.before());
  if (stuck.found == "=") return "a part is written with a ':': " + word + " : NAME";
  if (stuck.found != ":") return {};
  const std::string_view front = stuck.text.substr(0, scene.before_end - word.size());
  const std::size_t last = front.find_last_not_of(blanks);
  if (last == front.npos ||
      (!Reading::is_word(front[last]) && front[last] != ')' && front[last] != '}'))
    return {};
  return "is a '|' missing before '" + word + "'?";
}

std::string of_materials(const Scene& scene) {
  const Stuck& stuck = scene.stuck;
  if (stuck.level != Level::materials || !is_name(stuck.word) || stuck.word == "per") return {};
  const bool is_look = is_in(
      stuck.word, {"color", "texture", "metres", "opacity", "roughness", "metallic", "normals"});
  const std::string name = is_look ? "WALL" : std::string(stuck.word);
  const bool head = stuck.wanted("':'") && (is_in(stuck.found, {"{", "->", "="}) ||
                                            is_in(stuck.found, {"color", "texture"}));
  const bool look = stuck.wanted("a look like color(\"#a08070\")") &&
                    (stuck.found == "#" || scene.first() == '"');
  const bool bare = stuck.wanted("'('") && stuck.open == '{';
  if (!head && !look && !bare) return {};
  const std::string color = look && scene.first() == '"' ? std::string(stuck.found)
                            : look ? "\"#" + std::string(found_at(scene.behind, 0)) + "\""
                                   : "\"#445566\"";
  return "an entry is written: " + name + " : color(" + color + ")";
}

}  // namespace

std::string explain_habit(const Stuck& stuck) {
  const Scene scene(stuck);
  const bool is_member = !stuck.word.empty() && stuck.word.data() == stuck.found.data();
  if (is_member && stuck.level == Level::style && stuck.wanted("'var' or 'def'")) {
    return "'override' stands before a rule or a variable, inside of its block: " +
           std::string(stuck.found) + " { override … }";
  }
  for (const auto& explain :
       {of_file, of_variables, of_commas, of_arguments, of_parts, of_materials}) {
    if (std::string help = explain(scene); !help.empty()) return help;
  }
  return {};
}

}  // namespace mansard
