#include "geometry/clip.hpp"
#include "render/picture.hpp"

namespace mansard {

void Scene::add(const Surface& surface, uint32_t first_paint) {
  uint32_t next_face = face.empty() ? 0 : face.back() + 1;
  std::size_t polygon = 0;
  for (const Surface::Run& run : surface.runs) {
    for (; polygon < run.end && polygon < surface.polygons(); ++polygon) {
      const std::span<const Vec3> loop = surface.loop(polygon);
      const uint32_t begin = surface.begin(polygon);
      const std::vector<uint32_t> corners = triangulate(loop);
      for (const uint32_t corner : corners) {
        const Vec3 p = loop[corner];
        const Vec2 uv = begin + corner < surface.uvs.size() ? surface.uvs[begin + corner] : Vec2{};
        points.insert(points.end(),
                      {static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)});
        uvs.insert(uvs.end(), {static_cast<float>(uv.x), static_cast<float>(uv.y)});
      }
      paint.insert(paint.end(), corners.size() / 3, first_paint + run.material);
      face.insert(face.end(), corners.size() / 3, next_face++);
    }
  }
}

}  // namespace mansard
