// The files and styles of a run: a script, what it imports, and where imports are looked for.
#pragma once

#include <deque>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "grammar/diagnostic.hpp"
#include "grammar/parse.hpp"
#include "styles/files.hpp"

namespace mansard {

class Library {
 public:
  /// `path` is tried beside the importing file, then in each of these, in order.
  explicit Library(Files& files, std::vector<std::string> style_path = {})
      : files_(files), style_path_(std::move(style_path)) {}

  /// Reads a script and everything it imports, each file once (import cycles are fine). Problems go
  /// to `diagnostics`: unreadable files, syntax errors, two styles of one name. Returns the file,
  /// or null when it can not be read at all. A library can load several scripts.
  const syntax::File* load(const std::string& path, Diagnostics& diagnostics);

  /// A script that is no file: read as if `path` held `text`. It is not what default_style() means.
  const syntax::File* add(const std::string& path, std::string text, Diagnostics& diagnostics);

  /// All styles loaded, in order of reading: imports before the file that names them.
  const std::vector<const syntax::Style*>& styles() const { return styles_; }
  const syntax::Style* find(std::string_view name) const;
  /// The last style of the script that was loaded last: what `derive` takes without --style.
  const syntax::Style* default_style() const { return default_; }
  /// The script that was loaded last, without what it imports; null when it could not be read.
  const syntax::File* main_file() const { return main_; }
  /// Folder of the file that holds `at` (for element meshes and textures named in it).
  static std::string folder_of(const Span& at);
  /// What to do about a style that is not known, written at `at`: import the script beside it that
  /// has the style, where there is one.
  std::string how_to_import(std::string_view style, const Span& at) const;
  /// All files read, in order of beginning to read: a file before what it imports.
  const std::deque<syntax::File>& read_files() const { return parsed_; }
  Files& files() const { return files_; }
  const std::vector<std::string>& style_path() const { return style_path_; }
  Sources& sources() { return sources_; }

 private:
  /// A text that was found, and the path it was found under.
  struct Found {
    std::string path, text;
  };
  const syntax::File* load_import(const syntax::Import& import, Diagnostics& diagnostics);
  const syntax::File* read(Found found, Span import_at, Diagnostics& diagnostics);
  void add_styles(const syntax::File& file, Diagnostics& diagnostics);

  Files& files_;
  std::vector<std::string> style_path_;
  Sources sources_;
  std::deque<syntax::File> parsed_;
  std::unordered_map<std::string, const syntax::File*> by_identity_;
  std::size_t import_depth_ = 0;
  std::vector<const syntax::Style*> styles_;
  std::unordered_map<std::string_view, const syntax::Style*> by_name_;
  const syntax::Style* default_ = nullptr;
  const syntax::File* main_ = nullptr;
};

}  // namespace mansard
