// The picture of stains, made once for a whole city.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "geometry/stain_atlas.hpp"

namespace mansard {

/// How dark each texel of a StainAtlas is, 0 clean to 255 black; rows from the top. The same for
/// any number of threads (0: all).
std::vector<uint8_t> make_stain_atlas(uint64_t seed, int threads);

/// The bytes of a PNG file of it. Grey and alpha both tell how dark a texel is: glTF's blending
/// reads the one, an alpha map of an MTL the other.
std::string encode_stain_atlas(const std::vector<uint8_t>& atlas);

}  // namespace mansard
