#include "formats/gltf_json.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

namespace mansard {
namespace {

using Json = nlohmann::ordered_json;

std::string text_of(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

/// Without the closing brace.
std::string open_text_of(const Json& json) {
  std::string text = text_of(json);
  text.pop_back();
  return text;
}

Json asset(const std::string& comment) {
  Json asset{{"version", "2.0"}, {"generator", "Mansard"}};
  Json lines = Json::array();
  for (std::size_t at = 0; at < comment.size();) {
    const std::size_t end = std::min(comment.find('\n', at), comment.size());
    lines.push_back(comment.substr(at, end - at));
    at = end + 1;
  }
  if (!lines.empty()) asset["extras"]["comment"] = lines;
  return asset;
}

Json attributes_of(std::span<const Property> properties) {
  Json attributes = Json::object();
  for (const Property& p : properties)
    std::visit([&](const auto& value) { attributes[p.name] = value; }, p.value);
  return attributes;
}

}  // namespace

std::string json_text(const GltfHead& head) {
  Json document{{"asset", asset(head.comment)}};
  for (const std::string_view name : head.extensions) {
    document["extensionsUsed"].push_back(name);
    document["extensionsRequired"].push_back(name);
  }
  if (head.bytes > 0) {
    document["buffers"] = {{{"byteLength", head.bytes}}};
    if (!head.uri.empty()) document["buffers"][0]["uri"] = head.uri;
  }
  return open_text_of(document);
}

std::string gltf_node(const NamedSurface& building, const Vec3& origin) {
  Json node{{"name", building.id}};
  if (origin != Vec3{}) node["translation"] = {origin.x, origin.y, origin.z};
  node["extras"] = {{"id", building.id}};
  if (!building.style.empty()) node["extras"]["style"] = building.style;
  if (!building.properties.empty())
    node["extras"]["attributes"] = attributes_of(building.properties);
  return open_text_of(node);
}

std::string json_text(std::string_view text) { return text_of(Json(text)); }

}  // namespace mansard
