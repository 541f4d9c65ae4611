#include "cli/lsp/project.hpp"

#include <algorithm>

#include "cli/lsp/uri.hpp"

namespace mansard::lsp {

namespace {

constexpr std::size_t most_views = 250;

}  // namespace

View& Project::view(const std::string& path) {
  const std::string same = documents_.identity(path);
  std::unique_ptr<View>& kept = views_[same];
  if (kept && kept->is_fresh()) return *kept;
  if (kept && kept->root() && !kept->has_syntax_errors()) std::swap(sound_[same], kept);
  if (kept) retired_.push_back(std::move(kept));
  kept = std::make_unique<View>(documents_, style_path_, path, encoding);
  return *kept;
}

View& Project::sound_view(const std::string& path) {
  View& now = view(path);
  if (!now.has_syntax_errors()) return now;
  const auto found = sound_.find(documents_.identity(path));
  return found == sound_.end() ? now : *found->second;
}

std::vector<View*> Project::views_around(const std::string& path) {
  std::vector<View*> views{&view(path)};
  for (const std::string& top : workspace_.tops_above(documents_.identity(path))) {
    View* const other = &view(top);
    if (std::ranges::find(views, other) == views.end()) views.push_back(other);
  }
  return views;
}

void Project::forget_files() {
  workspace_.forget();
  meshes_ = std::make_unique<DiskMeshes>();
  for (auto& [identity, kept] : views_) kept->forget_check();
}

void Project::settle() {
  retired_.clear();
  const auto closed = [&](const auto& kept) { return !documents_.all().contains(kept.first); };
  std::erase_if(sound_, closed);
  if (views_.size() > most_views) std::erase_if(views_, closed);
}

Cursor Project::whole(const Params& params) {
  const std::string path = path_of(params.needed_text("textDocument.uri"));
  View& own = view(path);
  if (!own.root())
    throw Refusal(Refusal::request_failed, "there is no text '" + path + "' to look at");
  return {&own, own.root(), 0, nullptr, {}};
}

Cursor Project::cursor(const Params& params) {
  Cursor cursor = whole(params);
  const Position position{params.needed_number("position.line"),
                          params.needed_number("position.character")};
  cursor.offset = cursor.view->lines(*cursor.file->source).offset(position);
  cursor.word = cursor.view->word_at(*cursor.file, cursor.offset);
  if (cursor.word) cursor.meaning = cursor.view->meanings().of(*cursor.word);
  return cursor;
}

Json location(Project& project, View& view, Span at) {
  return Json::object(
      {{"uri", project.documents().uri(at.source->name())}, {"range", json(view.range(at))}});
}

Json locations(Project& project, View& view, const std::vector<const Word*>& words) {
  std::vector<Json> all;
  all.reserve(words.size());
  for (const Word* word : words) all.push_back(location(project, view, word->at));
  return Json::array(all);
}

}  // namespace mansard::lsp
