// Footprints that are kept on disk are the same as those in memory.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <random>
#include <set>
#include <thread>

#include "formats/footprints.hpp"
#include "formats/free_names.hpp"
#include "formats/packed.hpp"
#include "formats/streets.hpp"
#include "interpreter/surroundings.hpp"

using namespace mansard;

namespace {

bool same(const Footprint& a, const Footprint& b) {
  const auto alike = [](const Property& p, const Property& q) {
    return p.name == q.name && p.value == q.value;
  };
  return a.id == b.id && a.place == b.place && a.polygon.points == b.polygon.points &&
         a.polygon.tags == b.polygon.tags && a.polygon.ring_ends == b.polygon.ring_ends &&
         std::ranges::equal(a.properties, b.properties, alike);
}

std::string word(std::mt19937& random) {
  std::string text(random() % 40, ' ');
  for (char& c : text) c = static_cast<char>(random());
  return text;
}

Footprint any_footprint(std::mt19937& random) {
  Footprint footprint;
  footprint.id = word(random);
  for (uint32_t ring = random() % 3; ring-- > 0;) {
    for (uint32_t i = random() % 50; i-- > 0;)
      footprint.polygon.add_point({std::ldexp(random(), -20), -std::ldexp(random(), 9)},
                                  {static_cast<uint16_t>(random()), static_cast<uint16_t>(i)});
    footprint.polygon.close_ring();
  }
  for (uint32_t i = random() % 6; i-- > 0;) {
    const PropertyValue values[]{std::ldexp(random(), -7), random() % 2 == 0, word(random)};
    footprint.properties.push_back({word(random), values[random() % 3]});
  }
  return footprint;
}

/// Terraces of many depths, with a building every so often that is far longer than the others.
std::vector<Footprint> town(std::size_t count, unsigned seed) {
  std::mt19937 random(seed);
  std::vector<Footprint> houses;
  for (std::size_t i = 0; i < count; ++i) {
    const bool is_long = random() % 97 == 0;
    const std::size_t row = i / 50, column = i % 50;
    Footprint& house = houses.emplace_back();
    house.id = std::to_string(i);
    house.polygon = rectangle(is_long ? 60 : 6, 8 + static_cast<double>(random() % 7));
    translate(house.polygon, {6.0 * static_cast<double>(column), 23.0 * static_cast<double>(row)});
  }
  std::ranges::shuffle(houses, random);
  return houses;
}

StoredSet stored(const std::vector<Footprint>& footprints) {
  StoredSet set;
  for (const Footprint& footprint : footprints) set.footprints.add(footprint);
  return set;
}

/// Marked on disk as in memory, and with the same surroundings.
void check_neighbours(std::vector<Footprint> all, const std::vector<StreetLine>& streets) {
  StoredSet set = stored(all);
  mark_neighbours(all, streets);
  mark_neighbours(set, streets);
  REQUIRE(set.footprints.size() == all.size());
  std::size_t differing = 0;
  std::vector<uint32_t> near, also_near;
  set.footprints.for_each([&](uint32_t i, const Footprint& footprint) {
    differing += !same(footprint, all[i]);
    const Box2 plan = bounds(all[i].polygon.points);
    const Box3 box{{plan.low.x, 0, -plan.high.y}, {plan.high.x, 1, -plan.low.y}};
    footprint.around->near(box, near);
    all[i].around->near(box, also_near);
    differing += near != also_near || footprint.around->id(i) != all[i].id;
  });
  CHECK(differing == 0);
}

}  // namespace

TEST_CASE("records come back from memory and from disk") {
  constexpr unsigned seed = 3;
  CAPTURE(seed);
  std::mt19937 random(seed);
  std::vector<std::string> all;
  RecordFile records;
  for (std::size_t bytes = 0; bytes < std::size_t(10) << 20;) {
    const std::size_t size = random() % 200 == 0 ? random() % (3 << 20) : random() % 3000;
    all.emplace_back(size, static_cast<char>('a' + random() % 26));
    records.add(all.back());
    bytes += size;
  }
  REQUIRE(records.size() == all.size());
  std::array<std::size_t, 2> wrong{};
  const auto read = [&](std::size_t who) {
    std::string record;
    for (std::size_t i = 0; i < all.size(); ++i) {
      const std::size_t number = who == 0 ? i : all.size() - 1 - i;
      records.read(number, record);
      wrong[who] += record != all[number];
    }
  };
  std::thread other(read, 1);
  read(0);
  other.join();
  CHECK(wrong == std::array<std::size_t, 2>{});
}

TEST_CASE("where nothing can be kept the folder is named, and what to do") {
  const char* const before = std::getenv("TMPDIR");
  const std::string usual = before ? before : "";
  setenv("TMPDIR", "/proc", 1);
  Diagnostic said;
  try {
    RecordFile records;
    const std::string record(1 << 20, 'a');
    for (int i = 0; i < 5; ++i) records.add(record);
  } catch (const Failure& failure) {
    said = failure.diagnostic;
  }
  before ? setenv("TMPDIR", usual.c_str(), 1) : unsetenv("TMPDIR");
  CHECK(said.text.starts_with("can not keep footprints in '/proc': "));
  CHECK(said.help.find("TMPDIR") != said.help.npos);
}

TEST_CASE("a footprint is the same after its way through bytes, whatever was there before") {
  constexpr unsigned seed = 8;
  CAPTURE(seed);
  std::mt19937 random(seed);
  Footprint room;
  std::string bytes;
  for (int i = 0; i < 2000; ++i) {
    const Footprint footprint = any_footprint(random);
    pack(footprint, bytes);
    unpack(bytes, room);
    REQUIRE(same(footprint, room));
  }
}

TEST_CASE("footprints that are kept keep their places") {
  const std::vector<Footprint> all = town(300, 1);
  FootprintStore store = stored(all).footprints;
  store.keep_if([](const Footprint& f) { return f.place % 3 == 0; });
  store.keep({1, 4, 99});
  Footprint room;
  REQUIRE(store.size() == 3);
  CHECK(store.get(0, room).place == 3);
  CHECK(store.get(1, room).id == all[12].id);
  CHECK(store.get(2, room).place == 297);
}

TEST_CASE("party walls and streets are marked on disk as in memory") {
  check_neighbours({}, {});
  check_neighbours(town(1700, 4), {});
  check_neighbours(town(1700, 5), {{{-50, 19}, {400, 19}}, {{120, -50}, {120, 900}}});
}

TEST_CASE("real towns are marked on disk as in memory") {
  bool any = false;
  for (const char* const name : {"monaco", "helsinki", "baltimore"}) {
    const std::string path = std::string("../shared/data/") + name + ".osm.pbf";
    if (!std::filesystem::exists(path)) continue;
    any = true;
    CAPTURE(name);
    const FootprintSet set = read_footprints(path, {});
    check_neighbours(set.footprints, {});
    check_neighbours(set.footprints, read_streets(path, {}, set).lines);
  }
  if (!any) MESSAGE("skipped: there are no real footprints beside the project");
}

TEST_CASE("nobody gets a name that another one has") {
  constexpr unsigned seed = 6;
  CAPTURE(seed);
  std::mt19937 random(seed);
  FreeNames names(':');
  std::set<std::string> given;
  for (int i = 0; i < 20000; ++i) {
    std::string wanted = std::to_string(random() % 5000);
    if (random() % 5 == 0) wanted += ":" + std::to_string(2 + random() % 3);
    CHECK(names.is_taken(wanted) == given.contains(wanted));
    const std::string name = names.next(wanted);
    REQUIRE(given.insert(name).second);
    if (name != wanted) REQUIRE(name.starts_with(wanted + ":"));
  }
  FreeNames few(':');
  CHECK(few.next("a") == "a");
  CHECK(few.next("a") == "a:2");
  CHECK(few.next("a") == "a:3");
  CHECK(few.next("a:2") == "a:2:2");
}
