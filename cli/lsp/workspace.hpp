// The scripts of the folders that are open in the editor, and who imports whom.
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "cli/lsp/documents.hpp"

namespace mansard::lsp {

class Workspace {
 public:
  Workspace(Documents& documents, const std::vector<std::string>& style_path)
      : documents_(documents), style_path_(style_path) {}

  void add_folder(const std::string& path);
  void remove_folder(const std::string& path);
  /// Look again for files when asked next: some came or went.
  void forget() {
    is_known_ = false;
    imports_.clear();
  }

  /// Identities of the scripts: at most 5,000, none in hidden or build folders. Those that are open
  /// belong to them wherever they are.
  const std::set<std::string>& scripts();
  /// Of the scripts that lead to this one by imports, those that no script imports. Itself when
  /// there are none.
  std::vector<std::string> tops_above(const std::string& identity);
  /// In an open folder, or open itself; while no folder is open, what is not in the style path.
  bool contains(const std::string& identity) const;

 private:
  struct Imports {
    uint64_t stamp = 0;
    std::vector<std::string> files;  ///< identities
  };
  void look(const std::string& folder);
  const std::vector<std::string>& imports_of(const std::string& identity);

  Documents& documents_;
  const std::vector<std::string>& style_path_;
  std::set<std::string> folders_, scripts_;
  std::map<std::string, Imports> imports_;
  bool is_known_ = false;
};

}  // namespace mansard::lsp
