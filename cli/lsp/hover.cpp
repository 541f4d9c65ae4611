#include <algorithm>

#include "cli/lsp/describe.hpp"
#include "cli/lsp/features.hpp"
#include "cli/lsp/find_file.hpp"
#include "cli/lsp/pages.hpp"
#include "cli/lsp/tokens.hpp"
#include "cli/vocabulary.hpp"

namespace mansard::lsp {

namespace {

std::string builtin_page(std::string_view name) {
  const Function* const function = find_function(name);
  return function ? page(*function) : word_page(name);
}

std::string file_page(Project& project, const Word& word) {
  const auto path = find_file(project, word);
  return path ? "`" + *path + "`" : "there is no file `" + std::string(word.text) + "`";
}

std::string text_of(Project& project, const Cursor& at) {
  const Meaning& meaning = at.meaning;
  switch (meaning.kind) {
    case Kind::operation:
      return page(*find_operation(meaning.name));
    case Kind::builtin:
      return builtin_page(meaning.name);
    case Kind::attribute:
      return attribute_page(meaning.block.empty()
                                ? std::string(meaning.name)
                                : std::string(meaning.block) + "." + std::string(meaning.name));
    case Kind::selector:
      return selector_page(meaning.name);
    case Kind::part:
      return part_page(meaning.block, meaning.name);
    case Kind::argument:
      return argument_page(meaning.block, meaning.name);
    case Kind::annotation:
      return annotation_page(meaning.name);
    case Kind::file:
      return file_page(project, *at.word);
    case Kind::super:
      return word_page("super") + "\n\n---\n\n" + describe(*at.view, at.meaning);
    default:
      break;
  }
  std::string text = describe(*at.view, meaning);
  if (meaning.name == "FOOTPRINT" || meaning.name == "NIL")
    text += "\n\n---\n\n" + word_page(meaning.name);
  return text;
}

/// A name that the tree holds no word for: a keyword, or one in a line that can not be read.
const Token* name_at(const std::vector<Token>& tokens, uint32_t offset) {
  const auto found = std::ranges::find_if(tokens, [&](const Token& token) {
    return token.kind == TokenKind::name && token.begin <= offset && offset <= token.end;
  });
  return found == tokens.end() ? nullptr : &*found;
}

Json shown(View& view, Span at, const std::string& text) {
  return Json::object({{"contents", Json::object({{"kind", "markdown"}, {"value", text}})},
                       {"range", json(view.range(at))}});
}

}  // namespace

Json hover(Project& project, const Params& params) {
  const Cursor at = project.cursor(params);
  if (at.meaning) {
    const std::string text = text_of(project, at);
    return text.empty() ? Json(nullptr) : shown(*at.view, at.word->at, text);
  }
  const Source& source = *at.file->source;
  const std::vector<Token> tokens = tokens_of(source.text());
  const Token* const name = name_at(tokens, at.offset);
  if (!name) return nullptr;
  std::string text = word_page(name->text);
  if (const Operation* operation = find_operation(name->text)) text = page(*operation);
  return text.empty() ? Json(nullptr) : shown(*at.view, {&source, name->begin, name->end}, text);
}

}  // namespace mansard::lsp
