#include "cli/lsp/view.hpp"

#include <algorithm>

namespace mansard::lsp {

std::optional<std::string> WatchedFiles::read(const std::string& path) {
  const std::string same = identity(path);
  seen_.emplace_back(same, documents_.stamp(same));
  return documents_.read(path);
}

bool WatchedFiles::is_fresh() const {
  return std::ranges::all_of(
      seen_, [&](const auto& file) { return documents_.stamp(file.first) == file.second; });
}

View::View(Documents& documents, const std::vector<std::string>& style_path,
           const std::string& path, Encoding encoding)
    : files_(documents),
      library_(files_, style_path),
      encoding_(encoding),
      root_(library_.load(path, reading_)) {
  for (const syntax::File& file : library_.read_files())
    by_identity_.emplace(identity(*file.source), &file);
}

const syntax::File* View::file(const std::string& identity) const {
  const auto found = by_identity_.find(identity);
  return found == by_identity_.end() ? nullptr : found->second;
}

const Lines& View::lines(const Source& source) {
  return lines_.try_emplace(&source, source.text(), encoding_).first->second;
}

void View::collect_words() {
  if (!words_.empty()) return;
  words_.reserve(library_.read_files().size());
  for (const syntax::File& file : library_.read_files()) words_.push_back(words_of(file));
}

std::span<const Word> View::words(const syntax::File& file) {
  collect_words();
  std::size_t number = 0;
  for (const syntax::File& other : library_.read_files()) {
    if (&other == &file) return words_[number];
    ++number;
  }
  return {};
}

const Word* View::word_at(const syntax::File& file, uint32_t offset) {
  const Word* best = nullptr;
  for (const Word& word : words(file)) {
    if (word.at.begin > offset) break;
    const bool inside = offset < word.at.end, behind = offset == word.at.end;
    if (inside || (behind && !best)) best = &word;
  }
  return best;
}

const Meanings& View::meanings() {
  collect_words();
  if (!meanings_) meanings_ = std::make_unique<Meanings>(library_, words_);
  return *meanings_;
}

Resolved* View::resolved(const syntax::Style& style) {
  if (has_syntax_errors()) return nullptr;
  const auto [kept, fresh] = resolved_.try_emplace(&style);
  if (fresh) kept->second = Resolved::of(library_, style);
  return kept->second.get();
}

const Diagnostics& View::checked(MeshSource& meshes) {
  if (checked_) return *checked_;
  checked_ = reading_;
  CompileOptions options;
  options.all_styles = true;
  if (root_ && !reading_.has_errors()) compile(library_, meshes, options, *checked_);
  checked_->sort();
  return *checked_;
}

}  // namespace mansard::lsp
