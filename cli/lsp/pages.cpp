#include "cli/lsp/pages.hpp"

#include "cli/vocabulary.hpp"
#include "interpreter/attribute_table.hpp"
#include "interpreter/selectors.hpp"
#include "styles/annotations.hpp"

namespace mansard::lsp {

namespace {

std::string titled(std::string_view title, std::string_view summary) {
  return code(title) + "\n\n" + std::string(summary);
}

std::string_view type_text(ArgType type) {
  switch (type) {
    case ArgType::number:
      return "a number";
    case ArgType::length:
      return "metres, or a share of the scope such as 50%";
    case ArgType::boolean:
      return "true or false";
    case ArgType::string:
      return "a string";
    case ArgType::value:
      return "any value";
    case ArgType::edges:
      return "edges: words or numbers, one or a list";
    case ArgType::sizes:
      return "sizes: 2.5, 30%, 1r, ~1.2";
    case ArgType::values:
      return "any number of values";
    case ArgType::setting:
      return "the name of a variable";
  }
  return {};
}

}  // namespace

std::string code(std::string_view text) { return "```style\n" + std::string(text) + "\n```"; }

std::string page(const Operation& operation) {
  std::string text = titled(usage(operation), operation.summary);
  if (!operation.example.empty())
    text += "\n\n" + code("FOOTPRINT -> " + std::string(operation.example));
  return text;
}

std::string page(const Function& function) {
  return titled(std::string(function.name) + "(" + std::string(function.args) + ")",
                function.summary) +
         "\n\n" + code(function.example);
}

std::string attribute_page(std::string_view name) {
  if (const AttributeRow* row = find_attribute(name)) return titled(name, row->summary);
  if (const InputRow* row = find_input(name)) return titled(name, row->summary);
  return word_page(name);
}

std::string selector_page(std::string_view name) {
  const auto selector = find_selector(name);
  return selector ? titled(name, selector_summary(*selector)) : std::string();
}

std::string annotation_page(std::string_view name) {
  const AnnotationRow* const row = find_annotation_row(name);
  return row ? titled(usage(*row), row->summary) : std::string();
}

std::string word_page(std::string_view name) {
  const WordRow* const row = find_word(name);
  return row ? titled(name, row->summary) : std::string();
}

std::string part_page(std::string_view operation, std::string_view part) {
  const Operation* const row = find_operation(operation);
  if (!row) return {};
  return titled(usage(*row), "`" + std::string(part) + "` is a part that `" +
                                 std::string(operation) + "` makes. " + std::string(row->summary));
}

std::string argument_page(std::string_view operation, std::string_view argument) {
  const Operation* const row = find_operation(operation);
  for (std::size_t i = 0; row && i < row->count; ++i) {
    if (row->parameter_name(i) != argument) continue;
    return titled(usage(*row), "`" + std::string(argument) +
                                   "`: " + std::string(type_text(row->parameters[i].type)) +
                                   (row->parameters[i].optional ? "; may be left out. " : ". ") +
                                   std::string(row->summary));
  }
  return {};
}

}  // namespace mansard::lsp
