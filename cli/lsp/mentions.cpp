#include "cli/lsp/mentions.hpp"

#include <set>

namespace mansard::lsp {

namespace {

/// Grows the mentions script by script: what is one member in one script may tie together what
/// looks like two in another.
class Search {
 public:
  Search(Project& project, const Cursor& cursor) : project_(project) {
    add(*cursor.view, *cursor.word);
    add_files();
  }

  Mentions run() {
    while (look_through()) add_files();
    return std::move(found_);
  }

 private:
  void add(View& view, const Word& word) {
    const std::string file = view.identity(*word.at.source);
    files_.insert(file);
    const bool declares =
        !std::holds_alternative<std::monostate>(word.declares) || word.site == Site::parameter;
    found_.try_emplace({file, word.at.begin},
                       Mention{view.range(word.at), std::string(word.at.text()), declares});
  }

  void add_files() {
    for (const std::string& file : files_) {
      if (!around_.insert(file).second) continue;
      for (View* view : project_.views_around(file)) views_.insert(view);
    }
  }

  /// True when something new came up.
  bool look_through() {
    const std::size_t before = found_.size();
    for (View* view : views_) {
      std::set<const Word*>& known = known_[view];
      for (const auto& [place, mention] : Mentions(found_)) {
        const syntax::File* const file = view->file(place.first);
        const Word* const word = file ? view->word_at(*file, place.second) : nullptr;
        if (!word || known.contains(word)) continue;
        for (const Word* same : view->meanings().mentions(view->meanings().of(*word))) {
          known.insert(same);
          add(*view, *same);
        }
      }
    }
    return found_.size() > before;
  }

  Project& project_;
  Mentions found_;
  std::set<std::string> files_, around_;
  std::set<View*> views_;
  std::map<View*, std::set<const Word*>> known_;
};

}  // namespace

bool is_declared_kind(Kind kind) {
  return kind == Kind::style || kind == Kind::block || kind == Kind::symbol ||
         kind == Kind::variable || kind == Kind::function || kind == Kind::parameter;
}

Mentions mentions_of(Project& project, const Cursor& cursor) {
  if (!cursor.word || !is_declared_kind(cursor.meaning.kind)) return {};
  return Search(project, cursor).run();
}

}  // namespace mansard::lsp
