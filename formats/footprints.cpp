#include "formats/footprints.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <unordered_set>

#include "formats/footprint_sources.hpp"
#include "formats/free_names.hpp"
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
  Building(const RawSet& raw, const FootprintOptions& options) : raw_(raw), options_(options) {
    set_.notes = raw.notes;
    set_.origin = raw.origin;
    set_.shift = raw.shift;
    set_.reference = raw.reference;
  }

  StoredSet footprints() {
    raw_.for_each([&](RawFeature& feature) { add(feature); });
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
    for (const Property& property : feature.properties) {
      if (names_.insert(property.name).second) set_.properties.push_back(property.name);
    }
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
      set_.footprints.add({i == 0 ? id : ids_.next(feature.id), std::move(cleaned.polygons[i]),
                           feature.properties});
    }
    return cleaned.polygons.size();
  }

  const RawSet& raw_;
  const FootprintOptions& options_;
  StoredSet set_;
  FreeNames ids_{':'};
  std::unordered_set<std::string> names_;  ///< of properties
  std::size_t repeated_ = 0;
};

/// `a` chooses a and its further parts a:2, a:3.
bool is_chosen(const std::string& id, const std::string& choice) {
  if (id.compare(0, choice.size(), choice) != 0) return false;
  if (id.size() == choice.size()) return true;
  return id[choice.size()] == ':' && id.size() > choice.size() + 1 &&
         id.find_first_not_of("0123456789", choice.size() + 1) == id.npos;
}

void check_choice(const StoredSet& set, const std::vector<std::string>& ids,
                  const std::string& choice) {
  const auto chosen = [&](const std::string& id) { return is_chosen(id, choice); };
  if (std::ranges::any_of(ids, chosen)) return;
  if (std::ranges::any_of(set.notes, chosen, &FootprintNote::id)) return;  // broken, and said so
  if (std::ranges::any_of(set.small, chosen))
    fail("footprint '" + choice + "' has less than a tenth of the mean area and is left out",
         "derive it without --drop-small");
  const auto near = nearest(choice, std::vector<std::string_view>(ids.begin(), ids.end()));
  std::string help;
  if (near) {
    help = "did you mean '" + std::string(*near) + "'?";
  } else if (!ids.empty()) {
    help = "ids here look like '" + ids.front() + "'";
  }
  fail("there is no footprint '" + choice + "'", help);
}

std::vector<std::string> ids_of(const FootprintStore& footprints) {
  std::vector<std::string> ids;
  footprints.for_each([&](uint32_t, const Footprint& footprint) { ids.push_back(footprint.id); });
  return ids;
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

StoredSet store_footprints(const std::string& what, const FootprintOptions& options) {
  const RawSet raw = read_raw(what, options);
  StoredSet set = Building(raw, options).footprints();
  choose_footprints(set, options.select, options.limit);
  return set;
}

FootprintSet read_footprints(const std::string& what, const FootprintOptions& options) {
  return read_all(store_footprints(what, options));
}

FootprintSet read_all(StoredSet stored) {
  FootprintSet set{static_cast<FootprintFacts&&>(stored), {}};
  set.footprints.resize(stored.footprints.size());
  for (std::size_t i = 0; i < set.footprints.size(); ++i)
    stored.footprints.get(i, set.footprints[i]);
  return set;
}

void drop_small(StoredSet& set, double share) {
  double sum = 0;
  set.footprints.for_each([&](uint32_t, const Footprint& f) { sum += area(f.polygon); });
  set.least_area =
      share * sum / static_cast<double>(std::max<std::size_t>(set.footprints.size(), 1));
  set.footprints.keep_if([&](const Footprint& footprint) {
    if (area(footprint.polygon) >= set.least_area) return true;
    set.small.push_back(footprint.id);
    return false;
  });
  const std::unordered_set<std::string> dropped(set.small.begin(), set.small.end());
  std::erase_if(set.notes, [&](const FootprintNote& note) { return dropped.count(note.id) > 0; });
}

void choose_footprints(StoredSet& set, const std::vector<std::string>& select, std::size_t limit) {
  if (select.empty() && limit == 0) return;
  std::vector<std::string> ids = ids_of(set.footprints);
  for (const std::string& choice : select) check_choice(set, ids, choice);
  const auto is_selected = [&](const std::string& id) {
    return select.empty() || std::any_of(select.begin(), select.end(),
                                         [&](const std::string& s) { return is_chosen(id, s); });
  };
  std::vector<uint32_t> numbers;
  std::unordered_set<std::string> kept;
  for (uint32_t i = 0; i < ids.size(); ++i) {
    if (!is_selected(ids[i]) || (limit > 0 && numbers.size() == limit)) continue;
    numbers.push_back(i);
    kept.insert(std::move(ids[i]));
  }
  set.footprints.keep(numbers);

  // Notes go with what they are about; when nothing is left they say why.
  std::erase_if(set.notes, [&](const FootprintNote& note) {
    if (note.id.empty() || kept.count(note.id) > 0) return false;
    return !is_selected(note.id) || (limit > 0 && !kept.empty());
  });
}

}  // namespace mansard
