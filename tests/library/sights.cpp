#include "tests/library/sights.hpp"

#include <cmath>
#include <memory>
#include <numbers>
#include <optional>
#include <random>

#include "render/ray_scene.hpp"
#include "render/trace.hpp"

namespace mansard::test {
namespace {

constexpr double aside = 0.003;   // metres
constexpr double eye_low = 0.05;  // metres above the ground

class Spectator {
 public:
  Spectator(const Surface& surface, uint32_t seed)
      : surface_(surface), box_(bounds(surface.points)), random_(seed) {
    scene_.add(surface);
    scene_.paints.resize(scene_.paint.size() + 1);
    world_ = std::make_unique<RayScene>(scene_);
    tracer_ = std::make_unique<Tracer>(*world_);
  }

  /// One look; the back it met, if any.
  std::optional<Sight> look() {
    const Vec3 target = place();
    const double reach = 2 * length(box_.size());
    const double turn = between(0, 2 * std::numbers::pi), up = between(-0.8, 1.5);
    const Vec3 way{std::cos(up) * std::cos(turn), std::sin(up), std::cos(up) * std::sin(turn)};
    const double room = target.y - box_.low.y - eye_low;
    if (way.y < 0 && room <= 0) return std::nullopt;
    const Vec3 eye = target + way * (way.y < 0 ? std::min(reach, room / -way.y) : reach);
    if (over_building(eye)) return std::nullopt;
    const auto first = back(eye, target);
    if (!first) return std::nullopt;
    const Vec3 side = normalized(cross(way, std::abs(way.y) < 0.9 ? Vec3{0, 1, 0} : Vec3{1, 0, 0}));
    const Vec3 above = cross(side, way);
    for (const Vec3 step : {side, -side, above, -above}) {
      if (!back(eye + step * aside, target + step * aside)) return std::nullopt;
    }
    return first;
  }

 private:
  double between(double low, double high) {
    return std::uniform_real_distribution(low, high)(random_);
  }
  Vec3 place() {
    if (between(0, 1) < 0.5) {
      return {between(box_.low.x, box_.high.x), between(box_.low.y, box_.high.y),
              between(box_.low.z, box_.high.z)};
    }
    const auto polygon =
        static_cast<std::size_t>(between(0, static_cast<double>(surface_.polygons()) - 0.001));
    const auto loop = surface_.loop(polygon);
    const double a = between(0, 1), b = between(0, 1 - a);
    return loop[0] * a + loop[1] * b + loop[2] * (1 - a - b);
  }
  bool over_building(Vec3 p) const {
    return p.x > box_.low.x - 0.1 && p.x < box_.high.x + 0.1 && p.z > box_.low.z - 0.1 &&
           p.z < box_.high.z + 0.1 && p.y < box_.high.y + 0.1;
  }
  std::optional<Sight> back(Vec3 eye, Vec3 target) const {
    const Float3 from = world_->to_world(eye), direction = world_->to_world(target) - from;
    const Hit hit = tracer_->see(from, direction);
    if (hit.triangle >= RayScene::ground) return std::nullopt;
    const std::size_t polygon = scene_.face[world_->source[hit.triangle]];
    const Vec3 way = target - eye;
    if (dot(surface_.normals[polygon], way) <= 1e-6 * length(way)) return std::nullopt;
    return Sight{polygon, eye, eye + way * hit.t};
  }

  const Surface& surface_;
  Box3 box_;
  std::mt19937 random_;
  Scene scene_;
  std::unique_ptr<RayScene> world_;
  std::unique_ptr<Tracer> tracer_;
};

}  // namespace

std::vector<Sight> backs_seen(const Surface& surface, int looks, uint32_t seed) {
  std::vector<Sight> found;
  if (surface.polygons() == 0) return found;
  Spectator spectator(surface, seed);
  for (int i = 0; i < looks; ++i) {
    if (const auto sight = spectator.look()) found.push_back(*sight);
  }
  return found;
}

}  // namespace mansard::test
