#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <random>

#include "geometry/dormer.hpp"
#include "geometry/mesh.hpp"
#include "tests/geometry/solid_checks.hpp"

using namespace mansard;
using test::is_closed;

namespace {

constexpr std::array kinds{DormerKind::flat, DormerKind::shed, DormerKind::gable, DormerKind::hip,
                           DormerKind::eyebrow};

double tangent(double degrees) { return std::tan(degrees * std::numbers::pi / 180); }

Mesh mesh_of(const std::vector<DormerFace>& faces) {
  Mesh mesh;
  for (const DormerFace& face : faces) {
    std::vector<uint32_t> loop;
    for (const Vec3 p : face.loop) {
      loop.push_back(static_cast<uint32_t>(mesh.points.size()));
      mesh.points.push_back(p);
    }
    mesh.add_face(loop);
  }
  return mesh;
}

/// How far a point lies above the slope.
double above(const DormerOptions& options, Vec3 p) { return p.z - p.y * tangent(options.slope); }

/// Adds the underside: the loops of edges without an opposite, which must lie in the slope.
Mesh closed_below(Mesh mesh, const DormerOptions& options) {
  std::vector<std::pair<Vec3, Vec3>> open;
  for (const Mesh::Face& face : mesh.faces) {
    const auto loop = mesh.loop(face);
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const Vec3 a = mesh.points[loop[i]], b = mesh.points[loop[(i + 1) % loop.size()]];
      const auto opposite = std::find_if(open.begin(), open.end(), [&](const auto& e) {
        return length(e.first - b) < 1e-9 && length(e.second - a) < 1e-9;
      });
      if (opposite == open.end())
        open.emplace_back(a, b);
      else
        open.erase(opposite);
    }
  }
  while (!open.empty()) {
    std::vector<uint32_t> loop;
    const Vec3 start = open[0].second;
    Vec3 at = open[0].first;
    open.erase(open.begin());
    loop.push_back(static_cast<uint32_t>(mesh.points.size()));
    mesh.points.push_back(start);
    while (length(at - start) > 1e-9) {
      REQUIRE(std::abs(above(options, at)) < 1e-9);
      loop.push_back(static_cast<uint32_t>(mesh.points.size()));
      mesh.points.push_back(at);
      const auto before = std::find_if(open.begin(), open.end(),
                                       [&](const auto& e) { return length(e.second - at) < 1e-9; });
      REQUIRE(before != open.end());
      at = before->first;
      open.erase(before);
    }
    mesh.add_face(loop);
  }
  return mesh;
}

/// The volume over the slope.
double volume_of(const DormerOptions& options) {
  const std::vector<DormerFace> faces = dormer(options);
  REQUIRE(!faces.empty());
  const Mesh mesh = closed_below(mesh_of(faces), options);
  CHECK(is_closed(mesh));
  return test::volume(mesh);
}

}  // namespace

TEST_CASE("dormers are planar, finite and closed with the slope") {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> unit(0, 1);
  for (int i = 0; i < 400; ++i) {
    for (const DormerKind kind : kinds) {
      DormerOptions options;
      options.kind = kind;
      options.width = 0.3 + 4 * unit(random);
      options.height = 0.3 + 3 * unit(random);
      options.slope = 5 + 80 * unit(random);
      options.pitch = 2 + 83 * unit(random);
      if (kind == DormerKind::shed) options.pitch = options.slope * (0.05 + 0.9 * unit(random));
      options.overhang = unit(random) < 0.5 ? 0 : 0.5 * unit(random);
      options.thickness = 0.02 + 0.2 * unit(random);
      CAPTURE(static_cast<int>(kind));
      CAPTURE(options.width);
      CAPTURE(options.height);
      CAPTURE(options.slope);
      CAPTURE(options.pitch);
      CAPTURE(options.overhang);
      const std::vector<DormerFace> faces = dormer(options);
      REQUIRE(faces.size() >= 4);
      const Mesh mesh = mesh_of(faces);
      CHECK(test::unevenness(mesh) < 1e-9);
      for (const DormerFace& face : faces) CHECK(length(newell(face.loop)) > 1e-9);
      CHECK(volume_of(options) > 0);
    }
  }
}

TEST_CASE("dormers without overhang hold the volume of their formula") {
  DormerOptions options;
  options.width = 1.8;
  options.height = 1.6;
  options.slope = 40;
  options.pitch = 25;
  const double a = tangent(40), p = tangent(25), w = options.width;
  const double depth = options.height * std::cos(40 * std::numbers::pi / 180), rise = depth * a;

  options.kind = DormerKind::flat;  // a wedge
  CHECK(volume_of(options) == doctest::Approx(w * depth * rise / 2));
  CHECK(front_height(options) == doctest::Approx(rise));

  options.kind = DormerKind::shed;
  CHECK(volume_of(options) == doctest::Approx(w * depth * front_height(options) / 2));
  CHECK(front_height(options) == doctest::Approx(depth * (a - p)));

  // Over each point of the front, the roof's height squared over twice the slope's tangent.
  const auto cubed = [](double v) { return v * v * v; };
  const double top = rise + w / 2 * p;
  options.kind = DormerKind::gable;
  const double gabled = (cubed(top) - cubed(rise)) / (3 * a * p);
  CHECK(volume_of(options) == doctest::Approx(gabled));

  // The hip takes away what lies between the end's plane and the gable's over the front
  // half-square.
  options.kind = DormerKind::hip;
  options.height = 2.4;
  const double high = options.height * std::sin(40 * std::numbers::pi / 180);
  const double whole = (cubed(high + w / 2 * p) - cubed(high)) / (3 * a * p);
  CHECK(volume_of(options) == doctest::Approx(whole - p * cubed(w) / 24));

  // 12 chords of a circle's segment: the sum over trapezoids of the square of their height.
  options.kind = DormerKind::eyebrow;
  options.width = 6;
  const double f = front_height(options), r = (9 + f * f) / (2 * f), most = std::asin(3 / r);
  double segment = 0;
  for (int i = 0; i < 12; ++i) {
    const double u = most * (i / 6.0 - 1), v = most * ((i + 1) / 6.0 - 1);
    const double x = f - r * (1 - std::cos(u)), y = f - r * (1 - std::cos(v));
    segment += r * (std::sin(v) - std::sin(u)) * (x * x + x * y + y * y) / 3 / (2 * a);
  }
  CHECK(f == doctest::Approx(high));
  CHECK(volume_of(options) == doctest::Approx(segment));
}

TEST_CASE("a shallow hip on a wide dormer ends before it has a ridge") {
  DormerOptions options;
  options.kind = DormerKind::hip;
  options.width = 4;
  options.slope = 50;
  options.pitch = 15;
  const std::vector<DormerFace> faces = dormer(options);
  REQUIRE(faces.size() == 6);
  CHECK(faces[3].loop.size() == 4);
  CHECK(faces[4].loop.size() == 3);
  CHECK(volume_of(options) > 0);
}

TEST_CASE("an overhang stays out of the slope") {
  DormerOptions options;
  options.kind = DormerKind::gable;
  options.height = 0.5;
  options.overhang = 5;
  const double low = front_height(options) / 2;
  for (const DormerFace& face : dormer(options)) {
    if (face.part != DormerPart::fascia && face.part != DormerPart::soffit) continue;
    for (const Vec3 p : face.loop) CHECK(p.z > low - 1e-9);
  }
}

TEST_CASE("angles and sizes out of range make no dormer") {
  const auto with = [](auto change) {
    DormerOptions options;
    options.kind = DormerKind::shed;
    options.pitch = 20;
    change(options);
    return dormer(options).size();
  };
  CHECK(with([](DormerOptions&) {}) > 0);
  CHECK(with([](DormerOptions& o) { o.pitch = 45; }) == 0);
  CHECK(with([](DormerOptions& o) { o.pitch = 0; }) == 0);
  CHECK(with([](DormerOptions& o) { o.slope = 90; }) == 0);
  CHECK(with([](DormerOptions& o) { o.width = 0; }) == 0);
  CHECK(with([](DormerOptions& o) { o.height = std::nan(""); }) == 0);
}
