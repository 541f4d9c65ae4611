// Quick fixes: the name that was meant, and `// allow CODE` for a warning.
#include <optional>

#include "cli/lsp/diagnostics.hpp"
#include "cli/lsp/features.hpp"
#include "cli/lsp/uri.hpp"

namespace mansard::lsp {

namespace {

/// X of "did you mean 'X'?".
std::optional<std::string> meant(std::string_view help) {
  constexpr std::string_view begin = "did you mean '", end = "'?";
  const auto from = help.find(begin);
  if (from == help.npos) return std::nullopt;
  help.remove_prefix(from + begin.size());
  const auto to = help.find(end);
  if (to == help.npos) return std::nullopt;
  return std::string(help.substr(0, to));
}

Json action(Project& project, const Cursor& at, const Diagnostic& diagnostic,
            const std::string& title, const Range& range, const std::string& text) {
  const Json edit = Json::object({{"range", json(range)}, {"newText", text}});
  Json changes = Json::object({});
  changes.put(project.documents().uri(at.file->source->name()), Json::array({edit}));
  return Json::object({{"title", title},
                       {"kind", "quickfix"},
                       {"diagnostics", Json::array({json(project, *at.view, diagnostic)})},
                       {"edit", Json::object({{"changes", changes}})}});
}

}  // namespace

Json code_actions(Project& project, const Params& params) {
  const Cursor at = project.whole(params);
  const auto place = [&](const char* end) {
    return Position{params.needed_number(std::string("range.") + end + ".line"),
                    params.needed_number(std::string("range.") + end + ".character")};
  };
  const Range asked{place("start"), place("end")};
  std::vector<Json> actions;
  for (const Diagnostic& d : at.view->checked(project.meshes(*at.view)).all()) {
    if (!d.at || d.at.source != at.file->source) continue;
    const Range range = at.view->range(d.at);
    if (range.end < asked.start || asked.end < range.start) continue;
    if (const auto word = meant(d.help)) {
      const std::string quote = d.at.text().starts_with('"') ? "\"" : "";
      actions.push_back(
          action(project, at, d, "Write '" + *word + "'", range, quote + *word + quote));
    }
    if (d.severity != Severity::warning || d.code.empty()) continue;
    const uint32_t line = range.start.line;
    const Position end{line, UINT32_MAX};
    const Lines& lines = at.view->lines(*at.file->source);
    const Position behind = lines.position(lines.offset(end));
    const std::string comment = "  // allow " + std::string(d.code);
    actions.push_back(action(project, at, d, "Allow " + std::string(d.code) + " on this line",
                             {behind, behind}, comment));
  }
  return Json::array(actions);
}

}  // namespace mansard::lsp
