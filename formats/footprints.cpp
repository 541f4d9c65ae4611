#include "formats/footprints.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <unordered_map>
#include <unordered_set>

#include "formats/footprint_sources.hpp"
#include "formats/rings.hpp"

namespace mansard {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(std::string text, std::string help = {}) {
  Diagnostic d;
  d.text = std::move(text);
  d.help = std::move(help);
  throw Failure(std::move(d));
}

std::string lower_ending(const std::string& path) {
  std::string ending = fs::path(path).extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? char(c + 32) : c; });
  return ending;
}

/// Of the files in the folder where one is missing the one with nearly its name.
std::string nearest_beside(const fs::path& missing) {
  constexpr std::size_t most = 1000;
  const fs::path folder = missing.has_parent_path() ? missing.parent_path() : fs::path(".");
  std::vector<std::string> names;
  std::error_code error;
  for (fs::directory_iterator it(folder, error), end; !error && it != end && names.size() < most;
       it.increment(error)) {
    names.push_back(it->path().filename().string());
  }
  std::sort(names.begin(), names.end());
  const std::vector<std::string_view> views(names.begin(), names.end());
  const auto near = nearest(missing.filename().string(), views);
  return near ? std::string(*near) : std::string();
}

[[noreturn]] void fail_missing(const std::string& what, const std::string& forms) {
  std::string help = what.find_first_of(":(") != what.npos ? "or write " + forms : "";
  if (!what.empty() && what.find_first_not_of("0123456789.x") == what.npos &&
      what.find('x') != what.npos)
    help = "a rectangle is written rect:" + what;
  if (const std::string near = nearest_beside(what); help.empty() && !near.empty())
    help = "did you mean '" + near + "'?";
  fail("no such file: '" + what + "'", help);
}

RawSet read_raw(const std::string& what, const FootprintOptions& options) {
  if (std::optional<RawSet> literal = read_literal(what)) return std::move(*literal);
  check_is_file(what, "footprints", literal_forms());
  return lower_ending(what) == ".obj" ? read_obj_footprints(what) : read_gis(what, options);
}

/// Hands out ids that nobody else has: a, a:2, a:3.
class Ids {
 public:
  std::string next(const std::string& wanted) {
    std::string id = wanted;
    for (std::size_t& n = given_[wanted]; !taken_.insert(id).second;) {
      id = wanted + ":" + std::to_string(n = std::max<std::size_t>(n, 1) + 1);
    }
    return id;
  }
  bool is_taken(const std::string& id) const { return taken_.count(id) > 0; }

 private:
  std::unordered_map<std::string, std::size_t> given_;
  std::unordered_set<std::string> taken_;
};

void give(std::vector<Property>& to, const std::vector<Property>& attributes) {
  for (const Property& attribute : attributes) {
    const auto old = std::find_if(to.begin(), to.end(),
                                  [&](const Property& p) { return p.name == attribute.name; });
    if (old == to.end()) {
      to.push_back(attribute);
    } else {
      old->value = attribute.value;
    }
  }
}

/// From features to footprints: a building a polygon.
class Building {
 public:
  Building(RawSet raw, const FootprintOptions& options) : raw_(std::move(raw)), options_(options) {
    set_.notes = std::move(raw_.notes);
    set_.origin = raw_.origin;
    set_.shift = raw_.shift;
    set_.reference = std::move(raw_.reference);
  }

  FootprintSet footprints() {
    for (RawFeature& feature : raw_.features) add(feature);
    if (repeated_ > 0) {
      set_.notes.push_back(
          {"", std::to_string(repeated_) + " ids were given before and are numbered", false});
    }
    return std::move(set_);
  }

 private:
  void add(RawFeature& feature) {
    if (ids_.is_taken(feature.id)) ++repeated_;
    give(feature.properties, options_.attributes);
    if (feature.parts.empty()) {
      set_.notes.push_back({ids_.next(feature.id), "is empty", true});
      return;
    }
    std::size_t buildings = 0;
    for (const RawPolygon& part : feature.parts) buildings += add(feature, part);
    if (buildings > 1) {
      set_.notes.push_back(
          {feature.id, "has " + std::to_string(buildings) + " parts, each a building of its own",
           false});
    }
  }

  std::size_t add(const RawFeature& feature, const RawPolygon& part) {
    CleanedRings cleaned = clean_rings(part, raw_.rings_close);
    const std::string id = ids_.next(feature.id);
    for (const std::string& note : cleaned.notes) {
      set_.notes.push_back({id, note, cleaned.polygons.empty()});
    }
    for (std::size_t i = 0; i < cleaned.polygons.size(); ++i) {
      set_.footprints.push_back({i == 0 ? id : ids_.next(feature.id),
                                 std::move(cleaned.polygons[i]), feature.properties});
    }
    return cleaned.polygons.size();
  }

  RawSet raw_;
  const FootprintOptions& options_;
  FootprintSet set_;
  Ids ids_;
  std::size_t repeated_ = 0;
};

/// `a` chooses a and its further parts a:2, a:3.
bool is_chosen(const std::string& id, const std::string& choice) {
  if (id.compare(0, choice.size(), choice) != 0) return false;
  if (id.size() == choice.size()) return true;
  return id[choice.size()] == ':' && id.size() > choice.size() + 1 &&
         id.find_first_not_of("0123456789", choice.size() + 1) == id.npos;
}

void check_choice(const FootprintSet& set, const std::string& choice) {
  const auto chosen = [&](const auto& x) { return is_chosen(x.id, choice); };
  if (std::any_of(set.footprints.begin(), set.footprints.end(), chosen)) return;
  if (std::any_of(set.notes.begin(), set.notes.end(), chosen)) return;  // broken, and said so
  if (std::any_of(set.small.begin(), set.small.end(),
                  [&](const std::string& id) { return is_chosen(id, choice); }))
    fail("footprint '" + choice + "' has less than a tenth of the mean area and is left out",
         "derive it without --drop-small");
  std::vector<std::string_view> ids;
  for (const Footprint& footprint : set.footprints) ids.push_back(footprint.id);
  const auto near = nearest(choice, ids);
  std::string help;
  if (near) {
    help = "did you mean '" + std::string(*near) + "'?";
  } else if (!ids.empty()) {
    help = "ids here look like '" + std::string(ids.front()) + "'";
  }
  fail("there is no footprint '" + choice + "'", help);
}

}  // namespace

void check_is_file(const std::string& what, std::string_view content, const std::string& forms) {
  std::error_code error;
  const fs::file_status status = fs::status(what, error);
  if (!fs::exists(status)) fail_missing(what, forms);
  const std::string no_file = ", not a file of " + std::string(content);
  if (fs::is_directory(status) && lower_ending(what) != ".gdb") {
    fail("'" + what + "' is a folder" + no_file);
  }
  if (!fs::is_regular_file(status) && !fs::is_directory(status)) {
    fail("'" + what + "' is a device or a pipe" + no_file);
  }
}

FootprintSet read_footprints(const std::string& what, const FootprintOptions& options) {
  FootprintSet set = Building(read_raw(what, options), options).footprints();
  choose_footprints(set, options.select, options.limit);
  return set;
}

void drop_small(FootprintSet& set, double share) {
  double sum = 0;
  for (const Footprint& footprint : set.footprints) sum += area(footprint.polygon);
  set.least_area =
      share * sum / static_cast<double>(std::max<std::size_t>(set.footprints.size(), 1));
  std::unordered_set<std::string> dropped;
  std::erase_if(set.footprints, [&](const Footprint& footprint) {
    if (area(footprint.polygon) >= set.least_area) return false;
    set.small.push_back(footprint.id);
    dropped.insert(footprint.id);
    return true;
  });
  std::erase_if(set.notes, [&](const FootprintNote& note) { return dropped.count(note.id) > 0; });
}

void choose_footprints(FootprintSet& set, const std::vector<std::string>& select,
                       std::size_t limit) {
  for (const std::string& choice : select) check_choice(set, choice);
  const auto is_selected = [&](const std::string& id) {
    return select.empty() || std::any_of(select.begin(), select.end(),
                                         [&](const std::string& s) { return is_chosen(id, s); });
  };
  std::erase_if(set.footprints, [&](const Footprint& f) { return !is_selected(f.id); });
  if (limit > 0 && set.footprints.size() > limit) set.footprints.resize(limit);

  // Notes go with what they are about; when nothing is left they say why.
  std::unordered_set<std::string> kept;
  for (const Footprint& footprint : set.footprints) kept.insert(footprint.id);
  std::erase_if(set.notes, [&](const FootprintNote& note) {
    if (note.id.empty() || kept.count(note.id) > 0) return false;
    return !is_selected(note.id) || (limit > 0 && !kept.empty());
  });
}

}  // namespace mansard
