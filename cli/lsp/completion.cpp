#include <algorithm>
#include <filesystem>
#include <utility>

#include "cli/lsp/completer.hpp"
#include "cli/lsp/features.hpp"
#include "cli/lsp/pages.hpp"
#include "cli/lsp/uri.hpp"
#include "cli/vocabulary.hpp"
#include "interpreter/operation.hpp"
#include "styles/annotations.hpp"

namespace mansard::lsp {

Json completion(Project& project, const Params& params) {
  const Cursor at = project.cursor(params);
  const Source& source = *at.file->source;
  const std::vector<Token> tokens = tokens_of(source.text());
  const Place place = place_at(source.text(), tokens, at.offset);
  const Range word = at.view->lines(source).range(place.begin, at.offset);
  View& view = project.sound_view(source.name());
  return Json::array(Completer(project, view, place, word).run());
}

std::vector<Json> Completer::run() {
  using enum Place::Where;
  switch (place_.where) {
    case nowhere:
      break;
    case Place::Where::file:
      in_file();
      break;
    case parents:
      styles({});
      break;
    case Place::Where::style:
      in_style();
      break;
    case rules:
      in_rules();
      break;
    case elements:
    case materials:
      in_entries(place_.where == materials);
      break;
    case successor:
      in_successor();
      break;
    case part:
      in_part();
      break;
    case expression:
      in_expression();
      break;
    case of_style:
      symbols(view_.library().find(place_.before));
      break;
    case of_block:
      members_of(place_.before);
      break;
    case annotation:
      annotations();
      break;
    case import_path:
      in_import();
      break;
    case text:
      in_text();
      break;
  }
  return std::move(items_);
}

void Completer::add(Item item) {
  if (!known_.emplace(item.label, item.kind).second) return;
  constexpr int plain = 1, snippet = 2, adjust_indentation = 2;
  const bool fills = item.is_snippet && project_.snippets;
  const bool whole = !item.insert.empty() && (fills || !item.is_snippet);
  const Json edit =
      Json::object({{"range", json(word_)}, {"newText", whole ? item.insert : item.label}});
  Json made = Json::object({{"label", item.label},
                            {"kind", item.kind},
                            {"sortText", std::string(1, item.rank) + item.label},
                            {"insertTextFormat", fills ? snippet : plain},
                            {"insertTextMode", adjust_indentation},
                            {"textEdit", edit}});
  if (!item.detail.empty()) made.put("detail", item.detail);
  if (!item.documentation.empty())
    made.put("documentation", Json::object({{"kind", "markdown"}, {"value", item.documentation}}));
  items_.push_back(std::move(made));
}

void Completer::add_words(std::initializer_list<std::string_view> words) {
  for (const std::string_view word : words)
    add({std::string(word), keyword, {}, word_page(word), {}, false, '7'});
}

void Completer::in_file() {
  add({"style", keyword, {}, word_page("style"), "style ${1:Name} {\n\t$0\n}", true});
  add({"import", keyword, {}, word_page("import"), "import \"$0\"", true});
  add_words({"final", "class"});
}

void Completer::in_style() {
  add_words({"var", "def", "abstract", "start", "replace", "final", "override"});
  overridable_block();
  for (const std::string_view name : {"Elements", "Materials"})
    add({std::string(name), module, {}, word_page(name), std::string(name) + " {\n\t$0\n}", true});
}

void Completer::in_rules() {
  overridable();
  add_words({"var", "def", "abstract", "final", "override"});
  symbols(style_);
}

void Completer::in_entries(bool materials) {
  symbols(style_);
  add_words({"remove"});
  if (!materials) return;
  add_words({"per"});
  add({"color", operation, "color(\"#a08070\")", {}, "color(\"$1\")", true});
  add({"texture",
       operation,
       "texture(\"file\", u, v)",
       {},
       "texture(\"$1\", ${2:1}, ${3:1})",
       true});
  add({"metres", operation, "metres(u, v)", {}, "metres(${1:1}, ${2:1})", true});
  add({"opacity", operation, "opacity(0 ... 1)", {}, "opacity(${1:0.4})", true});
  add({"roughness", operation, "roughness(0 ... 1)", {}, "roughness(${1:0.5})", true});
  add({"metallic", operation, "metallic(0 ... 1)", {}, "metallic(${1:1})", true});
  add({"normals", operation, "normals(\"file\")", {}, "normals(\"$1\")", true});
}

void Completer::in_successor() {
  if (place_.first_on_line && place_.parts_of.empty()) in_rules();
  parameters();
  symbols(style_);
  operations();
  styles("::");
  variables();
  add_words({"super", "if"});
  if (place_.after_value) add_words({"else"});
}

void Completer::in_part() {
  part_names();
  const Operation* const row = find_operation(place_.parts_of);
  if (row && row->rule == PartRule::selectors) selectors(" : ");
  in_successor();
}

void Completer::in_expression() {
  named_arguments();
  parameters();
  variables();
  blocks();
  attributes();
  functions();
  symbols(style_);
  add_words({"if", "then", "else", "true", "false", "fits"});
}

/// Words in quotes: selectors where edges are chosen, symbols in @per.
void Completer::in_text() {
  if (place_.calls.empty()) return;
  const OpenCall& call = place_.calls.back();
  if (call.name == "per") return symbols(style_);
  if (call.name == "style") return styles({});
  const Operation* const row = find_operation(call.name);
  if (!row || row->parameter_at(call.argument) >= row->count) return;
  if (row->parameters[row->parameter_at(call.argument)].type == ArgType::edges ||
      row->rule == PartRule::selectors)
    selectors({});
}

void Completer::in_import() {
  namespace fs = std::filesystem;
  constexpr int most = 500;
  std::vector<std::string> folders{fs::path(view_.root()->source->name()).parent_path().string()};
  folders.insert(folders.end(), project_.style_path().begin(), project_.style_path().end());
  for (const std::string& folder : folders) {
    std::error_code error;
    int count = 0;
    for (const auto& entry : fs::directory_iterator(folder, error)) {
      if (entry.path().extension() != ".style" || ++count > most) continue;
      add({entry.path().filename().string(), file, folder, {}, {}});
    }
  }
}

void Completer::annotations() {
  for (const AnnotationRow& row : annotation_rows()) {
    add({std::string(row.name), property, {}, usage(row) + ": " + std::string(row.summary), {}});
  }
}

}  // namespace mansard::lsp
