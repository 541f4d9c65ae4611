#include "cli/vary_sweep.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "cli/arguments.hpp"
#include "grammar/enumerate.hpp"
#include "grammar/in_quotes.hpp"
#include "grammar/parse.hpp"
#include "interpreter/number_wanted.hpp"
#include "styles/library.hpp"

namespace mansard {
namespace {

constexpr std::size_t enough = 9;  // values of a range, when nobody has asked for more

[[noreturn]] void refuse(std::string text, std::string help, Span at = {}) {
  Diagnostic d;
  d.at = at;
  d.text = std::move(text);
  d.help = std::move(help);
  throw Failure(std::move(d));
}

// ---- names

const VariableBinding* find_variable(const std::string& name, const LinkedStyle& style) {
  const auto dot = name.find('.');
  return dot == std::string::npos ? style.find_variable({}, name)
                                  : style.find_variable(name.substr(0, dot), name.substr(dot + 1));
}

/// "add --style House": the styles that have a variable which this one lacks.
std::string of_other_styles(const std::string& name, const LinkedStyle& style,
                            const Library& library) {
  std::vector<std::string> others;
  for (const syntax::Style* other : library.styles()) {
    Diagnostics quiet;
    if (other->name.text == style.name()) continue;
    const auto linked = link(library, *other, quiet);
    if (linked && find_variable(name, *linked)) others.push_back(in_quotes(other->name.text));
  }
  if (others.empty()) return {};
  const std::string first = others.front().substr(1, others.front().size() - 2);
  return (others.size() == 1 ? "style " : "styles ") + enumerate(others, "and") +
         (others.size() == 1 ? " has it" : " have it") + ": add --style " + first;
}

/// `Width` of the blocks that have one, or what looks like the name.
std::string other_names(const std::string& name, std::string_view flag, const LinkedStyle& style) {
  std::vector<std::string> names, of_blocks;
  for (const VariableBinding& v : style.variables) {
    names.push_back((v.block.empty() ? "" : std::string(v.block) + ".") + std::string(v.name));
    if (v.name == name) of_blocks.push_back(std::string(flag) + " " + names.back());
  }
  if (!of_blocks.empty())
    return (of_blocks.size() == 1 ? "it belongs to a block: " : "it belongs to blocks: ") +
           enumerate(of_blocks, "or");
  const std::vector<std::string_view> views(names.begin(), names.end());
  const auto meant = nearest(name, views);
  return meant ? "did you mean " + in_quotes(*meant) + "?" : "";
}

const VariableBinding& variable_of(const std::string& name, std::string_view flag,
                                   const LinkedStyle& style, const Library& library) {
  if (const VariableBinding* const found = find_variable(name, style)) return *found;
  std::string help = of_other_styles(name, style, library);
  if (help.empty()) help = other_names(name, flag, style);
  const auto colon = name.find(':');
  if (colon != std::string::npos && name.find("::") == std::string::npos)
    help =
        "write " + std::string(flag) + " " + name.substr(0, colon) + "=" + name.substr(colon + 1);
  refuse(std::string(flag) + " " + name + ": style " + in_quotes(style.name()) +
             " has no variable of that name",
         std::move(help));
}

// ---- values

std::string quoted(std::string_view text) {
  std::string literal = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') literal += '\\';
    if (static_cast<unsigned char>(c) >= ' ') {
      literal += c;
      continue;
    }
    std::array<char, 8> escape{};
    std::snprintf(escape.data(), escape.size(), "\\u%04X", static_cast<unsigned>(c));
    literal += escape.data();
  }
  return literal + "\"";
}

bool is_in_capitals(std::string_view word) {
  return word.size() > 1 && std::ranges::all_of(word, [](char c) {
           return c == '_' || (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z');
         });
}

/// Refused for a variable that holds a number.
std::string text_for(const std::string& flag, const std::string& value,
                     const VariableBinding& variable) {
  if (!holds_number(variable)) return quoted(value);
  const bool sweeps = flag.starts_with("--sweep");
  refuse(flag + ": " + in_quotes(variable.name) + " is a number, " + in_quotes(value) + " is none",
         sweeps && value.find("..") != value.npos ? "write a range as from:to:step"
                                                  : number_help(value),
         variable.syntax->name.at);
}

/// As --set reads a value: what is no expression is text.
std::string literal_of(const std::string& flag, const std::string& value,
                       const VariableBinding& variable, const LinkedStyle& style) {
  const Source source("value", value);
  Diagnostics quiet;
  const syntax::ExprPtr expr = parse_expression(source, quiet);
  if (!expr || quiet.has_errors()) return text_for(flag, value, variable);
  const bool holds_text =
      variable.syntax->value && std::holds_alternative<syntax::Text>(variable.syntax->value->is);
  if (const auto* name = std::get_if<syntax::Reference>(&expr->is);
      name && name->names.size() == 1 && !name->style) {
    const std::string_view word = name->names[0].text;
    const bool is_known = is_in_capitals(word) || style.find_symbol(word) ||
                          style.find_variable({}, word) ||
                          style.find_variable(variable.block, word);
    return is_known && !holds_text ? std::string(word)
                                   : text_for(flag, std::string(word), variable);
  }
  const bool is_number = std::holds_alternative<syntax::Number>(expr->is) ||
                         std::holds_alternative<syntax::Chain>(expr->is);
  if (holds_text && is_number) return quoted(value);
  return std::string(expr->at.text());
}

/// Parts between commas that stand in no brackets and no quotes.
std::vector<std::string> split_list(const std::string& text) {
  std::vector<std::string> parts(1);
  int depth = 0;
  bool in_text = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (in_text && c == '\\' && i + 1 < text.size()) {
      parts.back() += c;
      parts.back() += text[++i];
      continue;
    }
    if (c == '"') in_text = !in_text;
    if (!in_text && (c == '(' || c == '[')) ++depth;
    if (!in_text && (c == ')' || c == ']')) --depth;
    if (c == ',' && !in_text && depth == 0) {
      parts.emplace_back();
    } else {
      parts.back() += c;
    }
  }
  return parts;
}

// ---- ranges

std::optional<double> number_in(std::string_view text) {
  while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
  while (!text.empty() && text.back() == ' ') text.remove_suffix(1);
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value)) return {};
  return value;
}

/// Without the dust of repeated addition: 0.8, not 0.8000000000000002.
std::string number_text(double value) {
  std::array<char, 40> digits{};
  std::snprintf(digits.data(), digits.size(), "%.10g", value == 0 ? 0.0 : value);
  return digits.data();
}

struct Range {
  double from = 0, to = 0, step = 0;

  /// 0 when the step does not lead there.
  std::size_t count() const {
    if (step == 0 || (to - from) / step < 0) return from == to ? 1 : 0;
    const double steps = std::floor((to - from) / step + 1e-9);
    return static_cast<std::size_t>(std::min(steps, 1e6)) + 1;
  }
  /// `wanted` of the values, evenly.
  std::vector<std::string> values(std::size_t wanted) const {
    std::vector<std::string> texts;
    const auto last = static_cast<double>(count() - 1);
    for (std::size_t i = 0; i < wanted; ++i) {
      const double place =
          wanted == 1 ? 0
                      : std::round(static_cast<double>(i) * last / static_cast<double>(wanted - 1));
      texts.push_back(number_text(from + place * step));
    }
    return texts;
  }
};

/// Nothing when it is no range at all.
std::optional<std::vector<std::string>> range_values(const std::string& flag,
                                                     const std::string& text) {
  std::vector<double> numbers;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(':', begin), text.size());
    const auto number = number_in(std::string_view(text).substr(begin, end - begin));
    if (!number) return {};
    numbers.push_back(*number);
    begin = end + 1;
  }
  if (numbers.size() < 2) return {};
  if (numbers.size() != 3) throw UsageError(flag + ": write a range as from:to:step");
  const Range range{numbers[0], numbers[1], numbers[2]};
  if (range.count() == 0)
    throw UsageError(flag + ": the step does not lead from one end to the other");
  if (range.count() > most_variations)
    throw UsageError(flag + ": that are more than " + std::to_string(most_variations) + " values");
  return range.values(range.count());
}

// ---- what the script says of the variable

const syntax::Variable* writing_of(const VariableBinding& variable, const Origin& where) {
  const auto is_it = [&](const auto& item) {
    const auto* found = std::get_if<syntax::Variable>(&item);
    return found && found->name.text == variable.name;
  };
  if (where.block) {
    const auto it = std::ranges::find_if(where.block->items, is_it);
    return it == where.block->items.end() ? nullptr : &std::get<syntax::Variable>(*it);
  }
  const auto it = std::ranges::find_if(where.style->members, is_it);
  return it == where.style->members.end() ? nullptr : &std::get<syntax::Variable>(*it);
}

/// The nearest @range or @choice: a child that only gives another value keeps its parent's.
const syntax::Annotation* annotation_of(const VariableBinding& variable) {
  std::vector<Origin> origins{variable.from};
  origins.insert(origins.end(), variable.overrides.begin(), variable.overrides.end());
  for (const Origin& origin : origins) {
    const syntax::Variable* const writing = writing_of(variable, origin);
    if (!writing) continue;
    for (const syntax::Annotation& a : writing->pre.annotations) {
      if (a.name.text == "range" || a.name.text == "choice") return &a;
    }
  }
  return nullptr;
}

std::vector<std::string> annotated_values(const std::string& name,
                                          const VariableBinding& variable) {
  const syntax::Annotation* const annotation = annotation_of(variable);
  if (!annotation)
    refuse(in_quotes(name) + " has no @range or @choice that says what to sweep",
           "write --sweep " + name + "=from:to:step, or a list of values",
           variable.syntax->name.at);
  std::vector<std::string> texts;
  for (const syntax::Arg& arg : annotation->args) texts.emplace_back(arg.at.text());
  if (annotation->name.text == "choice" && !texts.empty()) return texts;
  std::vector<double> numbers;
  for (const std::string& text : texts) {
    if (const auto number = number_in(text)) numbers.push_back(*number);
  }
  if (numbers.size() != texts.size() || numbers.size() < 2 || numbers.size() > 3)
    refuse("this does not say what to sweep",
           "write @range(least, most, step) or @choice(value, …)", annotation->at);
  constexpr double parts = 4;
  const Range range{numbers[0], numbers[1],
                    numbers.size() == 3 ? numbers[2] : (numbers[1] - numbers[0]) / parts};
  if (range.count() == 0)
    refuse("the step does not lead from one end of the range to the other", {}, annotation->at);
  return range.values(std::min(range.count(), enough));
}

}  // namespace

std::vector<Change> sweep(const std::string& text, const LinkedStyle& style,
                          const Library& library) {
  const auto equals = text.find('=');
  const std::string name = text.substr(0, equals);
  if (name.empty())
    throw UsageError("--sweep takes NAME=from:to:step, NAME=value,value or NAME, not '" + text +
                     "'");
  const VariableBinding& variable = variable_of(name, "--sweep", style, library);
  const std::string flag = "--sweep " + text;
  std::vector<std::string> values;
  if (equals == std::string::npos) {
    values = annotated_values(name, variable);
  } else if (auto range = range_values(flag, text.substr(equals + 1))) {
    values = std::move(*range);
  } else {
    for (const std::string& part : split_list(text.substr(equals + 1))) {
      if (part.empty()) throw UsageError(flag + ": a value is missing");
      if (const auto hyphen = part.find('-', 1); hyphen != part.npos &&
                                                 number_in(part.substr(0, hyphen)) &&
                                                 number_in(part.substr(hyphen + 1)))
        throw UsageError(flag + ": write a range as from:to:step, with ':' between them");
      values.push_back(literal_of(flag, part, variable, style));
    }
  }
  std::vector<Change> changes;
  changes.reserve(values.size());
  for (std::string& value : values) changes.push_back({name, std::move(value)});
  return changes;
}

Change setting(const std::string& text, const LinkedStyle& style, const Library& library) {
  const auto equals = text.find('=');
  if (equals == std::string::npos || equals == 0)
    throw UsageError("--set takes NAME=VALUE, not '" + text + "'");
  const std::string name = text.substr(0, equals);
  const VariableBinding& variable = variable_of(name, "--set", style, library);
  return {name, literal_of("--set " + text, text.substr(equals + 1), variable, style)};
}

}  // namespace mansard
