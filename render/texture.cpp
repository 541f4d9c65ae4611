#include "render/texture.hpp"

#include <array>

#include "render/png.hpp"

namespace mansard {
namespace {

int wrap(int i, int n) { return ((i % n) + n) % n; }

std::array<float, 256> linear_from_srgb() {
  std::array<float, 256> table{};
  for (int i = 0; i < 256; ++i) {
    const double c = i / 255.0;
    table[static_cast<std::size_t>(i)] =
        static_cast<float>(c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4));
  }
  return table;
}

std::array<float, 256> parts_of_whole() {
  std::array<float, 256> table{};
  for (std::size_t i = 0; i < table.size(); ++i) table[i] = static_cast<float>(i) / 255;
  return table;
}

}  // namespace

Texture::Texture(int width, int height, std::vector<Float3> colors) {
  levels_.push_back({width, height, std::move(colors)});
  while (levels_.back().width > 1 || levels_.back().height > 1) {
    const Level& big = levels_.back();
    Level half{std::max(1, big.width / 2), std::max(1, big.height / 2), {}};
    for (int y = 0; y < half.height; ++y) {
      for (int x = 0; x < half.width; ++x) {
        Float3 sum;
        for (int k = 0; k < 4; ++k) {
          const int from_x = std::min(big.width - 1, 2 * x + k % 2);
          const int from_y = std::min(big.height - 1, 2 * y + k / 2);
          sum = sum + big.colors[static_cast<std::size_t>(from_y) * big.width + from_x];
        }
        half.colors.push_back(sum * 0.25F);
      }
    }
    levels_.push_back(std::move(half));
  }
}

Float3 Texture::Level::at(Vec2 uv) const {
  const double x = (uv.x - std::floor(uv.x)) * width - 0.5;
  const double y = (1 - (uv.y - std::floor(uv.y))) * height - 0.5;
  const double left = std::floor(x), top = std::floor(y);
  const auto color = [&](int dx, int dy) {
    const int px = wrap(static_cast<int>(left) + dx, width);
    const int py = wrap(static_cast<int>(top) + dy, height);
    return colors[static_cast<std::size_t>(py) * width + px];
  };
  const auto tx = static_cast<float>(x - left), ty = static_cast<float>(y - top);
  return mix(mix(color(0, 0), color(1, 0), tx), mix(color(0, 1), color(1, 1), tx), ty);
}

Float3 Texture::at(Vec2 uv, float pixel) const {
  if (!std::isfinite(uv.x) || !std::isfinite(uv.y) || !std::isfinite(pixel)) return mean();
  const float texels = pixel * static_cast<float>(std::max(levels_[0].width, levels_[0].height));
  const auto last = static_cast<float>(levels_.size() - 1);
  const float level = std::clamp(std::log2(std::max(texels, 1e-6F)), 0.0F, last);
  const auto fine = static_cast<std::size_t>(level);
  const std::size_t coarse = std::min(fine + 1, levels_.size() - 1);
  return mix(levels_[fine].at(uv), levels_[coarse].at(uv), level - static_cast<float>(fine));
}

namespace {

const std::array<float, 256>& of_colors() {
  static const std::array<float, 256> linear = linear_from_srgb();
  return linear;
}

const std::array<float, 256>& of_values() {
  static const std::array<float, 256> parts = parts_of_whole();
  return parts;
}

std::shared_ptr<const Texture> made_of(const Picture& picture,
                                       const std::array<float, 256>& linear) {
  if (picture.rgb.empty()) return nullptr;
  std::vector<Float3> colors;
  colors.reserve(picture.rgb.size() / 3);
  for (std::size_t i = 0; i < picture.rgb.size(); i += 3) {
    colors.push_back(
        {linear[picture.rgb[i]], linear[picture.rgb[i + 1]], linear[picture.rgb[i + 2]]});
  }
  return std::make_shared<Texture>(picture.width, picture.height, std::move(colors));
}

}  // namespace

std::shared_ptr<const Texture> read_texture(const std::string& path) {
  return made_of(read_picture(path), of_colors());
}

std::shared_ptr<const Texture> read_values(const std::string& path) {
  return made_of(read_picture(path), of_values());
}

std::shared_ptr<const Texture> decode_texture(const std::string& bytes) {
  return made_of(decode_picture(bytes), of_colors());
}

std::shared_ptr<const Texture> decode_values(const std::string& bytes) {
  return made_of(decode_picture(bytes), of_values());
}

}  // namespace mansard
