#include "cli/lsp/diagnostics.hpp"

#include <algorithm>

#include "cli/lsp/uri.hpp"

namespace mansard::lsp {

namespace {

/// "text", and on lines of their own the notes that have no place, and the help.
std::string message(const Diagnostic& diagnostic) {
  std::string text = diagnostic.text;
  for (const Note& note : diagnostic.notes) {
    if (!note.at) text += "\nnote: " + note.text;
  }
  if (!diagnostic.help.empty()) text += "\nhelp: " + diagnostic.help;
  return text;
}

Json related(Project& project, View& view, Span at, std::string_view text) {
  return Json::object({{"location", location(project, view, at)}, {"message", text}});
}

}  // namespace

Json json(Project& project, View& view, const Diagnostic& diagnostic) {
  const Range range = diagnostic.at ? view.range(diagnostic.at) : Range{};
  Json made = Json::object({{"range", json(range)},
                            {"severity", diagnostic.severity == Severity::error ? 1 : 2},
                            {"source", "mansard"},
                            {"message", message(diagnostic)}});
  if (!diagnostic.code.empty()) made.put("code", diagnostic.code);
  std::vector<Json> others;
  for (const Span& at : diagnostic.also) others.push_back(related(project, view, at, "and here"));
  for (const Note& note : diagnostic.notes) {
    if (note.at) others.push_back(related(project, view, note.at, note.text));
  }
  if (!others.empty()) made.put("relatedInformation", Json::array(others));
  return made;
}

bool check_next(Project& project) {
  for (const auto& [identity, document] : project.documents().all()) {
    View& view = project.view(document.path);
    if (view.is_checked()) continue;
    view.checked(project.meshes(view));
    return true;
  }
  return false;
}

namespace {

/// What is wrong, and where: a script and one that imports it say the same with other notes.
using Wrong = std::pair<std::string, Json>;

/// By URI. What a script says of itself comes before what others say of it.
std::map<std::string, std::vector<Wrong>> collect(Project& project) {
  std::map<std::string, std::vector<Wrong>> found;
  for (const bool own : {true, false}) {
    for (const auto& [identity, document] : project.documents().all()) {
      View& view = project.view(document.path);
      for (const Diagnostic& d : view.checked(project.meshes(view)).all()) {
        const bool is_own = !d.at || (view.root() && d.at.source == view.root()->source);
        if (is_own != own) continue;
        auto& of_file = found[d.at ? project.documents().uri(d.at.source->name()) : document.uri];
        std::string what = json(d.at ? view.range(d.at) : Range{}).text() + d.text;
        if (std::ranges::find(of_file, what, &Wrong::first) != of_file.end()) continue;
        of_file.emplace_back(std::move(what), json(project, view, d));
      }
    }
  }
  return found;
}

}  // namespace

void Publisher::publish(Project& project, const std::function<void(const Json&)>& send) {
  std::map<std::string, std::vector<Json>> found;
  for (const auto& [uri, of_file] : collect(project)) {
    for (const auto& [what, diagnostic] : of_file) found[uri].push_back(diagnostic);
  }
  for (const auto& [uri, text] : said_) found[uri];
  for (const auto& [uri, diagnostics] : found) {
    Json all = Json::array(diagnostics);
    const auto [said, fresh] = said_.try_emplace(uri, "[]");
    if (said->second == all.text()) continue;
    said->second = all.text();
    Json params = Json::object({{"uri", uri}, {"diagnostics", all}});
    const auto& open = project.documents().all();
    const auto document = open.find(project.documents().identity(path_of(uri)));
    if (document != open.end() && document->second.version)
      params.put("version", *document->second.version);
    send(params);
  }
}

}  // namespace mansard::lsp
