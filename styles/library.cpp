#include "styles/library.hpp"

#include <algorithm>
#include <filesystem>
#include <optional>
#include <utility>

#include "styles/complaint.hpp"

namespace mansard {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t deepest_import = 250;

std::string joined(const std::string& folder, const std::string& path) {
  return (fs::path(folder) / path).lexically_normal().string();
}

/// "did you mean 'house.style'?", of the scripts in the folder of a file that is missing.
std::string similar_script(Files& files, const std::string& missing) {
  const fs::path path(missing);
  const std::string folder = path.parent_path().string();
  const std::vector<std::string> names = files.scripts(folder.empty() ? "." : folder);
  const std::string name = path.filename().string();
  if (std::ranges::find(names, name + ".style") != names.end())
    return "did you mean " + in_quotes(name + ".style") + "?";
  return did_you_mean(name, {names.begin(), names.end()});
}

/// Whether a script's text has `style Name`.
bool declares(std::string_view text, std::string_view name) {
  const auto is_word = [](char c) {
    return c == '_' || (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
  };
  for (const std::string_view word : {"style", "class"}) {
    for (std::size_t at = text.find(word); at != text.npos; at = text.find(word, at + 1)) {
      const std::size_t begin = text.find_first_not_of(" \t", at + word.size());
      if (begin == text.npos || begin == at + word.size() || (at > 0 && is_word(text[at - 1])))
        continue;
      const std::string_view found = text.substr(begin, name.size() + 1);
      if (found.starts_with(name) && (found == name || !is_word(found.back()))) return true;
    }
  }
  return false;
}

}  // namespace

const syntax::File* Library::load(const std::string& path, Diagnostics& diagnostics) {
  default_ = nullptr;
  const syntax::File* file = nullptr;
  if (const auto known = by_identity_.find(files_.identity(path)); known != by_identity_.end()) {
    file = known->second;
  } else if (std::optional<std::string> text = files_.read(path)) {
    file = read({path, std::move(*text)}, {}, diagnostics);
  } else {
    const bool there = files_.exists(path);
    diagnostics.add(error({},
                          there ? in_quotes(path) + " can not be read as a file"
                                : "there is no file " + in_quotes(path),
                          {}, there ? std::string() : similar_script(files_, path)));
  }
  main_ = file;
  if (file && !file->styles.empty()) default_ = &file->styles.back();
  return file;
}

const syntax::File* Library::add(const std::string& path, std::string text,
                                 Diagnostics& diagnostics) {
  return read({path, std::move(text)}, {}, diagnostics);
}

// Beside the importing file, then in the folders of the style path.
const syntax::File* Library::load_import(const syntax::Import& import, Diagnostics& diagnostics) {
  const auto* path = import.path ? std::get_if<syntax::Text>(&import.path->is) : nullptr;
  if (!path) return nullptr;  // the parser has complained
  std::vector<std::string> folders{folder_of(import.at)};
  folders.insert(folders.end(), style_path_.begin(), style_path_.end());

  std::vector<Note> looked;
  for (const std::string& folder : folders) {
    const std::string candidate = joined(folder, path->value);
    const auto known = by_identity_.find(files_.identity(candidate));
    if (known != by_identity_.end()) return known->second;
    if (std::optional<std::string> text = files_.read(candidate)) {
      return read({candidate, std::move(*text)}, import.path->at, diagnostics);
    }
    looked.push_back({"looked for " + in_quotes(candidate), {}});
  }
  diagnostics.add(
      error(import.path->at, "there is no file " + in_quotes(path->value) + " to import",
            std::move(looked), similar_script(files_, joined(folders[0], path->value))));
  return nullptr;
}

const syntax::File* Library::read(Found found, Span import_at, Diagnostics& diagnostics) {
  if (import_depth_ == deepest_import) {
    diagnostics.add(error(
        import_at, "imports are more than " + std::to_string(deepest_import) + " files deep", {}));
    return nullptr;
  }
  std::string identity = files_.identity(found.path);
  const Source& source = sources_.add(std::move(found.path), std::move(found.text));
  const syntax::File& file = parsed_.emplace_back(parse(source, diagnostics));
  by_identity_.emplace(std::move(identity), &file);  // before its imports, which may lead back here
  ++import_depth_;
  for (const syntax::Import& import : file.imports) load_import(import, diagnostics);
  --import_depth_;
  add_styles(file, diagnostics);
  return &file;
}

void Library::add_styles(const syntax::File& file, Diagnostics& diagnostics) {
  for (const syntax::Style& style : file.styles) {
    if (!style.name) continue;
    styles_.push_back(&style);
    const auto [first, is_new] = by_name_.emplace(style.name.text, &style);
    if (is_new) continue;
    diagnostics.add(error(style.name.at, "there are two styles " + in_quotes(style.name.text),
                          {{"the other one is here", first->second->name.at}},
                          "give one of them another name"));
  }
}

const syntax::Style* Library::find(std::string_view name) const {
  const auto found = by_name_.find(name);
  return found == by_name_.end() ? nullptr : found->second;
}

std::string Library::how_to_import(std::string_view style, const Span& at) const {
  const std::string folder = folder_of(at);
  for (const std::string& name : files_.scripts(folder)) {
    const std::string path = joined(folder, name);
    if (by_identity_.contains(files_.identity(path))) continue;
    const std::optional<std::string> text = files_.read(path);
    if (text && declares(*text, style)) return "write at the top: import \"" + name + "\"";
  }
  return "if another script has it, write at the top: import \"FILE.style\"";
}

std::string Library::folder_of(const Span& at) {
  if (!at) return ".";
  const std::string folder = fs::path(at.source->name()).parent_path().string();
  return folder.empty() ? "." : folder;
}

}  // namespace mansard
