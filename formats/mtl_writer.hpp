// The material library beside an OBJ, with its textures.
#pragma once

#include <cstddef>
#include <span>
#include <string>

#include "formats/surface_writer.hpp"

namespace mansard {

/// Writes `path` and copies the textures into its folder, named after it so that nobody's picture
/// is overwritten: quarter.mtl has quarter_brick.jpg. Returns the bytes of the MTL. Throws Failure.
std::size_t write_mtl(const std::string& path, std::span<const Look> looks);

}  // namespace mansard
