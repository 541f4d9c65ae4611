// mansard explain
#include "cli/explain.hpp"

#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <utility>

#include "cli/session.hpp"
#include "grammar/in_quotes.hpp"

namespace mansard {

namespace {

[[noreturn]] void unknown(std::string text, std::string_view word,
                          const std::vector<std::string_view>& known, std::string help = {}) {
  Diagnostic d;
  d.text = std::move(text);
  d.help = std::move(help);
  if (const auto near = nearest(word, known)) d.help = "did you mean " + in_quotes(*near) + "?";
  throw Failure(std::move(d));
}

/// What the command line asks for.
struct Question {
  const syntax::Style* style = nullptr;
  std::string name;  ///< empty: the whole style
};

const syntax::Style& style_named(const Library& library, const std::string& name) {
  if (const syntax::Style* found = library.find(name)) return *found;
  std::vector<std::string_view> known;
  for (const syntax::Style* style : library.styles()) known.push_back(style->name.text);
  unknown("no style " + in_quotes(name) + " is loaded", name, known);
}

const syntax::Style& default_style(const Library& library) {
  if (library.default_style()) return *library.default_style();
  Diagnostic d;
  d.text = "there is no style in this file";
  d.help = "begin with: style Name { ... }";
  throw Failure(std::move(d));
}

/// FILE [STYLE] [NAME]: a single word is a style when one is called so.
Question question(const Library& library, const Arguments& arguments) {
  const std::vector<std::string>& words = arguments.positional();
  if (words.size() == 3) return {&style_named(library, words[1]), words[2]};
  if (words.size() == 2) {
    if (const syntax::Style* style = library.find(words[1])) return {style, {}};
    return {&default_style(library), words[1]};
  }
  return {&default_style(library), {}};
}

[[noreturn]] void unknown_name(const Explained& explained, const std::string& name) {
  std::vector<std::string> full;
  std::vector<std::string_view> known(explained.style.blocks);
  for (const Story& story : explained.stories.all()) {
    full.push_back(story.full_name());
    known.push_back(story.name);
  }
  known.insert(known.end(), full.begin(), full.end());
  for (const syntax::Style* style : explained.style.order) known.push_back(style->name.text);
  unknown("nothing is called " + in_quotes(name) + " in style " + in_quotes(explained.style.name()),
          name, known, "without a name, all that the style has is listed");
}

bool is_block(const Explained& explained, std::string_view name) {
  const auto written = [&](auto entries) {
    return std::ranges::any_of(explained.stories.all(),
                               [&](const Story& s) { return !(s.*entries).empty(); });
  };
  if (name == "Elements") return written(&Story::elements);
  if (name == "Materials") return written(&Story::materials);
  return explained.style.has_block(name);
}

std::vector<const Story*> stories_of_block(const Explained& explained, std::string_view block) {
  std::vector<const Story*> found;
  for (const Story& story : explained.stories.all()) {
    const bool in = block == "Elements"    ? !story.elements.empty()
                    : block == "Materials" ? !story.materials.empty()
                                           : story.block == block && !story.writings.empty();
    if (in) found.push_back(&story);
  }
  return found;
}

std::vector<const Story*> stories_of_ancestor(const Explained& explained,
                                              const syntax::Style& ancestor) {
  std::vector<const Story*> found;
  for (const Story& story : explained.stories.all()) {
    const auto gives = [&](const std::vector<Writing>& writings) {
      return std::ranges::any_of(writings,
                                 [&](const Writing& w) { return w.from.style == &ancestor; });
    };
    if (gives(story.writings) || gives(story.elements) || gives(story.materials))
      found.push_back(&story);
  }
  return found;
}

void check_ancestor(const Explained& explained, const syntax::Style& other) {
  if (std::ranges::find(explained.style.order, &other) != explained.style.order.end()) return;
  Diagnostic d;
  d.text = "style " + in_quotes(other.name.text) + " is no ancestor of " +
           in_quotes(explained.style.name());
  d.help = "explain it alone, without " + in_quotes(explained.style.name());
  throw Failure(std::move(d));
}

/// The text that answers a question.
std::string answer(const Library& library, const Explained& explained, const std::string& name,
                   bool json) {
  if (name.empty()) return json ? explained_json(explained, {}) : overview_page(explained, {});
  const std::vector<const Story*> stories = explained.stories.named(name);
  if (!stories.empty()) {
    if (json) return explained_json(explained, stories);
    std::string text;
    for (const Story* story : stories)
      text += (text.empty() ? "" : "\n") + story_page(explained, *story);
    return text;
  }
  if (is_block(explained, name)) {
    return json ? explained_json(explained, stories_of_block(explained, name))
                : overview_page(explained, name);
  }
  if (const syntax::Style* other = library.find(name)) {
    check_ancestor(explained, *other);
    return json ? explained_json(explained, stories_of_ancestor(explained, *other))
                : ancestor_page(explained, *other);
  }
  unknown_name(explained, name);
}

// ---- the circumstances

/// A footprint whose properties decide: the one asked for, or one with nothing but --attr.
Footprint footprint_of(const Session& session, const Arguments& arguments) {
  Footprint bare;
  const auto what = arguments.value("--footprint");
  if (!what) {
    bare.properties = footprint_options(arguments).attributes;
    return bare;
  }
  std::size_t broken = 0;
  FootprintSet set = footprints(session, *what, arguments, broken);
  if (set.footprints.empty()) {
    Diagnostic d;
    d.text = "there is no footprint in " + in_quotes(*what);
    throw Failure(std::move(d));
  }
  if (set.footprints.size() > 1) {
    session.say("note: of " + std::to_string(set.footprints.size()) + " footprints the first, '" +
                set.footprints[0].id + "'; --select id=ID chooses another");
  }
  return std::move(set.footprints[0]);
}

std::string circumstances(const Arguments& arguments, const Footprint& footprint,
                          const std::string& seed) {
  std::string text;
  const auto add = [&](const std::string& more) { text += (text.empty() ? "" : ", ") + more; };
  if (arguments.has("--footprint")) {
    add("for footprint '" + footprint.id + "'");
    if (!seed.empty()) add("seed " + seed);
  }
  std::string with = "with ";
  for (const char* const flag : {"--attr", "--set"}) {
    for (const std::string& value : arguments.values(flag))
      add(std::exchange(with, "") + flag + " " + printable(value));
  }
  return text;
}

/// Prints the errors; warnings are for `check`. True when there were some.
bool print_errors(const Session& session, Diagnostics& diagnostics) {
  diagnostics.sort();
  for (const Diagnostic& d : diagnostics.all()) {
    if (d.severity == Severity::error) session.print(d);
  }
  return diagnostics.has_errors();
}

int explain(Session& session, const Arguments& arguments) {
  Library& library = session.library();
  Diagnostics diagnostics;
  if (!library.load(arguments.positional()[0], diagnostics) || diagnostics.has_errors())
    return print_errors(session, diagnostics), exit_input;
  const Question asked = question(library, arguments);
  const std::optional<LinkedStyle> linked = link(library, *asked.style, diagnostics);
  if (!linked) return print_errors(session, diagnostics), exit_input;

  CompileOptions options = compile_options(arguments);
  options.style = asked.style->name.text;
  options.abstract_too = true;
  NoMeshes meshes;
  const std::unique_ptr<Program> program = compile(library, meshes, options, diagnostics);
  const bool failed = print_errors(session, diagnostics);
  if (failed && arguments.has("--set")) return exit_input;  // it may be what is wrong
  const Footprint footprint = footprint_of(session, arguments);
  std::optional<BuildingValues> values;
  std::string seed;
  if (program) {
    const DeriveOptions how = derive_options(arguments, *program);
    values.emplace(*program, footprint, how.seed);
    seed = std::to_string(how.seed);
  }

  const Stories stories(*linked);
  const Explained explained{*linked,
                            stories,
                            standings(*linked),
                            values ? &*values : nullptr,
                            circumstances(arguments, footprint, seed),
                            arguments.has("--footprint"),
                            arguments.has("--footprint") || arguments.has("--attr"),
                            !arguments.has("--no-color") && isatty(STDOUT_FILENO) == 1};
  const std::string text = answer(library, explained, asked.name, arguments.has("--json"));
  std::fwrite(text.data(), 1, text.size(), stdout);
  return failed ? exit_input : exit_done;
}

}  // namespace

int run_explain(const Arguments& arguments) {
  Session session(arguments);
  return session.guard([&] { return explain(session, arguments); });
}

}  // namespace mansard
