// What the server knows: the open texts, the scripts around them, and how the editor counts.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "cli/lsp/alone.hpp"
#include "cli/lsp/documents.hpp"
#include "cli/lsp/view.hpp"
#include "cli/lsp/workspace.hpp"
#include "cli/session.hpp"

namespace mansard::lsp {

/// A place in a text that the editor asks about.
struct Cursor {
  View* view;
  const syntax::File* file;
  uint32_t offset;
  const Word* word;  ///< null between words
  Meaning meaning;
};

class Project {
 public:
  explicit Project(std::vector<std::string> style_path)
      : style_path_(std::move(style_path)),
        workspace_(documents_, style_path_),
        alone_(documents_) {}

  Documents& documents() { return documents_; }
  Workspace& workspace() { return workspace_; }
  ScriptsAlone& alone() { return alone_; }
  /// For checking the view: within its folders.
  MeshSource& meshes(View& view) {
    meshes_->keep_within(view.library());
    return *meshes_;
  }
  /// Meshes and pictures may be others: they are read anew when asked for next.
  void forget_files();
  const std::vector<std::string>& style_path() const { return style_path_; }
  Encoding encoding = Encoding::utf16;
  bool snippets = false;  ///< whether completions may have places to fill in

  /// Of the script as it is now; read again only when one of its files has changed. Views stay
  /// valid until the next message.
  View& view(const std::string& path);
  /// The last one that had no syntax errors: what names there are while a line is being written.
  View& sound_view(const std::string& path);
  /// Of the scripts that import this file, directly or not, and that none imports; and its own.
  std::vector<View*> views_around(const std::string& path);

  /// Between messages: lets go of views that are no longer of use.
  void settle();

  /// `textDocument` and `position` of a request. Refuses texts that are not there.
  Cursor cursor(const Params& params);
  /// The file of `textDocument`.
  Cursor whole(const Params& params);

 private:
  std::vector<std::string> style_path_;
  Documents documents_;
  Workspace workspace_;
  ScriptsAlone alone_;
  std::unique_ptr<DiskMeshes> meshes_ = std::make_unique<DiskMeshes>();
  std::map<std::string, std::unique_ptr<View>> views_, sound_;  ///< by identity
  std::vector<std::unique_ptr<View>> retired_;
};

/// A place as `Location` of the protocol.
Json location(Project& project, View& view, Span at);
Json locations(Project& project, View& view, const std::vector<const Word*>& words);

}  // namespace mansard::lsp
