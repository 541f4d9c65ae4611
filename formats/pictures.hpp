// Pictures as their pixels: whether a file is one, and the pictures that glTF wants made of others.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace mansard {

/// The longest side, in pixels, and the most bytes of a file that textures are taken from.
inline constexpr int longest_picture_side = 8192;
inline constexpr uint64_t most_picture_bytes = 64 << 20;

/// Why a file can not texture anything, in a few words: "it is no PNG, JPEG, BMP or TGA picture",
/// "it is cut off". Empty when it can; looks only at its head and its end.
std::string picture_problem(const std::string& path);

/// glTF's metallic-roughness picture as a PNG: roughness in green, metal in blue; a path that is
/// empty stands for 1 everywhere. It is as large as the larger of the two. Throws Failure.
std::string packed_metal_rough(const std::string& roughness, const std::string& metallic);

}  // namespace mansard
