// What glTF tests draw, and .glb files read back.
#pragma once

#include <doctest/doctest.h>

#include <array>
#include <cstring>
#include <nlohmann/json.hpp>
#include <random>
#include <string>
#include <string_view>
#include <vector>

#include "formats/surface_writer.hpp"

namespace mansard::test {

using nlohmann::json;

extern const std::vector<std::string_view> symbols;
extern const std::vector<Look> looks;

void add_polygon(Surface& s, const std::vector<Vec3>& loop, uint32_t symbol, uint32_t look);

/// Polygons of 3 to 8 corners on random planes, every third of them with a notch.
Surface random_surface(std::mt19937& random, int polygons);

double area_of(const Surface& s);

/// A stool, so that no turn of it looks like another: a box with two legs, 18 quadrilaterals.
Mesh stool();

/// As the derivation draws it: loops of a mirrored one turned round.
void place(Surface& s, const Mesh& mesh, const Surface::Placed& at, uint32_t symbol);

struct Glb {
  json document;
  std::string binary;
};

/// The chunks of a .glb, whose header must be right.
Glb read_glb(const std::string& path);

/// Items of an accessor, all inside its view and the view inside the buffer.
template <class T, std::size_t N>
std::vector<std::array<T, N>> items(const Glb& glb, std::size_t number) {
  const json& accessor = glb.document["accessors"][number];
  const json& view = glb.document["bufferViews"][accessor["bufferView"].get<std::size_t>()];
  const std::size_t stride = view.value("byteStride", sizeof(T) * N);
  const std::size_t offset = accessor["byteOffset"], count = accessor["count"];
  REQUIRE(offset % sizeof(T) == 0);
  REQUIRE(offset + stride * count <= view["byteLength"].get<std::size_t>());
  const std::size_t start = view["byteOffset"].get<std::size_t>() + offset;
  REQUIRE(start + stride * count <= glb.binary.size());
  std::vector<std::array<T, N>> all(count);
  for (std::size_t i = 0; i < count; ++i)
    std::memcpy(all[i].data(), glb.binary.data() + start + i * stride, sizeof(T) * N);
  return all;
}

std::vector<uint32_t> indices_of(const Glb& glb, std::size_t accessor);

/// Area and sum over triangles of area times centre and normal, which tell turned ones apart.
struct Moments {
  std::size_t triangles = 0;
  double area = 0;
  double facing = 0;  ///< of the area, as much as the normals look where the triangles do
  Vec3 centre, flux;
  Vec2 uv;
};

/// Of a model as Assimp reads it.
Moments moments_of(const std::string& path);
std::vector<Vec3> points_of(const std::string& path);

}  // namespace mansard::test
