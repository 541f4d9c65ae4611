// The annotations that may stand before members: one table for the checker, help and editors.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "grammar/diagnostic.hpp"
#include "grammar/syntax.hpp"

namespace mansard {

struct AnnotationRow {
  enum class Takes : uint8_t { nothing, numbers, texts, literals };
  enum class Stands : uint8_t { anywhere, before_variables, before_rules, before_styles };

  std::string_view name;  ///< without the @
  std::string_view args;  ///< "min, max, step"
  Takes takes = Takes::nothing;
  uint8_t least = 0, most = 0;  ///< how many arguments
  Stands stands = Stands::anywhere;
  std::string_view summary;  ///< one sentence
};

std::span<const AnnotationRow> annotation_rows();
const AnnotationRow* find_annotation_row(std::string_view name);
/// `@range(min, max, step)`.
std::string usage(const AnnotationRow& row);

/// What a preamble stands before.
enum class Annotated : uint8_t { variable, rule, other };

/// Every annotation that is unknown, stands twice or in the wrong place, or has wrong arguments. Of
/// those of styles, which have a meaning of their own, only the name is known here
/// (styles/seed.cpp).
std::vector<Diagnostic> check_annotations(const syntax::Preamble& preamble, Annotated what);

/// The annotation of this name; null when there is none.
const syntax::Annotation* find_annotation(const syntax::Preamble& preamble, std::string_view name);

/// `2`, `-0.5`; nothing for anything else.
std::optional<double> number_literal(const syntax::Expr& expr);

/// Of a sound `@range(min, max, step)`.
struct AnnotatedRange {
  double least, most;
  std::optional<double> step;
};
std::optional<AnnotatedRange> range_of(const syntax::Annotation& range);

}  // namespace mansard
