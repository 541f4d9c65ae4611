// Footprints to put roofs on: random ones, and real ones from files.
#pragma once

#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "geometry/polygon.hpp"

namespace mansard::test {

/// Whether to take one's time over all real footprints.
inline const bool long_run = std::getenv("MANSARD_LONG_TESTS") != nullptr;

struct Named {
  std::string name;
  Polygon polygon;
  std::string set = {};  ///< the file it comes from
};

/// The rings of a WKT polygon; an empty polygon for what is none.
inline Polygon polygon_of_wkt(const std::string& wkt) {
  Polygon polygon;
  if (wkt.rfind("POLYGON", 0) != 0) return polygon;
  const char* at = wkt.c_str() + 7;
  std::vector<Vec2> ring;
  while (*at != 0) {
    char* end = nullptr;
    const double x = std::strtod(at, &end);
    if (end == at) {
      if (*at == ')' && !ring.empty()) {
        if (ring.size() > 1 && ring.front() == ring.back()) ring.pop_back();
        for (const Vec2 p : ring) polygon.add_point(p);
        polygon.close_ring();
        ring.clear();
      }
      ++at;
      continue;
    }
    at = end;
    const double y = std::strtod(at, &end);
    if (end == at) return {};
    at = end;
    ring.push_back({x, y});
  }
  for (std::size_t i = 0; i < polygon.points.size(); ++i) {
    polygon.tags[i].wall = static_cast<uint16_t>(i);
  }
  if (!polygon.empty()) orient(polygon);
  return polygon;
}

/// Every `step`th line of the files of real footprints, every `hard_step`th of the hard ones; empty
/// where they are missing.
inline std::vector<Named> real_footprints(std::size_t step, std::size_t hard_step = 3) {
  const std::filesystem::path data = std::filesystem::path(MANSARD_ROOT) / "../shared/data";
  std::vector<Named> found;
  std::string text;
  const auto add_lines = [&](const char* set, char separator, std::size_t every) {
    std::size_t line = 0;
    for (std::size_t begin = 0; begin < text.size(); ++line) {
      const std::size_t end = std::min(text.find('\n', begin), text.size());
      const std::string one = text.substr(begin, end - begin);
      begin = end + 1;
      if (line % every != 0 || one.empty() || one[0] == '#') continue;
      Polygon polygon = polygon_of_wkt(one.substr(one.rfind(separator) + 1));
      if (!polygon.empty()) found.push_back({one.substr(0, one.find(separator)), polygon, set});
    }
  };
  if (std::ifstream hard(data / "hard_footprints.wkt"); hard) {
    text.assign(std::istreambuf_iterator<char>(hard), {});
    add_lines("hard", ';', std::min(step, hard_step));
  }
  for (const char* set :
       {"baltimore", "bayreuth", "bpypolyskel", "helsinki", "liechtenstein", "monaco"}) {
    const auto path = data / "footprints" / (std::string(set) + ".tsv.gz");
    if (!std::filesystem::exists(path)) continue;
    FILE* pipe = popen(("gzip -dc '" + path.string() + "'").c_str(), "r");
    if (pipe == nullptr) continue;
    text.clear();
    std::array<char, 65536> buffer;
    for (std::size_t n; (n = fread(buffer.data(), 1, buffer.size(), pipe)) > 0;) {
      text.append(buffer.data(), n);
    }
    pclose(pipe);
    add_lines(set, '\t', step);
  }
  return found;
}

/// Turned and moved L, T, U shapes, stars, rectangles, squares, rings and shapes with points that
/// are collinear but for the last bits.
class RandomFootprints {
 public:
  explicit RandomFootprints(unsigned seed) : random_(seed) {}

  Polygon next() {
    Polygon p;
    const double a = length(), b = length(), c = length(), d = length(), e = length();
    switch (random_() % 9) {
      case 0:
        p = of({{0, 0}, {a, 0}, {a, b}, {0, b}});
        break;
      case 1:
        p = of({{0, 0}, {a, 0}, {a, a}, {0, a}});
        break;
      case 2:
        p = of({{0, 0}, {a + b, 0}, {a + b, c}, {a, c}, {a, c + d}, {0, c + d}});
        break;
      case 3:
        p = of({{0, 0},
                {a + b + c, 0},
                {a + b + c, d},
                {a + b, d},
                {a + b, d + e},
                {a, d + e},
                {a, d},
                {0, d}});
        break;
      case 4:
        p = of({{0, 0},
                {a + b + c, 0},
                {a + b + c, d + e},
                {a + b, d + e},
                {a + b, d},
                {a, d},
                {a, d + e},
                {0, d + e}});
        break;
      case 5:
        p = star();
        break;
      case 6:
        p = of({{0, 0}, {a + b + c, 0}, {a + b + c, a + d + e}, {0, a + d + e}});
        for (const Vec2 q : {Vec2{a, a}, {a, a + d}, {a + b, a + d}, {a + b, a}}) p.add_point(q);
        p.close_ring();
        break;
      case 7:
        p = of({{0, 0}, {a, 0}, {a * unit(), b}});
        break;
      default:
        p = of({{0, 0}, {a + b, 0}, {a + b, c}, {a + 0.4 * b, c}, {0.3 * a, c}});
        break;
    }
    place(p);
    if (random_() % 2 == 0) split_edges(p);
    for (std::size_t i = 0; i < p.tags.size(); ++i) p.tags[i].wall = static_cast<uint16_t>(i);
    return p;
  }

 private:
  double unit() { return std::uniform_real_distribution<>(0, 1)(random_); }
  double length() { return random_() % 3 == 0 ? 1 + random_() % 12 : 1 + 14 * unit(); }
  static Polygon of(std::initializer_list<Vec2> points) {
    Polygon p;
    for (const Vec2 q : points) p.add_point(q);
    p.close_ring();
    return p;
  }
  Polygon star() {
    Polygon p;
    const int n = 5 + static_cast<int>(random_() % 12);
    for (int i = 0; i < n; ++i) {
      const double angle = 2 * std::numbers::pi * i / n, radius = 3 + 9 * unit();
      p.add_point({radius * std::cos(angle), radius * std::sin(angle)});
    }
    p.close_ring();
    return p;
  }
  void place(Polygon& p) {
    const double angle = random_() % 3 == 0 ? 0 : 7 * unit();
    const Vec2 by = random_() % 2 == 0 ? Vec2{} : Vec2{1000 * unit(), -1000 * unit()};
    for (Vec2& q : p.points) {
      q = by + Vec2{q.x * std::cos(angle) - q.y * std::sin(angle),
                    q.x * std::sin(angle) + q.y * std::cos(angle)};
    }
  }
  // Points computed on edges, as grammars make them.
  void split_edges(Polygon& p) {
    Polygon more;
    for (std::size_t r = 0; r < p.rings(); ++r) {
      const auto ring = p.ring(r);
      for (std::size_t i = 0; i < ring.size(); ++i) {
        more.add_point(ring[i]);
        if (random_() % 2 == 0) more.add_point(mix(ring[i], ring[(i + 1) % ring.size()], unit()));
      }
      more.close_ring();
    }
    p = more;
  }

  std::mt19937 random_;
};

}  // namespace mansard::test
