#include "cli/vary_axes.hpp"

#include <algorithm>
#include <filesystem>

#include "grammar/in_quotes.hpp"
#include "styles/library.hpp"

namespace mansard {
namespace {

/// One thing that varies: each value of it, as a variation that says nothing else.
using Axis = std::vector<Variation>;

constexpr long long usual_count = 12, largest_seed = 1'000'000'000'000'000;

LinkedStyle linked(const Library& library, const syntax::Style& style, Diagnostics& diagnostics) {
  auto result = link(library, style, diagnostics);
  if (result && !diagnostics.has_errors()) return std::move(*result);
  for (const Diagnostic& d : diagnostics.all()) {
    if (d.severity == Severity::error) throw Failure(d);
  }
  throw Failure(Diagnostic{});
}

const syntax::Style& style_of(const Library& library, const std::string& name) {
  if (const syntax::Style* found = library.find(name)) return *found;
  std::vector<std::string_view> names;
  for (const syntax::Style* s : library.styles()) names.push_back(s->name.text);
  Diagnostic d;
  d.text = "no style " + in_quotes(name) + " in this file";
  if (const auto meant = nearest(name, names)) d.help = "did you mean " + in_quotes(*meant) + "?";
  if (name.find(',') != std::string::npos) d.help = "several styles are given by --styles A,B,C";
  if (name.empty()) d.help = "write the names without spaces and with one comma: --styles A,B,C";
  throw Failure(std::move(d));
}

/// The styles of --styles, else the one of --style, else the last of the file.
std::vector<const syntax::Style*> bases(const Arguments& arguments, const Library& library) {
  std::vector<const syntax::Style*> styles;
  if (const auto list = arguments.value("--styles")) {
    if (arguments.values("--styles").size() > 1)
      throw UsageError("'--styles' is given twice: write the names in one, A,B,C");
    if (arguments.has("--style")) throw UsageError("give --style or --styles, not both");
    for (std::size_t begin = 0; begin <= list->size();) {
      const std::size_t end = std::min(list->find(',', begin), list->size());
      styles.push_back(&style_of(library, list->substr(begin, end - begin)));
      begin = end + 1;
    }
    return styles;
  }
  if (const auto name = arguments.value("--style")) return {&style_of(library, *name)};
  if (library.default_style()) return {library.default_style()};
  Diagnostic d;
  d.text = "there is no style in this file";
  d.help = "begin with: style Name { ... }";
  throw Failure(std::move(d));
}

Axis seeds(uint64_t first, long long count) {
  Axis axis;
  for (long long i = 0; i < count; ++i) {
    Variation one;
    one.seed = first + static_cast<uint64_t>(i);
    one.caption = "seed " + std::to_string(*one.seed);
    axis.push_back(std::move(one));
  }
  return axis;
}

Axis swept(const std::vector<Change>& changes) {
  Axis axis;
  for (const Change& change : changes)
    axis.push_back({change.name + " = " + change.value, {}, {change}, {}});
  return axis;
}

std::vector<Axis> axes(const Arguments& arguments, const std::vector<const syntax::Style*>& styles,
                       const LinkedStyle& first, const Library& library) {
  std::vector<Axis> all;
  if (arguments.has("--styles")) {
    Axis& axis = all.emplace_back();
    for (const syntax::Style* style : styles) {
      const std::string name(style->name.text);
      axis.push_back({name, name, {}, {}});
    }
  }
  for (const std::string& text : arguments.values("--sweep"))
    all.push_back(swept(sweep(text, first, library)));
  if (all.empty() || arguments.has("--count")) {
    const long long count =
        arguments.number("--count", usual_count, 1, static_cast<long long>(most_variations));
    const long long from =
        arguments.number("--seed", static_cast<long long>(first.seed.value_or(0)), 0, largest_seed);
    all.push_back(seeds(static_cast<uint64_t>(from), count));
  }
  if (all.size() > 2)
    throw UsageError("a sheet has rows and columns: two of --styles, --sweep, --sweep and --count");
  return all;
}

/// The later one's style and seed count; both say what differs.
Variation joined(const Variation& row, const Variation& column) {
  Variation both = row;
  both.caption += ", " + column.caption;
  if (!column.base.empty()) both.base = column.base;
  if (column.seed) both.seed = column.seed;
  both.changes.insert(both.changes.end(), column.changes.begin(), column.changes.end());
  return both;
}

std::vector<Variation> crossed(const std::vector<Axis>& axes) {
  if (axes.size() == 1) return axes[0];
  std::vector<Variation> all;
  if (axes[0].size() * axes[1].size() > most_variations)
    throw UsageError("that are " + std::to_string(axes[0].size() * axes[1].size()) +
                     " pictures; a sheet has " + std::to_string(most_variations) + " at most");
  for (const Variation& row : axes[0]) {
    for (const Variation& column : axes[1]) all.push_back(joined(row, column));
  }
  return all;
}

/// What a sweep says of a variable is stronger than what --set says.
void add_settings(Variation& variation, const std::vector<Change>& settings) {
  std::vector<Change> changes;
  for (const Change& setting : settings) {
    if (std::ranges::find(variation.changes, setting.name, &Change::name) ==
        variation.changes.end()) {
      changes.push_back(setting);
    }
  }
  changes.insert(changes.end(), variation.changes.begin(), variation.changes.end());
  variation.changes = std::move(changes);
}

std::vector<Change> settings_of(const Arguments& arguments, const LinkedStyle& style,
                                const Library& library) {
  std::vector<Change> settings;
  for (const std::string& text : arguments.values("--set")) {
    Change change = setting(text, style, library);
    std::erase_if(settings, [&](const Change& c) { return c.name == change.name; });
    settings.push_back(std::move(change));
  }
  return settings;
}

}  // namespace

Variations variations_of(const Arguments& arguments, const Library& library,
                         Diagnostics& warnings) {
  const auto styles = bases(arguments, library);
  std::vector<LinkedStyle> all_linked;
  all_linked.reserve(styles.size());
  for (const syntax::Style* style : styles) all_linked.push_back(linked(library, *style, warnings));
  const LinkedStyle& first = all_linked.front();

  const std::vector<Axis> what_varies = axes(arguments, styles, first, library);
  const std::vector<Change> settings = settings_of(arguments, first, library);
  Variations result;
  result.all = crossed(what_varies);
  if (what_varies.size() == 2) result.columns = static_cast<int>(what_varies[1].size());
  const bool has_seeds = what_varies.back().front().seed.has_value();
  const auto seed = static_cast<uint64_t>(arguments.number("--seed", 0, 0, largest_seed));
  for (Variation& variation : result.all) {
    if (variation.base.empty()) variation.base = first.name();
    if (!has_seeds && arguments.has("--seed")) variation.seed = seed;
    add_settings(variation, settings);
  }

  const std::filesystem::path script(arguments.positional()[0]);
  result.common =
      arguments.has("--styles") ? script.filename().string() : std::string(first.name());
  for (const Change& setting : settings)
    result.common += ", " + setting.name + " = " + setting.value;
  if (!has_seeds && arguments.has("--seed")) result.common += ", seed " + std::to_string(seed);
  return result;
}

}  // namespace mansard
