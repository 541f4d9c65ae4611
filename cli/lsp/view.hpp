// A script with all that it imports, read as `mansard check` reads it, but with the editor's texts.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <unordered_map>
#include <vector>

#include "cli/lsp/documents.hpp"
#include "cli/lsp/meaning.hpp"
#include "cli/lsp/positions.hpp"
#include "cli/lsp/resolved.hpp"
#include "grammar/diagnostic.hpp"
#include "interpreter/program.hpp"
#include "styles/library.hpp"

namespace mansard::lsp {

/// Remembers which files were asked for, so that one can tell when they have changed.
class WatchedFiles final : public Files {
 public:
  explicit WatchedFiles(Documents& documents) : documents_(documents) {}
  std::optional<std::string> read(const std::string& path) override;
  bool exists(const std::string& path) override { return documents_.exists(path); }
  std::string identity(const std::string& path) override { return documents_.identity(path); }
  bool is_fresh() const;

 private:
  Documents& documents_;
  std::vector<std::pair<std::string, uint64_t>> seen_;  ///< identity and stamp
};

class View {
 public:
  /// Reads `path` and its imports.
  View(Documents& documents, const std::vector<std::string>& style_path, const std::string& path,
       Encoding encoding);
  View(const View&) = delete;
  View& operator=(const View&) = delete;

  /// False once one of the files that were read, or looked for, is another.
  bool is_fresh() const { return files_.is_fresh(); }
  bool has_syntax_errors() const { return reading_.has_errors(); }

  Library& library() { return library_; }
  /// Null when the script itself can not be read.
  const syntax::File* root() const { return root_; }
  const syntax::File* file(const std::string& identity) const;
  std::string identity(const Source& source) { return files_.identity(source.name()); }

  const Lines& lines(const Source& source);
  Range range(Span at) { return lines(*at.source).range(at.begin, at.end); }

  std::span<const Word> words(const syntax::File& file);
  /// The word at or just before the offset.
  const Word* word_at(const syntax::File& file, uint32_t offset);
  const Meanings& meanings();

  /// Null while the script has syntax errors, or the style others.
  Resolved* resolved(const syntax::Style& style);

  /// What `mansard check` says.
  const Diagnostics& checked(MeshSource& meshes);
  bool is_checked() const { return checked_.has_value(); }
  /// Check again when asked next.
  void forget_check() { checked_.reset(); }

 private:
  void collect_words();

  WatchedFiles files_;
  Library library_;
  Encoding encoding_;
  Diagnostics reading_;
  const syntax::File* root_;
  std::vector<std::vector<Word>> words_;  ///< one a file, in the library's order
  std::unique_ptr<Meanings> meanings_;
  std::unordered_map<std::string, const syntax::File*> by_identity_;
  std::unordered_map<const Source*, Lines> lines_;
  std::unordered_map<const syntax::Style*, std::unique_ptr<Resolved>> resolved_;
  std::optional<Diagnostics> checked_;
};

}  // namespace mansard::lsp
