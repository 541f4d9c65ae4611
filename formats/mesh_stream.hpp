// A mesh as the bytes that the reading process hands over.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "geometry/mesh.hpp"

namespace mansard {

/// For the same program on the same machine.
std::string to_bytes(const Mesh& mesh);
std::string to_bytes(std::string_view problem);

/// Nothing where the bytes are cut off, where a number in them leads nowhere, and where they are a
/// problem: then `problem` has it.
std::optional<Mesh> mesh_from_bytes(std::string_view bytes, std::string& problem);

}  // namespace mansard
