#include "render/trace.hpp"

#include <embree3/rtcore.h>

#include <limits>
#include <numeric>

namespace mansard {
namespace {

constexpr float nearest = 1e-4F;
constexpr float infinite = std::numeric_limits<float>::infinity();

RTCRay ray(Float3 from, Float3 direction, float t_low, float t_high) {
  RTCRay made{};
  made.org_x = from.x;
  made.org_y = from.y;
  made.org_z = from.z;
  made.dir_x = direction.x;
  made.dir_y = direction.y;
  made.dir_z = direction.z;
  made.tnear = t_low;
  made.tfar = t_high;
  made.mask = 0xffffffff;
  return made;
}

Hit ground_hit(Float3 from, Float3 direction) {
  if (direction.y >= 0 || from.y <= 0) return {};
  return {RayScene::ground, -from.y / direction.y, {0, 1, 0}, 0, 0};
}

/// Gathers what lies within a short piece of a ray; hits are refused so that the ray goes on.
struct Gathering {
  RTCIntersectContext context;  // first: Embree hands back its address
  uint32_t triangle;
  float u, v;
  float inside;  ///< how far from the triangle's border it was hit, 0..1/3
  Float3 normal;
  bool faces_eye;
};

/// In one plane the last drawn is seen. A wall that ends at a roof is not: the ray met its border.
bool is_seen_before(const Gathering& now, const Gathering& before) {
  if (before.triangle == RayScene::sky) return true;
  if (now.faces_eye != before.faces_eye) return now.faces_eye;
  const bool in_one_plane = std::abs(dot(now.normal, before.normal)) > 0.9999F;
  return in_one_plane ? now.triangle > before.triangle : now.inside > before.inside;
}

void gather(const RTCFilterFunctionNArguments* call) {
  auto& seen = *reinterpret_cast<Gathering*>(call->context);
  call->valid[0] = 0;
  Gathering now{};
  now.triangle = RTCHitN_primID(call->hit, 1, 0);
  now.u = RTCHitN_u(call->hit, 1, 0);
  now.v = RTCHitN_v(call->hit, 1, 0);
  now.inside = std::min({now.u, now.v, 1 - now.u - now.v});
  const Float3 direction{RTCRayN_dir_x(call->ray, 1, 0), RTCRayN_dir_y(call->ray, 1, 0),
                         RTCRayN_dir_z(call->ray, 1, 0)};
  now.normal = normalized(Float3{RTCHitN_Ng_x(call->hit, 1, 0), RTCHitN_Ng_y(call->hit, 1, 0),
                                 RTCHitN_Ng_z(call->hit, 1, 0)});
  now.faces_eye = dot(direction, now.normal) < 0;
  if (!is_seen_before(now, seen)) return;
  now.context = seen.context;
  seen = now;
}

}  // namespace

struct Tracer::Embree {
  RTCDevice device = nullptr;
  RTCScene scene = nullptr;
};

Tracer::Tracer(const RayScene& world) : world_(world), embree_(std::make_unique<Embree>()) {
  if (world.stains) stains_ = std::make_unique<Tracer>(*world.stains);
  if (world.triangles() == 0) return;
  // One thread builds, so that the tree, and with it what wins a tie, is always the same.
  embree_->device = rtcNewDevice("threads=1");
  embree_->scene = rtcNewScene(embree_->device);
  rtcSetSceneFlags(
      embree_->scene,
      static_cast<RTCSceneFlags>(RTC_SCENE_FLAG_ROBUST | RTC_SCENE_FLAG_CONTEXT_FILTER_FUNCTION));
  RTCGeometry geometry = rtcNewGeometry(embree_->device, RTC_GEOMETRY_TYPE_TRIANGLE);
  auto* points = static_cast<Float3*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0,
                                                              RTC_FORMAT_FLOAT3, sizeof(Float3),
                                                              world.corners.size()));
  auto* numbers = static_cast<uint32_t*>(
      rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                              3 * sizeof(uint32_t), world.triangles()));
  if (points != nullptr && numbers != nullptr) {
    std::copy(world.corners.begin(), world.corners.end(), points);
    std::iota(numbers, numbers + world.corners.size(), 0U);
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(embree_->scene, geometry);
  }
  rtcReleaseGeometry(geometry);
  rtcCommitScene(embree_->scene);
}

Tracer::~Tracer() {
  if (embree_->scene != nullptr) rtcReleaseScene(embree_->scene);
  if (embree_->device != nullptr) rtcReleaseDevice(embree_->device);
}

Hit Tracer::hit(Float3 from, Float3 direction) const {
  const Hit ground = ground_hit(from, direction);
  if (embree_->scene == nullptr) return ground;
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  RTCRayHit found{};
  found.ray = ray(from, direction, nearest, ground.is_sky() ? infinite : ground.t);
  found.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  rtcIntersect1(embree_->scene, &context, &found);
  if (found.hit.geomID == RTC_INVALID_GEOMETRY_ID) return ground;
  const Float3 normal = normalized(Float3{found.hit.Ng_x, found.hit.Ng_y, found.hit.Ng_z});
  return {found.hit.primID, found.ray.tfar, dot(normal, direction) > 0 ? -normal : normal,
          found.hit.u, found.hit.v};
}

Hit Tracer::see(Float3 from, Float3 direction) const {
  Hit first = hit(from, direction);
  if (first.triangle >= RayScene::ground) return first;
  Gathering seen{};
  rtcInitIntersectContext(&seen.context);
  seen.context.filter = gather;
  seen.triangle = RayScene::sky;
  // A tenth of a millimetre, or what single precision leaves of it.
  const float slack = 1e-4F + 4e-6F * first.t;
  RTCRayHit found{};
  found.ray = ray(from, direction, std::max(nearest, first.t - slack), first.t + slack);
  found.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  rtcIntersect1(embree_->scene, &seen.context, &found);
  if (seen.triangle == RayScene::sky || seen.triangle == first.triangle) return first;
  const Float3* at = &world_.corners[3 * std::size_t{seen.triangle}];
  const Float3 normal = normalized(cross(at[1] - at[0], at[2] - at[0]));
  return {seen.triangle, first.t, dot(normal, direction) > 0 ? -normal : normal, seen.u, seen.v};
}

Hit Tracer::stain_before(Float3 from, Float3 direction, const Hit& seen) const {
  constexpr float gap = 0.02F;  // metres
  if (!stains_ || seen.triangle >= RayScene::ground) return {};
  const float slant = std::max(1e-3F, -dot(seen.normal, direction));  // metres of gap a length
  Hit first = stains_->hit(from, direction);
  const bool is_there =
      first.triangle < RayScene::ground && first.t < seen.t && (seen.t - first.t) * slant < gap;
  return is_there && dot(first.normal, seen.normal) > 0.99F ? first : Hit{};
}

bool Tracer::is_blocked(Float3 from, Float3 direction) const {
  if (embree_->scene == nullptr) return false;
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  RTCRay shadow = ray(from, direction, nearest, infinite);
  rtcOccluded1(embree_->scene, &context, &shadow);
  return shadow.tfar < 0;
}

}  // namespace mansard
