#include "interpreter/sight.hpp"

#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "geometry/clip.hpp"
#include "interpreter/component.hpp"
#include "interpreter/machine.hpp"
#include "interpreter/messages.hpp"
#include "interpreter/question.hpp"
#include "interpreter/solid_set.hpp"
#include "interpreter/street_edges.hpp"
#include "interpreter/surroundings.hpp"

namespace mansard {
namespace {

constexpr double never = std::numeric_limits<double>::infinity();

/// The thing that is nearest, and the places on the shape and on it.
struct Thing {
  Nearest3 places{{}, {}, never};
  std::string name;
  bool found() const { return places.distance < never; }
};

/// A question of one shape about the frozen world.
class Sight {
 public:
  Sight(const FunctionCall& call, std::string_view set)
      : machine_(call.machine), shape_(*call.shape), set_(machine_, shape_, set) {}

  Thing nearest_solid(const std::vector<Triangle>& from);
  Thing nearest_street(const std::vector<Triangle>& from) const;
  /// What hides `to`, if anything does.
  std::optional<std::string> hides(Vec3 from, Vec3 to);
  std::vector<Triangle> surface() const;
  /// A little before a face, so that its own mass lies behind.
  Vec3 middle() const;
  Vec3 outwards() const { return shape_.ground ? shape_.scope.y : shape_.scope.z; }

 private:
  bool is_own(uint32_t solid) const { return machine_.world.is_above(solid, shape_.solid); }
  /// In the user's words; nothing unless a tree is asked for.
  std::string name_of(uint32_t solid) const;
  std::string neighbour(uint32_t place) const;
  void take(SolidMesh& solid, const std::vector<Triangle>& from, const std::string& name,
            Thing& nearest) const;

  Machine& machine_;
  const Shape& shape_;
  SolidSet set_;
};

std::string Sight::neighbour(uint32_t place) const {
  if (!machine_.keeps_tree) return {};
  return "the neighbour '" + machine_.footprint->around->id(place) + "'";
}

std::string Sight::name_of(uint32_t solid) const {
  if (!machine_.keeps_tree) return {};
  const Shape& shape = machine_.world[solid].shape;
  return std::string(machine_.program.symbols[shape.symbol]) + " (node " +
         std::to_string(shape.node) + ")";
}

Vec3 Sight::middle() const {
  const Vec3 at = shape_.scope.at(shape_.scope.size * 0.5);
  return is_flat(shape_) ? at + outwards() * contact : at;
}

void add_triangles(const Machine& machine, const Shape& face, std::vector<Triangle>& to) {
  const Polygon plan = plan_of(machine, face);
  const auto at = [&](uint32_t i) {
    return face.scope.at({plan.points[i].x, plan.points[i].y, 0});
  };
  const std::vector<uint32_t> corners = triangulate(plan);
  for (std::size_t i = 0; i + 2 < corners.size(); i += 3)
    to.push_back({at(corners[i]), at(corners[i + 1]), at(corners[i + 2])});
}

/// A line is a triangle with two corners in one place; what has no geometry is its scope's origin.
std::vector<Triangle> Sight::surface() const {
  std::vector<Triangle> triangles;
  const std::size_t first = machine_.scratch_shapes.size();
  push_faces(machine_, shape_);
  for (std::size_t i = first; i < machine_.scratch_shapes.size(); ++i)
    add_triangles(machine_, machine_.scratch_shapes[i], triangles);
  machine_.scratch_shapes.resize(first);
  if (triangles.empty()) {
    const Vec3 from = shape_.scope.origin, to = shape_.scope.at({shape_.scope.size.x, 0, 0});
    triangles.push_back({from, to, to});
  }
  return triangles;
}

void Sight::take(SolidMesh& solid, const std::vector<Triangle>& from, const std::string& name,
                 Thing& nearest) const {
  const Vec3 corner = from[0][0];
  if (nearest.places.distance > 0 && solid.contains(corner)) {
    nearest = {{corner, corner, 0}, name};
    return;
  }
  for (const Triangle& triangle : from) {
    const auto places = solid.nearest(triangle, nearest.places.distance);
    if (places && is_before(*places, nearest.places)) nearest = {*places, name};
  }
}

Thing Sight::nearest_solid(const std::vector<Triangle>& from) {
  std::vector<Vec3> points;
  for (const Triangle& t : from) points.insert(points.end(), t.begin(), t.end());
  const Box3 box = bounds(points);
  Thing nearest;
  machine_.world.index().nearest(box, never, [&](uint32_t solid) {
    if (set_.has(solid) && !is_own(solid))
      take(machine_.world.solid_of(machine_, solid), from, name_of(solid), nearest);
    return nearest.places.distance;
  });
  const Footprint& footprint = *machine_.footprint;
  if (!set_.has_neighbours() || !footprint.around) return nearest;
  footprint.around->index().nearest(box, nearest.places.distance, [&](uint32_t place) {
    if (place != footprint.place)
      take(machine_.world.block_of(*footprint.around, place), from, neighbour(place), nearest);
    return nearest.places.distance;
  });
  return nearest;
}

/// Calls f(from, to) with a street's place before each street edge, where nobody gave streets.
template <class F>
void for_each_thought_street(const Polygon& polygon, F f) {
  for_each_edge(polygon, [&](uint32_t i, Vec2 a, Vec2 b) {
    if (!polygon.tags[i].has(EdgeTag::street) || a == b) return;
    const Vec2 before = left_of(normalized(b - a)) * -street_clearance;
    f(a + before, b + before);
  });
}

Thing Sight::nearest_street(const std::vector<Triangle>& from) const {
  const Footprint& footprint = *machine_.footprint;
  Thing nearest;
  const auto plan = [](Vec3 p) { return Vec2{p.x, -p.z}; };
  const auto take = [&](Vec3 on_shape, Vec2 street, double distance) {
    const Nearest3 places{on_shape, {street.x, 0, -street.y}, distance};
    if (is_before(places, nearest.places)) nearest = {places, std::string(street_word)};
  };
  for (const Triangle& t : from) {
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec2 a = plan(t[i]), b = plan(t[(i + 1) % 3]);
      if (footprint.around && !footprint.around->streets().empty()) {
        const double within = std::nextafter(nearest.places.distance, never);
        if (const auto near = footprint.around->streets().nearest(a, b, within))
          take(t[i], near->point, near->distance);
        continue;
      }
      for_each_thought_street(footprint.polygon, [&](Vec2 p, Vec2 q) {
        const Nearest2 pair = nearest_pair(p, q, a, b);
        take(t[i], pair.first, pair.distance);
      });
    }
  }
  return nearest;
}

/// How much of the line a solid takes, in metres; without what it has of its beginning, of one that
/// the shape came from.
double taken(SolidMesh& solid, Vec3 from, Vec3 to, bool own) {
  double share = 0;
  for (const auto& [low, high] : solid.inside(from, to)) {
    if (!own || low > 0) share += high - low;
  }
  return share * length(to - from);
}

std::optional<std::string> Sight::hides(Vec3 from, Vec3 to) {
  std::vector<uint32_t> found;
  machine_.world.along(from, to, found);
  for (const uint32_t solid : found) {
    if (taken(machine_.world.solid_of(machine_, solid), from, to, is_own(solid)) > contact)
      return name_of(solid);
  }
  const Footprint& footprint = *machine_.footprint;
  if (!footprint.around) return std::nullopt;
  footprint.around->index().along(from, to, found);
  for (const uint32_t place : found) {
    if (place == footprint.place) continue;
    SolidMesh& block = machine_.world.block_of(*footprint.around, place);
    if (taken(block, from, to, false) > contact) return neighbour(place);
  }
  return std::nullopt;
}

void need_shape(const FunctionCall& call) {
  if (call.shape) return;
  call.machine.fail(call.machine.program.spans[call.node], "there is no shape to ask about here");
}

}  // namespace

Value ask_nearest(const FunctionCall& call, std::string_view set) {
  need_shape(call);
  Sight sight(call, set);
  const std::vector<Triangle> from = sight.surface();
  const Thing thing = set == street_word ? sight.nearest_street(from) : sight.nearest_solid(from);
  const double distance = thing.places.distance;
  call.machine.note_answer(call.node, *call.shape, number_text(distance), thing.name);
  return Value::of(distance);
}

Value ask_visible(const FunctionCall& call, std::string_view set) {
  need_shape(call);
  Sight sight(call, set);
  const Vec3 from = sight.middle();
  const std::vector<Triangle> place{{from, from, from}};
  const Thing thing = set == street_word ? sight.nearest_street(place) : sight.nearest_solid(place);
  std::optional<std::string> hidden_by;
  if (!thing.found()) {
    hidden_by.emplace();
  } else if (is_flat(*call.shape) &&
             dot(thing.places.second - from, sight.outwards()) < -2 * contact) {
    hidden_by = "its own wall";
  } else {
    hidden_by = sight.hides(from, thing.places.second);
  }
  call.machine.note_answer(call.node, *call.shape, hidden_by ? "false" : "true",
                           hidden_by.value_or(thing.name));
  return Value::of(!hidden_by);
}

}  // namespace mansard
