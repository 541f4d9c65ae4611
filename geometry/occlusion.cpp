#include "geometry/occlusion.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/clip.hpp"
#include "geometry/clip_boolean.hpp"
#include "geometry/offset.hpp"

namespace mansard {
namespace {

/// Below this cosine between the plane's normal and the axis they count as perpendicular: over 100
/// m that is off by 10 micrometres.
constexpr double upright = 1e-7;

/// Numbers that are 0 or 1 but for rounding, so that level things stay level.
double settled(double v) {
  if (std::abs(v) < 1e-12) return 0;
  return std::abs(std::abs(v) - 1) < 1e-12 ? std::copysign(1.0, v) : v;
}

/// Where the line from + s * along runs inside the polygon: pairs of s, ascending.
std::vector<double> inside_of(const Polygon& polygon, Vec2 from, Vec2 along) {
  std::vector<double> at;
  for_each_edge(polygon, [&](uint32_t, Vec2 p, Vec2 q) {
    const double side_p = cross(along, p - from), side_q = cross(along, q - from);
    if ((side_p > 0) == (side_q > 0)) return;
    at.push_back(dot(mix(p, q, side_p / (side_p - side_q)) - from, along));
  });
  std::sort(at.begin(), at.end());
  if (at.size() % 2 != 0) at.pop_back();
  return at;
}

/// The plane runs along the axis: strips as high as the prism, where the line that it draws on the
/// base is inside.
std::vector<Polygon> strips(const Prism& prism, const Scope& frame, Vec3 start) {
  const Vec2 up{settled(dot(prism.axis, frame.x)), settled(dot(prism.axis, frame.y))};
  const Vec2 right{up.y, -up.x};
  const Vec3 along = frame.x * right.x + frame.y * right.y;
  const Vec2 from{dot(start, prism.a), dot(start, prism.b)};
  const std::vector<double> at =
      inside_of(prism.base, from, {dot(along, prism.a), dot(along, prism.b)});
  const double low = -dot(start, prism.axis), high = low + prism.height;
  std::vector<Polygon> pieces;
  for (std::size_t i = 0; i + 1 < at.size(); i += 2) {
    Polygon piece;
    for (const Vec2 corner :
         {Vec2{at[i], low}, Vec2{at[i + 1], low}, Vec2{at[i + 1], high}, Vec2{at[i], high}}) {
      piece.add_point(right * corner.x + up * corner.y);
    }
    piece.close_ring();
    pieces.push_back(std::move(piece));
  }
  return pieces;
}

/// The faces of a mesh that look along `normal`, as polygons in the frame.
std::vector<Polygon> faces_along(const Mesh& mesh, const Scope& frame, bool cut_only) {
  std::vector<Polygon> pieces;
  std::vector<Vec3> loop;
  for (const Mesh::Face& face : mesh.faces) {
    if (cut_only && !face.tag.has(EdgeTag::cut)) continue;
    loop.clear();
    for (const uint32_t corner : mesh.loop(face)) loop.push_back(mesh.points[corner]);
    if (dot(newell(loop), frame.z) <= 0) continue;
    Polygon piece;
    for (const Vec3 p : loop) {
      const Vec3 q = frame.to_local(p);
      piece.add_point({q.x, q.y});
    }
    piece.close_ring();
    orient(piece);
    pieces.push_back(std::move(piece));
  }
  return pieces;
}

Mesh untagged(const Mesh& mesh) {
  Mesh bare;
  bare.points = mesh.points;
  bare.corners = mesh.corners;
  bare.faces = mesh.faces;
  for (Mesh::Face& face : bare.faces) face.tag = {};
  return bare;
}

}  // namespace

std::vector<Polygon> section(const Prism& prism, const Scope& frame, double above) {
  const Vec3 start = frame.origin + frame.z * above - prism.origin;
  const double facing = dot(frame.z, prism.axis);
  if (std::abs(facing) < upright) return strips(prism, frame, start);
  // Drawn along the axis onto the plane: q gives base coordinates start + M q; M's inverse.
  const Vec2 x{dot(frame.x, prism.a), dot(frame.x, prism.b)};
  const Vec2 y{dot(frame.y, prism.a), dot(frame.y, prism.b)};
  const Vec2 from{dot(start, prism.a), dot(start, prism.b)};
  const double turned = 1 / cross(x, y);
  Polygon drawn = prism.base;
  for (Vec2& p : drawn.points) {
    const Vec2 d = p - from;
    p = {cross(d, y) * turned, cross(x, d) * turned};
  }
  orient(drawn);
  // Between the two ends of the prism: its axis coordinate is at + dot(rise, q).
  const Vec2 rise{dot(frame.x, prism.axis), dot(frame.y, prism.axis)};
  const double at = dot(start, prism.axis), steep = length(rise);
  if (steep < upright) {
    return at > 0 && at < prism.height ? std::vector<Polygon>{drawn} : std::vector<Polygon>{};
  }
  const Vec2 way = rise * (1 / steep);
  std::vector<Polygon> pieces;
  for (const Polygon& below : clip(drawn, way, (prism.height - at) / steep)) {
    for (Polygon& piece : clip(below, way * -1, at / steep)) pieces.push_back(std::move(piece));
  }
  return pieces;
}

std::vector<Polygon> section(const Mesh& mesh, const Scope& frame, double above) {
  const Mesh below = clip(untagged(mesh), frame.z, dot(frame.z, frame.origin) + above);
  return faces_along(below, frame, true);
}

std::vector<Polygon> shadow(const Mesh& mesh, const Scope& frame, double low, double high,
                            double beside) {
  const double at = dot(frame.z, frame.origin);
  const Mesh below = clip(mesh, frame.z, at + high);
  const Mesh slab = clip(below, -frame.z, -(at + low));
  std::vector<Polygon> seen = unite(faces_along(slab, frame, false), Precision::grid);
  if (beside <= 0) return seen;
  std::vector<Polygon> wider;
  for (const Polygon& piece : seen) {
    for (Polygon& grown : outset(piece, beside)) wider.push_back(std::move(grown));
  }
  return wider;
}

Mesh to_mesh(const Prism& prism) {
  Mesh mesh;
  const auto n = static_cast<uint32_t>(prism.base.points.size());
  for (const double along : {0.0, prism.height}) {
    for (const Vec2 p : prism.base.points) {
      mesh.points.push_back(prism.origin + prism.a * p.x + prism.b * p.y + prism.axis * along);
    }
  }
  const bool turned = dot(cross(prism.a, prism.b), prism.axis) < 0;
  const auto add = [&](std::vector<uint32_t> loop) {
    if (turned) std::reverse(loop.begin(), loop.end());
    mesh.add_face(loop);
  };
  for (std::size_t r = 0; r < prism.base.rings(); ++r) {
    const uint32_t begin = prism.base.ring_begin(r), end = prism.base.ring_ends[r];
    for (uint32_t i = begin; i < end; ++i) {
      const uint32_t next = i + 1 == end ? begin : i + 1;
      add({i, next, n + next, n + i});
    }
  }
  const std::vector<uint32_t> triangles = triangulate(prism.base);
  for (std::size_t i = 0; i + 2 < triangles.size(); i += 3) {
    add({triangles[i + 2], triangles[i + 1], triangles[i]});
    add({n + triangles[i], n + triangles[i + 1], n + triangles[i + 2]});
  }
  return mesh;
}

double thickness(const Polygon& polygon) {
  const double around = perimeter(polygon);
  return around > 0 ? 2 * std::abs(area(polygon)) / around : 0;
}

namespace {

constexpr double level = 1e-9;  // metres

double thickness(const Box2& box) {
  const Vec2 size = box.size();
  return size.x > 0 && size.y > 0 ? size.x * size.y / (size.x + size.y) : 0;
}

Box2 common(const Box2& a, const Box2& b) {
  return {{std::max(a.low.x, b.low.x), std::max(a.low.y, b.low.y)},
          {std::min(a.high.x, b.high.x), std::min(a.high.y, b.high.y)}};
}

/// What is left of each box beside `hole`, up to four of each.
std::vector<Box2> without(const std::vector<Box2>& boxes, const Box2& hole, double tolerance) {
  std::vector<Box2> left;
  for (const Box2& box : boxes) {
    const Box2 cut = common(box, hole);
    if (thickness(cut) == 0) {
      left.push_back(box);
      continue;
    }
    for (const Box2& piece :
         {Box2{box.low, {cut.low.x, box.high.y}}, Box2{{cut.high.x, box.low.y}, box.high},
          Box2{{cut.low.x, box.low.y}, {cut.high.x, cut.low.y}},
          Box2{{cut.low.x, cut.high.y}, {cut.high.x, box.high.y}}}) {
      if (thickness(piece) > tolerance) left.push_back(piece);
    }
  }
  return left;
}

std::vector<Polygon> thick(std::vector<Polygon> pieces, double tolerance) {
  std::erase_if(pieces, [&](const Polygon& p) { return thickness(p) <= tolerance; });
  return pieces;
}

/// Windows and boxes: nearly all that is ever asked.
Cover covered_boxes(const Box2& face, std::span<const Polygon> by, double tolerance) {
  std::vector<Box2> left{face};
  bool any = false;
  for (const Polygon& polygon : by) {
    const Box2 box = bounds(polygon.points);
    if (thickness(common(face, box)) <= tolerance) continue;
    any = true;
    left = without(left, box, tolerance);
    if (left.empty()) return Cover::full;
  }
  return any ? Cover::part : Cover::nothing;
}

}  // namespace

Cover covered(const Polygon& face, std::span<const Polygon> by, double tolerance) {
  tolerance = std::min(tolerance, thickness(face) / 10);
  const Box2 box = bounds(face.points);
  std::vector<Polygon> near;
  bool boxes = is_axis_rectangle(face, level);
  for (const Polygon& piece : by) {
    if (thickness(common(box, bounds(piece.points))) == 0) continue;
    near.push_back(piece);
    boxes = boxes && is_axis_rectangle(piece, level);
  }
  if (near.empty()) return Cover::nothing;
  if (boxes) return covered_boxes(box, near, tolerance);
  std::vector<Polygon> left{face};
  bool any = false;
  for (const Polygon& piece : near) {
    const std::span<const Polygon> one(&piece, 1), whole(&face, 1);
    if (thick(intersect(whole, one, Precision::floating), tolerance).empty()) continue;
    any = true;
    left = thick(subtract(left, one, Precision::floating), tolerance);
    if (left.empty()) return Cover::full;
  }
  return any ? Cover::part : Cover::nothing;
}

}  // namespace mansard
