#include "formats/draco_module.hpp"

#include <draco/compression/expert_encode.h>
#include <draco/mesh/triangle_soup_mesh_builder.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace mansard {
namespace {

using Attribute = DracoTriangles::Attribute;
using Kind = DracoTriangles::Kind;

std::size_t width_of(Kind kind) { return kind == Kind::uv ? 2 : kind == Kind::tangent ? 4 : 3; }

draco::GeometryAttribute::Type type_of(Kind kind) {
  switch (kind) {
    case Kind::position:
      return draco::GeometryAttribute::POSITION;
    case Kind::normal:
      return draco::GeometryAttribute::NORMAL;
    case Kind::tangent:
      return draco::GeometryAttribute::GENERIC;
    default:
      return draco::GeometryAttribute::TEX_COORD;
  }
}

/// Rounds to a grid through 0, whatever the bounds of the values are.
void set_grid(draco::ExpertEncoder& encoder, int number, const Attribute& attribute) {
  const std::size_t width = width_of(attribute.kind);
  std::array<float, 4> low{}, high{};
  std::copy_n(attribute.values.begin(), width, low.begin());
  high = low;
  for (std::size_t i = 0; i < attribute.values.size(); ++i) {
    low[i % width] = std::min(low[i % width], attribute.values[i]);
    high[i % width] = std::max(high[i % width], attribute.values[i]);
  }
  double extent = 0;
  for (std::size_t i = 0; i < width; ++i)
    extent = std::max(extent, double(high[i]) - double(low[i]));
  constexpr int most_bits = 28;
  const double coarsest = attribute.kind == Kind::position ? 0x1p-13 : 0x1p-12;
  double step = std::min(coarsest, std::exp2(std::floor(std::log2(std::max(extent, 1e-6))) - 16));
  while (extent / step > std::exp2(most_bits) - 4) step *= 2;
  std::array<float, 4> origin{};
  for (std::size_t i = 0; i < width; ++i)
    origin[i] = static_cast<float>(std::floor(low[i] / step) * step);
  const int bits = std::max(1, static_cast<int>(std::ceil(std::log2(extent / step + 3))));
  const auto range = static_cast<float>((std::exp2(bits) - 1) * step);
  encoder.SetAttributeExplicitQuantization(number, bits, static_cast<int>(width), origin.data(),
                                           range);
}

void encode(DracoTriangles& triangles) {
  const auto faces = static_cast<uint32_t>(triangles.indices.size() / 3);
  draco::TriangleSoupMeshBuilder builder;
  builder.Start(static_cast<int>(faces));
  for (const Attribute& attribute : triangles.attributes) {
    const std::size_t width = width_of(attribute.kind);
    const int number = builder.AddAttribute(type_of(attribute.kind), static_cast<int8_t>(width),
                                            draco::DT_FLOAT32);
    const auto corner = [&](std::size_t i) {
      return attribute.values.data() + width * triangles.indices[i];
    };
    for (uint32_t f = 0; f < faces; ++f) {
      builder.SetAttributeValuesForFace(number, draco::FaceIndex(f), corner(3 * std::size_t(f)),
                                        corner(3 * std::size_t(f) + 1),
                                        corner(3 * std::size_t(f) + 2));
    }
  }
  const std::unique_ptr<draco::Mesh> mesh = builder.Finalize();
  if (!mesh) throw std::runtime_error("no mesh");
  draco::ExpertEncoder encoder(*mesh);
  encoder.SetSpeedOptions(5, 5);
  encoder.SetTrackEncodedProperties(true);
  for (int i = 0; i < static_cast<int>(triangles.attributes.size()); ++i) {
    const Attribute& attribute = triangles.attributes[static_cast<std::size_t>(i)];
    if (attribute.kind == Kind::normal) {
      encoder.SetAttributeQuantization(i, 10);
    } else {
      set_grid(encoder, i, attribute);
    }
  }
  draco::EncoderBuffer buffer;
  const draco::Status status = encoder.EncodeToBuffer(&buffer);
  if (!status.ok()) throw std::runtime_error(status.error_msg_string());
  triangles.bytes.assign(buffer.data(), buffer.size());
  triangles.vertices = static_cast<uint32_t>(encoder.num_encoded_points());
  triangles.triangles = static_cast<uint32_t>(encoder.num_encoded_faces());
}

}  // namespace
}  // namespace mansard

extern "C" bool mansard_encode_draco(mansard::DracoTriangles& triangles, std::string& problem) try {
  mansard::encode(triangles);
  return true;
} catch (const std::exception& e) {
  problem = e.what();
  return false;
}
