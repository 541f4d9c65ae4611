// The outline of a script, and the names of all scripts.
#include <algorithm>

#include "cli/lsp/features.hpp"
#include "cli/lsp/uri.hpp"

namespace mansard::lsp {

namespace {

/// The protocol's numbers for what symbols can be.
enum Shown : int { module = 2, style = 5, rule = 6, variable = 13, function = 12, entry = 19 };

Json shown(View& view, const syntax::Name& name, Span at, int kind, std::string_view detail,
           const std::vector<Json>& children = {}) {
  Json made = Json::object({{"name", name.text},
                            {"kind", kind},
                            {"range", json(view.range(at))},
                            {"selectionRange", json(view.range(name.at))}});
  if (!detail.empty()) made.put("detail", detail);
  if (!children.empty()) made.put("children", Json::array(children));
  return made;
}

/// Puts a member into the outline; each kind has its overload.
struct Outline {
  View& view;
  std::vector<Json>& into;

  void operator()(const syntax::Variable& v) {
    into.push_back(shown(view, v.name, v.at, variable, v.value ? v.value->at.text() : "abstract"));
  }
  void operator()(const syntax::Function& f) {
    into.push_back(shown(view, f.name, f.at, function, f.value->at.text()));
  }
  void operator()(const syntax::AbstractSymbol& s) {
    into.push_back(shown(view, s.name, s.at, rule, "abstract"));
  }
  void operator()(const syntax::Start&) {}
  void operator()(const syntax::Rule& r) {
    const Span rest{r.head.source, r.name.at.end, r.head.end};
    std::string_view detail = rest.text();
    const auto begin = detail.find_first_not_of(" \t\r\n");
    detail.remove_prefix(begin == detail.npos ? detail.size() : begin);
    into.push_back(shown(view, r.name, r.at, rule, detail));
  }
  void operator()(const syntax::Block& block) {
    std::vector<Json> members;
    Outline inner{view, members};
    for (const syntax::BlockItem& item : block.items) std::visit(inner, item);
    for (const auto& e : block.elements) members.push_back(shown(view, e.symbol, e.at, entry, {}));
    for (const auto& e : block.materials) members.push_back(shown(view, e.symbol, e.at, entry, {}));
    into.push_back(shown(view, block.name, block.at, module, {}, members));
  }
};

/// Do the letters of the query stand in the name, in their order? Case is ignored.
bool matches(std::string_view name, std::string_view query) {
  const auto lower = [](char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  };
  std::size_t at = 0;
  for (const char c : name) at += at < query.size() && lower(c) == lower(query[at]);
  return at == query.size();
}

int kind_of(Site site) {
  switch (site) {
    case Site::style:
      return style;
    case Site::block:
      return module;
    case Site::variable:
      return variable;
    case Site::function:
      return function;
    default:
      return rule;
  }
}

bool is_found_by_name(Site site) {
  return site == Site::style || site == Site::block || site == Site::variable ||
         site == Site::function || site == Site::rule;
}

std::string container(const Word& word) {
  if (!word.style || word.site == Site::style) return {};
  std::string text(word.style->name.text);
  if (word.block && word.site != Site::block) text.append(".").append(word.block->name.text);
  return text;
}

}  // namespace

Json document_symbols(Project& project, const Params& params) {
  const Cursor at = project.whole(params);
  std::vector<Json> styles;
  for (const syntax::Style& made : at.file->styles) {
    std::vector<Json> members;
    Outline outline{*at.view, members};
    for (const syntax::StyleMember& member : made.members) std::visit(outline, member);
    std::string parents;
    for (const syntax::Name& parent : made.parents)
      parents.append(parents.empty() ? ": " : ", ").append(parent.text);
    styles.push_back(shown(*at.view, made.name, made.at, style, parents, members));
  }
  return Json::array(styles);
}

Json workspace_symbols(Project& project, const Params& params) {
  constexpr std::size_t most = 500;
  const std::string query = params["query"].text().value_or("");
  std::vector<Json> found;
  for (const std::string& script : project.workspace().scripts()) {
    const ScriptAlone* const alone = project.alone().find(script, project.encoding);
    if (!alone) continue;
    const std::string uri = project.documents().uri(script);
    for (const Word& word : alone->words) {
      if (!is_found_by_name(word.site) || !matches(word.text, query)) continue;
      if (found.size() == most) return Json::array(found);
      const Range range = alone->lines.range(word.at.begin, word.at.end);
      const Json place = Json::object({{"uri", uri}, {"range", json(range)}});
      found.push_back(Json::object({{"name", word.text},
                                    {"kind", kind_of(word.site)},
                                    {"location", place},
                                    {"containerName", container(word)}}));
    }
  }
  return Json::array(found);
}

}  // namespace mansard::lsp
