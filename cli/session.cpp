#include "cli/session.hpp"

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <limits>
#include <utility>

#include "formats/meshes.hpp"
#include "formats/pictures.hpp"
#include "formats/streets.hpp"
#include "interpreter/messages.hpp"
#include "interpreter/properties.hpp"
#include "interpreter/street_edges.hpp"

namespace mansard {

void DiskMeshes::keep_within(const Library& library) {
  std::vector<std::string> folders = library.style_path();
  for (const syntax::File& file : library.read_files())
    folders.push_back(Library::folder_of({file.source, 0, 0}));
  std::ranges::sort(folders);
  folders.erase(std::unique(folders.begin(), folders.end()), folders.end());
  const std::scoped_lock lock(mutex_);
  if (folders == folders_) return;
  folders_ = std::move(folders);
  picture_problems_.clear();
}

const Mesh* DiskMeshes::mesh(const std::string& path, std::string& problem) {
  const std::scoped_lock lock(mutex_);
  auto [it, fresh] = known_[folders_].try_emplace(path);
  if (fresh) {
    MeshLimits limits;
    limits.folders = folders_;
    it->second.mesh = read_mesh(path, it->second.problem, limits);
  }
  problem = it->second.problem;
  return it->second.mesh ? &*it->second.mesh : nullptr;
}

bool DiskMeshes::has_picture(const std::string& path) {
  const std::scoped_lock lock(mutex_);
  const auto [it, fresh] = pictures_.try_emplace(path);
  std::error_code missing;
  if (fresh) it->second = std::filesystem::is_regular_file(path, missing);
  return it->second;
}

std::string DiskMeshes::picture_problem(const std::string& path) {
  const std::scoped_lock lock(mutex_);
  const auto [it, fresh] = picture_problems_.try_emplace(path);
  if (!fresh) return it->second;
  MeshLimits limits;
  limits.folders = folders_;
  const std::string why = refusal(path, limits);
  it->second = why.empty() ? mansard::picture_problem(path) : "it " + why;
  return it->second;
}

std::vector<std::string> style_path(const Arguments& arguments) {
  std::vector<std::string> path = arguments.values("--style-path");
  std::error_code error;
  const auto program = std::filesystem::read_symlink("/proc/self/exe", error);
  const auto installed = program.parent_path() / ".." / "share" / "mansard" / "styles";
  if (!error && std::filesystem::is_directory(installed, error))
    path.push_back(installed.lexically_normal().string());
  path.emplace_back(MANSARD_STYLE_LIBRARY);
  return path;
}

namespace {

std::pair<std::string, std::string> name_and_value(const std::string& text, std::string_view flag) {
  const auto equals = text.find('=');
  if (equals == std::string::npos || equals == 0) {
    throw UsageError(std::string(flag) + " takes NAME=VALUE, not '" + text + "'");
  }
  return {text.substr(0, equals), text.substr(equals + 1)};
}

}  // namespace

Session::Session(const Arguments& arguments)
    : library_(files_, style_path(arguments)),
      json_(arguments.has("--json")),
      color_(!arguments.has("--no-color") && isatty(STDERR_FILENO) == 1),
      quiet_(arguments.has("--quiet")) {}

Session::~Session() = default;

void Session::print(const Diagnostic& diagnostic) const {
  const std::string text = json_ ? to_json(diagnostic) + "\n" : to_text(diagnostic, color_);
  std::fwrite(text.data(), 1, text.size(), stderr);
}

void Session::say(const std::string& line) const {
  if (!quiet_) std::fprintf(stderr, "%s\n", json_ ? note_to_json(line).c_str() : line.c_str());
}

std::string Session::style_taken(const Arguments& arguments) const {
  const syntax::File* const file = library_.main_file();
  if (arguments.has("--style") || arguments.has("--styles") || !file || file->styles.size() < 2)
    return {};
  return " (style " + std::string(file->styles.back().name.text) + ", the last of " +
         std::to_string(file->styles.size()) + ")";
}

bool Session::compile(const std::string& script, const CompileOptions& options) {
  Diagnostics diagnostics;
  const bool read = library_.load(script, diagnostics) != nullptr;
  meshes_.keep_within(library_);
  if (read && !diagnostics.has_errors())
    program_ = mansard::compile(library_, meshes_, options, diagnostics);
  diagnostics.sort();
  for (const Diagnostic& d : diagnostics.all()) print(d);
  return program_ != nullptr;
}

CompileOptions compile_options(const Arguments& arguments) {
  CompileOptions options;
  options.style = arguments.text("--style", "");
  for (const std::string& text : arguments.values("--set"))
    options.settings.push_back(name_and_value(text, "--set"));
  return options;
}

DeriveOptions derive_options(const Arguments& arguments, const Program& program,
                             std::optional<int> lod) {
  DeriveOptions options;
  const uint64_t carried = program.styles[program.main_style].linked->seed.value_or(0);
  options.seed = static_cast<uint64_t>(
      arguments.number("--seed", static_cast<long long>(carried), 0, 1'000'000'000'000'000));
  options.lod = lod ? *lod : static_cast<int>(arguments.number("--lod", 3, 1, 3));
  options.max_depth = static_cast<uint32_t>(arguments.number("--max-depth", 1000, 1, 60000));
  options.max_shapes =
      static_cast<std::size_t>(arguments.number("--max-shapes", 5'000'000, 1, 1'000'000'000));
  options.strict = arguments.has("--strict");
  return options;
}

int thread_option(const Arguments& arguments) {
  return static_cast<int>(arguments.number("--threads", 0, 1, 1024));
}

FootprintOptions footprint_options(const Arguments& arguments) {
  FootprintOptions options;
  options.id = arguments.text("--id", "");
  options.layer = arguments.text("--layer", "");
  options.where = arguments.text("--where", "");
  options.limit = static_cast<std::size_t>(arguments.number("--limit", 0, 1, 1'000'000'000));
  for (const std::string& text : arguments.values("--select")) {
    const auto [name, value] = name_and_value(text, "--select");
    if (name != "id") throw UsageError("--select takes id=ID, not '" + text + "'");
    options.select.push_back(value);
  }
  for (const std::string& text : arguments.values("--attr")) {
    const auto [name, value] = name_and_value(text, "--attr");
    options.attributes.push_back({name, value});
  }
  return options;
}

namespace {

/// A file of another place gives no wall a street, and nobody would see why.
void check_near(const Session& session, const std::string& what,
                const std::vector<StreetLine>& lines, const FootprintStore& footprints) {
  const Streets streets(lines);
  double nearest = std::numeric_limits<double>::infinity();
  Footprint footprint;
  for (std::size_t i = 0; i < footprints.size(); ++i) {
    for (const Vec2 p : footprints.get(i, footprint).polygon.points) {
      if (const auto near = streets.nearest(p, p, nearest)) nearest = near->distance;
      if (nearest <= street_reach) return;
    }
  }
  Diagnostic d;
  d.severity = Severity::warning;
  d.text =
      "no street of '" + what + "' comes within " + number_text(street_reach) + " m of a footprint";
  if (std::isfinite(nearest))
    d.text += ": the nearest is " + number_text(std::round(nearest)) + " m away";
  d.help = "are they of the same place, in the same coordinates?";
  session.print(d);
}

std::vector<StreetLine> streets(const Session& session, const StoredSet& set,
                                const Arguments& arguments) {
  const auto what = arguments.value("--streets");
  for (const char* const flag : {"--streets-layer", "--streets-where"}) {
    if (!what && arguments.has(flag))
      throw UsageError(std::string(flag) + " is about the file of --streets, which is missing");
  }
  if (!what) return {};
  StreetSet read = read_streets(
      *what, {arguments.text("--streets-layer", ""), arguments.text("--streets-where", "")}, set);
  for (const std::string& note : read.notes) session.say("note: streets: " + note);
  check_near(session, *what, read.lines, set.footprints);
  return std::move(read.lines);
}

void say_dropped(const Session& session, const FootprintFacts& set) {
  char bound[32];
  std::snprintf(bound, sizeof bound, "%.1f", set.least_area);
  session.say(std::to_string(set.small.size()) +
              (set.small.size() == 1 ? " footprint" : " footprints") + " under " + bound +
              " square metres, a tenth of the mean, left out");
}

/// Returns how many were left out.
std::size_t tell(const Session& session, const std::vector<FootprintNote>& notes, bool keep_going) {
  constexpr std::size_t most_notes = 10;
  std::size_t repaired = 0, left_out = 0;
  for (const FootprintNote& note : notes) {
    const std::string text =
        note.id.empty() ? note.text : "footprint '" + note.id + "': " + note.text;
    if (note.broken && !keep_going) {
      Diagnostic d;
      d.text = text;
      d.help = "--keep-going leaves it out and derives the rest";
      throw Failure(std::move(d));
    }
    if (note.broken) {
      ++left_out;
      Diagnostic d;
      d.text = text + "; it is left out";
      session.print(d);
    } else if (++repaired <= most_notes) {
      session.say("note: " + text);
    }
  }
  if (repaired > most_notes)
    session.say("note: and " + std::to_string(repaired - most_notes) + " more like these");
  return left_out;
}

}  // namespace

StoredSet stored_footprints(const Session& session, const std::string& what,
                            const Arguments& arguments, std::size_t& failed) {
  // Party walls are marked before neighbours are taken away.
  FootprintOptions options = footprint_options(arguments);
  const auto select = std::exchange(options.select, {});
  const std::size_t limit = std::exchange(options.limit, 0);
  StoredSet set = store_footprints(what, options);
  if (arguments.has("--drop-small")) {
    drop_small(set);
    say_dropped(session, set);
  }
  mark_neighbours(set, streets(session, set, arguments));
  choose_footprints(set, select, limit);
  if (session.compiled()) {
    for (const Diagnostic& d : misnamed_properties(session.program(), set.properties))
      session.print(d);
  }
  failed += tell(session, set.notes, arguments.has("--keep-going"));
  return set;
}

FootprintSet footprints(const Session& session, const std::string& what, const Arguments& arguments,
                        std::size_t& failed) {
  return read_all(stored_footprints(session, what, arguments, failed));
}

}  // namespace mansard
