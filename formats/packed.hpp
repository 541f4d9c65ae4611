// Footprints and what they are made of as records of bytes.
#pragma once

#include <string>
#include <string_view>

#include "formats/footprint_sources.hpp"
#include "interpreter/footprint.hpp"

namespace mansard {

/// Replaces `bytes`.
void pack(const Footprint& footprint, std::string& bytes);
void pack(const RawFeature& feature, std::string& bytes);

/// From bytes that pack() made. Keeps the memory of what was there; a footprint's surroundings and
/// place stay.
void unpack(std::string_view bytes, Footprint& footprint);
void unpack(std::string_view bytes, RawFeature& feature);

}  // namespace mansard
