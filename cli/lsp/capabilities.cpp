// Both tables: what is promised in `initialize` and what is answered.
#include "cli/lsp/capabilities.hpp"

#include <array>

#include "cli/lsp/features.hpp"
#include "cli/lsp/server.hpp"

namespace mansard::lsp {

namespace {

constexpr std::array rows{
    Request{"textDocument/hover", hover},
    Request{"textDocument/definition", definition},
    Request{"textDocument/declaration", declaration},
    Request{"textDocument/implementation", implementation},
    Request{"textDocument/references", references},
    Request{"textDocument/documentHighlight", highlights},
    Request{"textDocument/prepareRename", prepare_rename},
    Request{"textDocument/rename", rename},
    Request{"textDocument/completion", completion},
    Request{"textDocument/signatureHelp", signature_help},
    Request{"textDocument/documentSymbol", document_symbols},
    Request{"textDocument/foldingRange", folding_ranges},
    Request{"textDocument/formatting", formatting},
    Request{"textDocument/codeAction", code_actions},
    Request{"workspace/symbol", workspace_symbols},
};

}  // namespace

std::span<const Request> requests() { return rows; }

Json capabilities(Encoding encoding) {
  constexpr int incremental = 2;
  const Json sync = Json::object({{"openClose", true}, {"change", incremental}, {"save", true}});
  const Json folders = Json::object({{"supported", true}, {"changeNotifications", true}});
  return Json::object({
      {"positionEncoding", encoding == Encoding::utf8 ? "utf-8" : "utf-16"},
      {"textDocumentSync", sync},
      {"hoverProvider", true},
      {"definitionProvider", true},
      {"declarationProvider", true},
      {"implementationProvider", true},
      {"referencesProvider", true},
      {"documentHighlightProvider", true},
      {"renameProvider", Json::object({{"prepareProvider", true}})},
      {"completionProvider",
       Json::object({{"triggerCharacters", Json::array({".", ":", "@", "\"", "{", "|"})}})},
      {"signatureHelpProvider", Json::object({{"triggerCharacters", Json::array({"(", ","})}})},
      {"documentSymbolProvider", true},
      {"foldingRangeProvider", true},
      {"documentFormattingProvider", true},
      {"codeActionProvider", Json::object({{"codeActionKinds", Json::array({"quickfix"})}})},
      {"workspaceSymbolProvider", true},
      {"workspace", Json::object({{"workspaceFolders", folders}})},
  });
}

}  // namespace mansard::lsp
