#include "tests/mutants/mutants.hpp"

#include <algorithm>
#include <array>
#include <functional>

#include "grammar/parse.hpp"
#include "interpreter/function.hpp"
#include "interpreter/operation.hpp"
#include "tests/grammar/dump.hpp"

namespace mansard::test {

using layout::Kind;
using layout::Token;

// ---- originals

Original::Original(std::string path, const std::string& text)
    : path_(std::move(path)), source_(path_, text), tokens_(source_) {
  std::vector<uint32_t> open;
  for (uint32_t i = 0; i < tokens_.count(); ++i) {
    const std::string_view sign = tokens_[i].kind == Kind::sign ? tokens_[i].text : "";
    if (sign == ")" || sign == "]" || sign == "}") open.pop_back();
    around_.push_back(open.empty() ? i : open.back());
    if (sign == "(" || sign == "[" || sign == "{") open.push_back(i);
  }
}

std::string_view Original::operation_of(uint32_t bracket) const {
  if (bracket == 0) return {};
  uint32_t name = bracket - 1;
  if (tokens_[name].text == ")") name = tokens_[name].match - 1;
  const bool known = find_operation(tokens_[name].text) && tokens_[name].kind == Kind::word;
  return known ? tokens_[name].text : std::string_view{};
}

bool Original::has(std::string_view word, std::string_view next) const {
  for (uint32_t i = 1; i < tokens_.count(); ++i) {
    if (tokens_[i - 1].text == word && tokens_[i].text == next) return true;
  }
  return false;
}

Mutant Original::replaced(uint32_t first, uint32_t last, const std::string& with) const {
  std::string text(source_.text());
  const uint32_t begin = tokens_[first].begin, end = tokens_[last].end;
  text.replace(begin, end - begin, with);
  return {{}, path_, text, source_.line_of(begin), {}};
}

std::string misspelt(std::string_view word, std::mt19937& random) {
  std::string made(word);
  while (made == word) {
    made = word;
    const std::size_t at = 1 + random() % (word.size() - 2);
    switch (random() % 3) {
      case 0:
        std::swap(made[at], made[at + 1]);
        break;
      case 1:
        made.erase(at, 1);
        break;
      default:
        made.insert(at, 1, made[at]);
    }
  }
  return made;
}

namespace {

/// What one kind of slip makes of a place in a script.
class Place {
 public:
  Place(const Original& from, uint32_t token, std::mt19937& random, std::vector<Mutant>& into)
      : from_(from), i_(token), random_(random), into_(into) {}

  const Token& operator[](int offset) const {
    static const Token nothing;
    const int64_t at = static_cast<int64_t>(i_) + offset;
    const bool inside = at >= 0 && at < static_cast<int64_t>(from_.tokens().count());
    return inside ? from_.tokens()[static_cast<uint32_t>(at)] : nothing;
  }
  const Token& token() const { return (*this)[0]; }
  std::string_view text() const { return token().text; }
  bool is_sign(std::string_view sign) const { return token().kind == Kind::sign && text() == sign; }
  bool is_word() const { return token().kind == Kind::word; }
  const Original& script() const { return from_; }
  uint32_t index() const { return i_; }
  uint32_t around() const { return from_.around(i_); }

  using Causes = std::vector<std::vector<std::string>>;
  void make(int first, int last, const std::string& with, Causes causes) const {
    Mutant mutant =
        from_.replaced(i_ + static_cast<uint32_t>(first), i_ + static_cast<uint32_t>(last), with);
    mutant.causes = std::move(causes);
    into_.push_back(std::move(mutant));
  }
  void replace(const std::string& with, Causes causes) const {
    make(0, 0, with, std::move(causes));
  }
  /// The message says what the word is and what it should be.
  void misspell() const {
    if (text().size() < 3) return;
    const std::string wrong = misspelt(text(), random_);
    replace(wrong, {{wrong, std::string(text())}});
  }
  void add(Mutant mutant) const { into_.push_back(std::move(mutant)); }

 private:
  const Original& from_;
  uint32_t i_;
  std::mt19937& random_;
  std::vector<Mutant>& into_;
};

struct Slip {
  std::string kind;
  std::function<void(const Place&)> at;
};

std::string quoted(std::string_view text) { return "'" + std::string(text) + "'"; }
// ---- signs that are missing, or there twice

Place::Causes names_bracket(std::string_view sign) {
  Place::Causes causes{{quoted(sign)}};
  for (const std::string_view pair : {"()", "[]", "{}"}) {
    if (pair.find(sign) == pair.npos) continue;
    causes.push_back({"this '" + std::string(pair.substr(0, 1)) + "' is still open"});
    causes.push_back({"this '" + std::string(pair.substr(1, 1)) + "' closes nothing"});
  }
  return causes;
}

Slip deleted(const std::string& sign) {
  return {"deleted " + quoted(sign), [sign](const Place& place) {
            if (place.is_sign(sign)) place.replace("", names_bracket(sign));
          }};
}

// Two parts may also be one part of two symbols, but not where every part has a size or a name.
Slip deleted_bar() {
  return {"deleted '|'", [](const Place& place) {
            const std::string_view operation = place.script().operation_of(place.around());
            const bool labelled =
                operation == "comp" || operation == "roof" || operation == "split";
            const layout::Tokens& tokens = place.script().tokens();
            uint32_t bars = 0;  // a single part serves any number of sizes
            for (uint32_t i = place.around(); i < tokens[place.around()].match; ++i)
              bars += tokens[i].text == "|" && place.script().around(i) == place.around();
            if (place.is_sign("|") && (labelled || (operation == "subdiv" && bars > 1)))
              place.replace("", {{"'|'"}, {"sizes", "parts"}, {"parts", "'subdiv'"}});
          }};
}

Slip doubled(const std::string& sign) {
  return {"doubled " + quoted(sign), [sign](const Place& place) {
            if (place.is_sign(sign) && place.index() > 0)
              place.replace(sign + " " + sign, names_bracket(sign));
          }};
}

// ---- words that are misspelt

bool is_label(const Place& place) {
  return (place[-1].text == "{" || place[-1].text == "|") && place[1].text == ":";
}

void add_misspelt(std::vector<Slip>& all) {
  const auto when = [&](const std::string& kind, auto is) {
    all.push_back({"misspelt " + kind, [is](const Place& place) {
                     if (place.is_word() && is(place)) place.misspell();
                   }});
  };
  when("operation", [](const Place& p) {
    return find_operation(p.text()) && (p[1].text == "(" || p[1].text == "{");
  });
  when("function", [](const Place& p) {
    return find_function(p.text()) && !find_operation(p.text()) && p[1].text == "(";
  });
  when("variable", [](const Place& p) {
    return p.script().has("var", p.text()) && p[-1].text != "var" && p[-1].text != "." &&
           p[1].text != "{" && !is_label(p);
  });
  when("emitted symbol", [](const Place& p) {  // a short one may be meant
    const bool is_head = p[1].text == "->" || p[1].text == ":";
    return p.text().size() > 5 && p.script().has(p.text(), "->") && !is_head && p[1].text != "(" &&
           p[1].text != "[" && p[1].text != "{" && p[-1].text != "::";  // "{": a block
  });
  when("overriding symbol", [](const Place& p) { return p[-1].text == "override"; });
  when("keyword", [](const Place& p) { return p.token().keyword && p.text() != "super"; });
  when("block", [](const Place& p) {
    return (p.text() == "Elements" || p.text() == "Materials") && p[1].text == "{";
  });
  when("qualified name", [](const Place& p) { return p[-1].text == "." || p[1].text == "."; });
  when("parent", [](const Place& p) {
    return p.script().around(p.index()) == p.index() && (p[-1].text == ":" || p[-1].text == ",");
  });
  when("other style", [](const Place& p) { return p[1].text == "::"; });
  when("named argument",
       [](const Place& p) { return p[1].text == "=" && (p[-1].text == "(" || p[-1].text == ","); });
  when("part", [](const Place& p) {
    const std::string_view operation = p.script().operation_of(p.around());
    return is_label(p) && !operation.empty() && operation != "comp" && operation != "split";
  });
  when("selector",
       [](const Place& p) { return is_label(p) && p.script().operation_of(p.around()) == "comp"; });
}

// ---- values of the wrong kind

bool is_argument(const Place& place) {
  const Original& script = place.script();
  return !script.operation_of(place.around()).empty() &&
         script.tokens()[place.around()].text == "(";
}

void add_values(std::vector<Slip>& all) {
  all.push_back({"text for a number", [](const Place& p) {
                   if (p.token().kind != Kind::number || !is_argument(p)) return;
                   if (p[1].text != "," && p[1].text != ")") return;
                   p.replace("\"" + std::string(p.text()) + "\"",
                             {{"number", "text"}, {"number", "string"}, {"size", "string"}});
                 }});
  all.push_back({"a number for text", [](const Place& p) {
                   const std::string_view operation = p.script().operation_of(p.around());
                   const bool angle =
                       p[-1].text == "(" &&
                       (operation == "subdiv" || operation == "repeat" || operation == "split" ||
                        operation == "comp");  // a number chooses, too
                   if (p.token().kind == Kind::text && is_argument(p) && !angle)
                     p.replace("7", {{"text"}, {"string"}, {"colour name"}});
                 }});
  all.push_back({"one size too few", [](const Place& p) {
                   if (p.script().operation_of(p.around()) != "subdiv" || !is_argument(p)) return;
                   const bool more = p[-4].text != "(" && p[1].text == ")";
                   if (more && p.token().kind == Kind::number && p[-1].text == ",")
                     p.make(-1, 0, "", {{"size", "parts"}});
                 }});
  all.push_back({"one part too many", [](const Place& p) {
                   if (p.is_sign("|") && p.script().operation_of(p.around()) == "subdiv")
                     p.replace("| WALL |", {{"sizes", "parts"}});
                 }});
  all.push_back({"arguments swapped", [](const Place& p) {
                   const bool simple = p.token().kind == Kind::text && p[1].text == "," &&
                                       p[2].kind == Kind::number;
                   if (simple && is_argument(p))
                     p.make(0, 2, std::string(p[2].text) + ", " + std::string(p.text()),
                            {{"text"}, {"string"}, {"axis"}});
                 }});
  all.push_back({"wrong unit", [](const Place& p) {
                   if (p.token().kind != Kind::number) return;
                   std::string wrong(p.text());
                   if (wrong.back() == 'r' || wrong.back() == '%') wrong.pop_back();
                   p.replace(wrong + (p.text() == wrong ? "m" : "R"),
                             {{"a number ends before a letter"}});
                 }});
  all.push_back(
      {"decimal comma", [](const Place& p) {
         const std::size_t point = p.text().find('.');
         if (p.token().kind != Kind::number || point == p.text().npos) return;
         const std::string_view call = p.script().tokens()[p.around() - 1].text;
         if (call == "min" || call == "max") return;  // take any number of numbers
         std::string wrong(p.text());
         wrong[point] = ',';
         p.replace(
             wrong,
             {{"decimal"}, {"','"}, {"sizes", "parts"}, {"too many"}, {"at most"}, {"arguments"}});
       }});
  all.push_back({"unclosed string", [](const Place& p) {
                   if (p.token().kind == Kind::text)
                     p.replace(std::string(p.text().substr(0, p.text().size() - 1)),
                               {{"not closed"}, {"is a '\"' missing"}});
                 }});
}

// ---- words of other languages, words in another order, files that are cut off

/// The line that shows it is the first that names a style of the file that is not imported, the
/// only one.
void without_import(const Place& p) {
  const Original& script = p.script();
  const layout::Tokens& tokens = script.tokens();
  for (uint32_t i = 0; i < tokens.count(); ++i) {
    if (i != p.index() && tokens[i].text == "import") return;
  }
  const auto is_style = [&](uint32_t i) {
    const bool parent =
        script.around(i) == i && (tokens[i - 1].text == ":" || tokens[i - 1].text == ",");
    if (tokens[i].kind != Kind::word || (!parent && tokens[i + 1].text != "::")) return false;
    for (uint32_t j = 1; j < tokens.count(); ++j) {
      if (tokens[j].text == tokens[i].text && tokens[j - 1].text == "style") return false;
    }
    return true;
  };
  for (uint32_t i = p.index() + 2; i + 1 < tokens.count(); ++i) {
    if (!is_style(i)) continue;
    Mutant mutant = script.replaced(p.index(), p.index() + 1, "");
    mutant.line = script.line(i);
    mutant.causes = {{quoted(tokens[i].text), "import"}};
    return p.add(std::move(mutant));
  }
}

void add_rest(std::vector<Slip>& all) {
  const auto foreign = [&](const std::string& right, const std::string& wrong, std::string cause) {
    all.push_back({"'" + wrong + "' for '" + right + "'", [=](const Place& p) {
                     if (p.is_sign(right)) p.replace(wrong, {{cause}});
                   }});
  };
  foreign("->", "=>", "'->'");
  foreign("==", "=", "'=='");
  foreign("&&", "and", "'&&'");
  foreign("||", "or", "'||'");
  foreign("=", "==", "'='");
  all.push_back({"';' behind a variable", [](const Place& p) {
                   if (p[-1].text == "=" && p[-3].text == "var" && p[1].line_before)
                     p.replace(std::string(p.text()) + ";", {{"';'"}});
                 }});
  all.push_back({"single quotes", [](const Place& p) {
                   if (p.token().kind != Kind::text) return;
                   const std::string inner(p.text().substr(1, p.text().size() - 2));
                   p.replace("'" + inner + "'", {{"double quotes"}});
                 }});
  all.push_back({"arrow before its symbol", [](const Place& p) {
                   if (p.is_sign("->") && p[-1].kind == Kind::word)
                     p.make(-1, 0, "-> " + std::string(p[-1].text), {{"'->'"}});
                 }});
  all.push_back({"name before 'var'", [](const Place& p) {
                   if (p.text() == "var")
                     p.make(0, 1, std::string(p[1].text) + " var", {{"'var'"}, {"var NAME"}});
                 }});
  all.push_back({"doubled keyword", [](const Place& p) {
                   if (p.token().keyword)
                     p.replace(std::string(p.text()) + " " + std::string(p.text()),
                               {{quoted(p.text())}});
                 }});
  all.push_back({"missing import", [](const Place& p) {
                   if (p.text() == "import") without_import(p);
                 }});
  all.push_back({"cut-off file", [](const Place& p) {
                   if (p.around() == p.index()) return;
                   const Original& script = p.script();
                   p.add({{},
                          script.path(),
                          script.text().substr(0, p.token().end),
                          script.line(p.index()),
                          {{"end of the file"}, {"is still open"}, {"not closed"}}});
                 }});
}

std::vector<Slip> slips() {
  std::vector<Slip> all;
  for (const char* const sign : {"{", "}", "(", ")", "[", "]", ",", "->", ":", "="})
    all.push_back(deleted(sign));
  all.push_back(deleted_bar());
  for (const char* const sign : {"{", "}", "(", ")", "|", ",", "->", ":"})
    all.push_back(doubled(sign));
  add_misspelt(all);
  add_values(all);
  add_rest(all);
  return all;
}

bool same_meaning(const Original& original, const Mutant& mutant) {
  Diagnostics diagnostics;
  const Source before(mutant.path, original.text()), now(mutant.path, mutant.text);
  const std::string tree = dump(parse(now, diagnostics));
  return !diagnostics.has_errors() && tree == dump(parse(before, diagnostics));
}

}  // namespace

std::vector<Mutant> mutants(const std::deque<Original>& originals, uint32_t seed,
                            std::size_t each) {
  std::vector<Mutant> chosen;
  for (const Slip& slip : slips()) {
    std::mt19937 random(seed);
    std::vector<std::pair<Mutant, const Original*>> all;
    for (const Original& original : originals) {
      std::vector<Mutant> made;
      for (uint32_t i = 0; i + 1 < original.tokens().count(); ++i)
        slip.at(Place(original, i, random, made));
      for (Mutant& mutant : made) all.emplace_back(std::move(mutant), &original);
    }
    for (std::size_t left = each; left > 0 && !all.empty();) {
      std::swap(all[random() % all.size()], all.back());
      auto [mutant, original] = std::move(all.back());
      all.pop_back();
      if (same_meaning(*original, mutant)) continue;
      mutant.kind = slip.kind;
      chosen.push_back(std::move(mutant));
      --left;
    }
  }
  return chosen;
}

}  // namespace mansard::test
