#include "styles/annotations.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "styles/complaint.hpp"

namespace mansard {

namespace {

using syntax::Annotation;
using enum AnnotationRow::Takes;
using enum AnnotationRow::Stands;

constexpr uint8_t many = 255;

constexpr std::array rows{
    AnnotationRow{"range", "min, max, step", numbers, 2, 3, before_variables,
                  "Between which numbers a variable is meant to stay."},
    AnnotationRow{"choice", "values", literals, 1, many, before_variables,
                  "Which values a variable is meant to have."},
    AnnotationRow{"unit", "text", texts, 1, 1, before_variables, "What a number counts: \"m\"."},
    AnnotationRow{"color", "", nothing, 0, 0, before_variables, "The variable is a colour."},
    AnnotationRow{"per", "text", texts, 1, 1, before_variables,
                  "How often the variable is drawn: per \"building\", \"shape\", or nearest "
                  "ancestor of a symbol."},
    AnnotationRow{"stage", "number", numbers, 1, 1, before_rules,
                  "Which of several rounds of questions a rule belongs to."},
    AnnotationRow{"seed", "number", numbers, 1, 1, before_styles,
                  "The seed of a style's buildings where --seed is not given."},
    AnnotationRow{"label", "text", texts, 1, 1, anywhere, "What tools call it."},
    AnnotationRow{"group", "text", texts, 1, 1, anywhere, "Under which heading tools show it."},
    AnnotationRow{"hidden", "", nothing, 0, 0, anywhere, "Tools do not show it."},
};

bool is_literal(const syntax::Expr& expr) {
  if (const auto* reference = std::get_if<syntax::Reference>(&expr.is)) {
    return reference->names.size() == 1 && !reference->style;  // a symbol
  }
  return std::holds_alternative<syntax::Text>(expr.is) ||
         std::holds_alternative<syntax::Boolean>(expr.is) || number_literal(expr);
}

bool suits(AnnotationRow::Takes takes, const syntax::Arg& arg) {
  if (arg.name || arg.value.kind != syntax::SizeKind::absolute || !arg.value.value) return false;
  const syntax::Expr& expr = *arg.value.value;
  if (takes == numbers) return number_literal(expr).has_value();
  if (takes == texts) return std::holds_alternative<syntax::Text>(expr.is);
  return is_literal(expr);
}

std::string_view wanted(AnnotationRow::Takes takes) {
  if (takes == numbers) return "a plain number";
  if (takes == texts) return "a string in quotes";
  return "a plain number, a string, a symbol, true or false";
}

std::optional<Diagnostic> unknown(const Annotation& annotation) {
  if (find_annotation_row(annotation.name.text)) return std::nullopt;
  std::vector<std::string_view> names;
  std::string all;
  for (const AnnotationRow& row : rows) {
    names.push_back(row.name);
    all += (all.empty() ? "there are @" : ", @") + std::string(row.name);
  }
  const auto near = nearest(annotation.name.text, names);
  return error(annotation.name.at,
               "there is no annotation '@" + std::string(annotation.name.text) + "'", {},
               near ? "did you mean '@" + std::string(*near) + "'?" : all);
}

std::optional<Diagnostic> misplaced(const Annotation& annotation, const AnnotationRow& row,
                                    Annotated what) {
  const bool right = row.stands == anywhere ||
                     (row.stands == before_variables && what == Annotated::variable) ||
                     (row.stands == before_rules && what == Annotated::rule);
  if (right) return std::nullopt;
  return error(annotation.at,
               "'@" + std::string(row.name) + "' stands only before " +
                   (row.stands == before_rules ? "rules" : "variables"),
               {});
}

std::optional<Diagnostic> wrong_arguments(const Annotation& annotation, const AnnotationRow& row) {
  const auto& args = annotation.args;
  if (args.size() < row.least || args.size() > row.most) {
    return error(annotation.at,
                 "'" + usage(row) + "' got " + std::to_string(args.size()) +
                     (args.size() == 1 ? " argument" : " arguments"),
                 {}, std::string(row.summary));
  }
  const auto bad =
      std::ranges::find_if(args, [&](const syntax::Arg& arg) { return !suits(row.takes, arg); });
  if (bad != args.end()) {
    return error(bad->at,
                 "'@" + std::string(row.name) + "' takes " + std::string(wanted(row.takes)), {},
                 "write " + usage(row));
  }
  if (row.name != "range") return std::nullopt;
  const AnnotatedRange range = *range_of(annotation);
  if (!(range.least < range.most)) {
    return error(annotation.at, "this range is empty: its first number is not less than its second",
                 {}, "write " + usage(row));
  }
  if (range.step && !(*range.step > 0)) {
    return error(args[2].at, "the step of a range is more than 0", {});
  }
  return std::nullopt;
}

}  // namespace

std::span<const AnnotationRow> annotation_rows() { return rows; }

const AnnotationRow* find_annotation_row(std::string_view name) {
  const auto* found = std::ranges::find(rows, name, &AnnotationRow::name);
  return found == rows.end() ? nullptr : found;
}

std::string usage(const AnnotationRow& row) {
  std::string text = "@" + std::string(row.name);
  if (!row.args.empty()) text += "(" + std::string(row.args) + ")";
  return text;
}

std::vector<Diagnostic> check_annotations(const syntax::Preamble& preamble, Annotated what) {
  std::vector<Diagnostic> found;
  for (const Annotation& annotation : preamble.annotations) {
    std::optional<Diagnostic> wrong = unknown(annotation);
    if (!wrong) {
      const AnnotationRow& row = *find_annotation_row(annotation.name.text);
      if (row.stands == before_styles) continue;
      wrong = misplaced(annotation, row, what);
      if (!wrong) wrong = wrong_arguments(annotation, row);
    }
    const Annotation* const first = find_annotation(preamble, annotation.name.text);
    if (!wrong && first != &annotation) {
      wrong = error(annotation.at, "'@" + std::string(annotation.name.text) + "' stands here twice",
                    {{"the other one is here", first->at}});
    }
    if (wrong) found.push_back(std::move(*wrong));
  }
  return found;
}

const Annotation* find_annotation(const syntax::Preamble& preamble, std::string_view name) {
  const auto found = std::ranges::find_if(preamble.annotations,
                                          [&](const Annotation& a) { return a.name.text == name; });
  return found == preamble.annotations.end() ? nullptr : &*found;
}

std::optional<double> number_literal(const syntax::Expr& expr) {
  if (const auto* number = std::get_if<syntax::Number>(&expr.is)) return number->value;
  const auto* unary = std::get_if<syntax::Unary>(&expr.is);
  if (!unary || unary->operators.size() != 1 || unary->operators[0] != syntax::Prefix::minus) {
    return std::nullopt;
  }
  const auto* number = std::get_if<syntax::Number>(&unary->operand->is);
  return number ? std::optional(-number->value) : std::nullopt;
}

std::optional<AnnotatedRange> range_of(const Annotation& range) {
  std::vector<double> numbers_given;
  for (const syntax::Arg& arg : range.args) {
    const auto number = arg.value.value ? number_literal(*arg.value.value) : std::nullopt;
    if (!number) return std::nullopt;
    numbers_given.push_back(*number);
  }
  if (numbers_given.size() < 2) return std::nullopt;
  AnnotatedRange made{numbers_given[0], numbers_given[1], std::nullopt};
  if (numbers_given.size() > 2) made.step = numbers_given[2];
  return made;
}

}  // namespace mansard
