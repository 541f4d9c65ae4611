#include "formats/gltf_looks.hpp"

#include <map>
#include <nlohmann/json.hpp>

#include "formats/color.hpp"
#include "formats/copied_pictures.hpp"
#include "formats/pictures.hpp"
#include "grammar/diagnostic.hpp"

namespace mansard {

using Json = nlohmann::ordered_json;

namespace {
constexpr uint32_t unused = 0xffffffff;
}

uint32_t GltfLooks::material_of(uint32_t look) {
  if (look >= materials_.size()) materials_.resize(look + 1, unused);
  if (materials_[look] == unused) {
    materials_[look] = static_cast<uint32_t>(used_.size());
    used_.push_back(look);
  }
  return materials_[look];
}

std::string as_uri(std::string_view name) {
  constexpr std::string_view digits = "0123456789ABCDEF";
  std::string uri;
  for (const char c : name) {
    const auto code = static_cast<unsigned char>(c);
    const bool plain = (code | 0x20) >= 'a' && (code | 0x20) <= 'z';
    if (plain || (c >= '0' && c <= '9') || c == '.' || c == '-' || c == '_') {
      uri += c;
    } else {
      uri += {'%', digits[code >> 4], digits[code & 15]};
    }
  }
  return uri;
}

namespace {

/// By its first bytes; glTF takes no other pictures.
std::string_view type_of(std::string_view bytes, const std::string& path) {
  if (bytes.starts_with("\x89PNG\r\n\x1a\n")) return "image/png";
  if (bytes.starts_with("\xff\xd8\xff")) return "image/jpeg";
  Diagnostic d;
  d.text = "texture '" + path + "' is neither a PNG nor a JPEG picture: glTF takes no other";
  d.help = "convert it, or write an .obj";
  throw Failure(std::move(d));
}

/// The pictures of a document, each once.
class Images {
 public:
  Images(const std::string& model, Spool* spool, std::size_t first_view,
         std::vector<std::pair<uint64_t, uint64_t>>& views)
      : copies_(model), spool_(spool), first_view_(first_view), views_(views) {}

  std::size_t texture_of(const std::string& path) {
    const auto [known, fresh] = numbers_.try_emplace({path, {}}, numbers_.size());
    if (!fresh) return known->second;
    const std::string bytes = picture_bytes(path);
    const std::string_view type = type_of(bytes, path);
    if (spool_) {
      embed(bytes, type);
    } else {
      images.push_back({{"uri", as_uri(copies_.name_of(path))}});
    }
    textures.push_back({{"source", known->second}});
    return known->second;
  }

  /// Roughness and metal in one picture. Without metal that of roughness is such a picture.
  std::size_t metal_rough_of(const Finish& finish) {
    if (finish.metallic == 0 && finish.metallic_map.empty())
      return texture_of(finish.roughness_map);
    const auto [known, fresh] =
        numbers_.try_emplace({finish.roughness_map, finish.metallic_map + "\n"}, numbers_.size());
    if (!fresh) return known->second;
    const std::string bytes = packed_metal_rough(finish.roughness_map, finish.metallic_map);
    if (spool_) {
      embed(bytes, "image/png");
    } else {
      images.push_back({{"uri", as_uri(copies_.put("metal_rough.png", bytes))}});
    }
    textures.push_back({{"source", known->second}});
    return known->second;
  }

  Json images = Json::array(), textures = Json::array();

 private:
  void embed(const std::string& bytes, std::string_view type) {
    images.push_back({{"mimeType", type}, {"bufferView", first_view_ + views_.size()}});
    views_.emplace_back(spool_->bytes(), bytes.size());
    spool_->put(bytes);
    spool_->align();
  }

  CopiedPictures copies_;
  Spool* spool_;
  std::size_t first_view_;
  std::vector<std::pair<uint64_t, uint64_t>>& views_;
  std::map<std::pair<std::string, std::string>, std::size_t> numbers_;
};

Json surface_of(const Look& look, Images& images) {
  Json surface;
  const Vec3 c = look.color;
  if (!look.texture.empty())
    surface["baseColorTexture"] = {{"index", images.texture_of(look.texture)}};
  if (look.texture.empty() || look.opacity < 1 || c != Vec3{1, 1, 1}) {
    surface["baseColorFactor"] = {to_linear(c.x), to_linear(c.y), to_linear(c.z), look.opacity};
  }
  const Finish& finish = look.finish;
  if (!finish.roughness_map.empty() || !finish.metallic_map.empty())
    surface["metallicRoughnessTexture"] = {{"index", images.metal_rough_of(finish)}};
  surface["metallicFactor"] = finish.metallic;
  if (finish.roughness < 1) surface["roughnessFactor"] = finish.roughness;
  return surface;
}

Json to_json(const Look& look, Images& images) {
  Json material{{"name", look.name}, {"pbrMetallicRoughness", surface_of(look, images)}};
  if (!look.finish.normal_map.empty()) {
    Json& normals = material["normalTexture"];
    normals["index"] = images.texture_of(look.finish.normal_map);
    if (look.finish.relief != 1) normals["scale"] = look.finish.relief;
  }
  if (look.opacity < 1 || look.stains) material["alphaMode"] = "BLEND";
  return material;
}

}  // namespace

std::string GltfLooks::members(std::span<const Look> looks, const std::string& model,
                               Spool* pictures, std::size_t first_view) {
  Images images(model, pictures, first_view, views_);
  Json materials = Json::array();
  for (const uint32_t number : used_) materials.push_back(to_json(looks[number], images));
  std::string text;
  const auto add = [&](std::string_view key, const Json& list) {
    if (list.empty()) return;
    text += ",\"" + std::string(key) +
            "\":" + list.dump(-1, ' ', false, Json::error_handler_t::replace);
  };
  add("materials", materials);
  add("textures", images.textures);
  add("images", images.images);
  return text;
}

}  // namespace mansard
