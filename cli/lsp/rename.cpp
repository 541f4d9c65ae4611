// Renaming a name wherever it means the same, or saying why that can not be.
#include <algorithm>
#include <filesystem>
#include <set>

#include "cli/lsp/features.hpp"
#include "cli/lsp/mentions.hpp"
#include "cli/lsp/uri.hpp"
#include "grammar/in_quotes.hpp"
#include "grammar/parse.hpp"
#include "interpreter/function.hpp"
#include "interpreter/operation.hpp"
#include "styles/reserved.hpp"

namespace mansard::lsp {

namespace {

[[noreturn]] void refuse(const std::string& why) { throw Refusal(Refusal::request_failed, why); }

std::string kind_text(Kind kind) {
  switch (kind) {
    case Kind::style:
      return "style";
    case Kind::block:
      return "block";
    case Kind::variable:
      return "variable";
    case Kind::function:
      return "function";
    case Kind::parameter:
      return "parameter";
    default:
      return "symbol";
  }
}

/// Refuses what no script declares.
void check_target(const Cursor& at) {
  if (!at.word) refuse("there is no name here to rename");
  if (is_declared_kind(at.meaning.kind)) {
    const std::string_view name = at.meaning.name;
    if (name == "NIL") refuse("'NIL' belongs to the language: it deletes a shape");
    if (name == "FOOTPRINT" && at.meaning.kind == Kind::symbol)
      refuse("derivation begins at 'FOOTPRINT'; 'start NAME' in the style begins it elsewhere");
    return;
  }
  if (at.meaning.kind == Kind::file)
    refuse("this is the name of a file; rename the file and write its new name here");
  refuse(in_quotes(at.word->at.text()) + " belongs to the language and can not be renamed");
}

void check_new_name(const Cursor& at, std::string_view name) {
  if (!is_name(name))
    refuse(in_quotes(name) + " is no name: a name is ASCII letters, digits and _, a letter first");
  if (is_reserved(name)) refuse(in_quotes(name) + " is reserved and can not be declared");
  const Kind kind = at.meaning.kind;
  if (kind != Kind::style && kind != Kind::block && find_operation(name))
    refuse(in_quotes(name) + " is an operation");
  if (kind == Kind::function && (find_function(name) || name == "attr"))
    refuse(in_quotes(name) + " is a function of the language");
  if (kind == Kind::symbol && name == "NIL") refuse("'NIL' deletes shapes");
  if (kind == Kind::block && (name == "Elements" || name == "Materials"))
    refuse(in_quotes(name) + " is the name of a block with a syntax of its own");
}

/// Looks for members of the new name that would be taken for the renamed one, or hide it.
class Clash {
 public:
  Clash(View& view, const Meaning& meaning, std::string_view name)
      : meanings_(view.meanings()), meaning_(meaning), name_(name) {
    for (const syntax::Style* style : meanings_.family(meaning)) styles_.insert(style);
  }

  void check(View& view) {
    for (const syntax::File& file : view.library().read_files()) {
      for (const Word& word : view.words(file)) {
        if (word.text != name_) continue;
        const Meaning there = meanings_.of(word);
        if (is_in_the_way(word, there)) say(view, word, there);
      }
    }
  }

 private:
  [[noreturn]] void say(View& view, const Word& word, const Meaning& there) const {
    const Position at = view.range(word.at).start;
    const std::string file = std::filesystem::path(word.at.source->name()).filename().string();
    refuse("there is a " + kind_text(there.kind) + " " + in_quotes(name_) + " already: " + file +
           ":" + std::to_string(at.line + 1) + ":" + std::to_string(at.character + 1));
  }

  bool is_in_the_way(const Word& word, const Meaning& there) const {
    if (!is_declared_kind(there.kind)) return false;
    if (meaning_.kind == Kind::style) return there.kind == Kind::style;
    if (meaning_.kind == Kind::parameter)
      return word.rule == meaning_.scope || word.function == meaning_.scope;
    if (there.kind == Kind::style || !is_shared(there)) return false;
    if (meaning_.kind == Kind::block) return there.kind == Kind::block;
    if (there.kind == Kind::block) return false;
    if (meaning_.kind == Kind::function || there.kind == Kind::function)
      return meaning_.kind == there.kind && sees(there.block);
    if (meaning_.kind == Kind::symbol && there.kind == Kind::symbol) return true;
    // A name in a rule is a parameter, a variable of the block, of the style, or a symbol.
    return there.kind == Kind::parameter || there.kind == Kind::symbol ||
           meaning_.kind == Kind::symbol || sees(there.block);
  }

  /// Would a bare name in this block be one or the other?
  bool sees(std::string_view block) const {
    return block == meaning_.block || block.empty() || meaning_.block.empty();
  }

  /// In a style that has the renamed member, or inherits it, or gives it on.
  bool is_shared(const Meaning& there) const {
    if (!there.style) return true;
    const auto meets = [&](const syntax::Style* style) { return styles_.contains(style); };
    if (std::ranges::any_of(meanings_.order(*there.style), meets)) return true;
    return std::ranges::any_of(styles_, [&](const syntax::Style* style) {
      const Order& order = meanings_.order(*style);
      return std::ranges::find(order, there.style) != order.end();
    });
  }

  const Meanings& meanings_;
  const Meaning& meaning_;
  std::string_view name_;
  std::set<const syntax::Style*> styles_;
};

void check_clashes(Project& project, const Cursor& at, const Mentions& mentions,
                   std::string_view name) {
  std::set<std::string> files;
  for (const auto& [place, mention] : mentions) files.insert(place.first);
  for (const std::string& file : files) {
    if (!project.workspace().contains(file))
      refuse(in_quotes(at.word->at.text()) + " is also written in " + in_quotes(file) +
             ", which is not in the workspace");
    for (View* view : project.views_around(file)) {
      for (const auto& [place, mention] : mentions) {
        const syntax::File* const script = view->file(place.first);
        const Word* const word = script ? view->word_at(*script, place.second) : nullptr;
        if (!word) continue;
        const Meaning meaning = view->meanings().of(*word);
        Clash(*view, meaning, name).check(*view);
        break;  // all mean the same
      }
    }
  }
}

}  // namespace

Json prepare_rename(Project& project, const Params& params) {
  const Cursor at = project.cursor(params);
  if (!at.word) return nullptr;
  check_target(at);
  return Json::object(
      {{"range", json(at.view->range(at.word->at))}, {"placeholder", at.word->at.text()}});
}

Json rename(Project& project, const Params& params) {
  const std::string name = params.needed_text("newName");
  project.workspace().forget();
  const Cursor at = project.cursor(params);
  check_target(at);
  if (name == at.meaning.name) return Json::object({{"changes", Json::object({})}});
  check_new_name(at, name);
  const Mentions mentions = mentions_of(project, at);
  check_clashes(project, at, mentions, name);
  std::map<std::string, std::vector<Json>> edits;
  for (const auto& [place, mention] : mentions) {
    edits[project.documents().uri(place.first)].push_back(
        Json::object({{"range", json(mention.range)}, {"newText", name}}));
  }
  Json changes = Json::object({});
  for (const auto& [uri, of_file] : edits) changes.put(uri, Json::array(of_file));
  return Json::object({{"changes", changes}});
}

}  // namespace mansard::lsp
