// From a name to where it is declared, overridden and used.
#include <algorithm>
#include <filesystem>

#include "cli/lsp/features.hpp"
#include "cli/lsp/find_file.hpp"
#include "cli/lsp/mentions.hpp"
#include "cli/lsp/uri.hpp"

namespace mansard::lsp {

namespace {

Json start_of_file(Project& project, const std::string& path) {
  return Json::array({Json::object(
      {{"uri", project.documents().uri(path)}, {"range", json(Range{{0, 0}, {0, 0}})}})});
}

bool is_written_in_styles(Kind kind) {
  return is_declared_kind(kind) && kind != Kind::style && kind != Kind::parameter;
}

}  // namespace

Json definition(Project& project, const Params& params) {
  const Cursor at = project.cursor(params);
  if (!at.meaning) return nullptr;
  if (at.meaning.kind == Kind::file) {
    const auto path = find_file(project, *at.word);
    return path ? start_of_file(project, *path) : Json(nullptr);
  }
  return locations(project, *at.view, at.view->meanings().definition(at.meaning));
}

Json declaration(Project& project, const Params& params) {
  const Cursor at = project.cursor(params);
  if (!is_written_in_styles(at.meaning.kind)) return definition(project, params);
  const auto inherited = at.view->meanings().overridden(at.meaning);
  if (inherited.empty()) return definition(project, params);
  return locations(project, *at.view, inherited);
}

/// Heirs may stand in scripts that import this one.
Json implementation(Project& project, const Params& params) {
  const Cursor at = project.cursor(params);
  if (!is_written_in_styles(at.meaning.kind)) return nullptr;
  const std::string own = at.view->identity(*at.file->source);
  std::vector<Json> all;
  std::vector<std::string> seen;
  for (View* view : project.views_around(own)) {
    const syntax::File* const file = view->file(own);
    const Word* const word = file ? view->word_at(*file, at.offset) : nullptr;
    if (!word) continue;
    for (const Word* heir : view->meanings().overriding(view->meanings().of(*word))) {
      const Json place = location(project, *view, heir->at);
      if (std::ranges::find(seen, place.text()) != seen.end()) continue;
      seen.push_back(place.text());
      all.push_back(place);
    }
  }
  return Json::array(all);
}

Json references(Project& project, const Params& params) {
  const Cursor at = project.cursor(params);
  const auto wanted = params["context.includeDeclaration"];
  const bool declarations = wanted.is_null() || wanted.is_true();
  std::vector<Json> all;
  for (const auto& [place, mention] : mentions_of(project, at)) {
    if (mention.declares && !declarations) continue;
    all.push_back(Json::object(
        {{"uri", project.documents().uri(place.first)}, {"range", json(mention.range)}}));
  }
  return Json::array(all);
}

Json highlights(Project& project, const Params& params) {
  constexpr int reads = 2, writes = 3;
  const Cursor at = project.cursor(params);
  if (!at.meaning) return nullptr;
  std::vector<Json> all;
  for (const Word* word : at.view->meanings().mentions(at.meaning)) {
    if (word->at.source != at.file->source) continue;
    const bool declares = !std::holds_alternative<std::monostate>(word->declares);
    all.push_back(Json::object(
        {{"range", json(at.view->range(word->at))}, {"kind", declares ? writes : reads}}));
  }
  return Json::array(all);
}

}  // namespace mansard::lsp
