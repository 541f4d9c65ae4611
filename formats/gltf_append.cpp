// What a building's piece adds to the lists of a glTF document.
#include <array>
#include <utility>

#include "formats/gltf_piece.hpp"
#include "formats/numbers.hpp"
#include "grammar/diagnostic.hpp"

namespace mansard {
namespace {

/// To the numbers of a list.
void add_to(std::string& numbers, uint64_t number) {
  if (!numbers.empty()) numbers += ',';
  numbers += std::to_string(number);
}

void put_list(std::string& text, std::span<const double> values) {
  for (const double value : values) {
    char digits[number_length];
    text.append(digits, put_number(digits, value));
    text += ',';
  }
  text.back() = ']';
}

}  // namespace

void GltfFile::check_size(uint64_t bytes) const {
  if (!is_binary() || bytes <= options.most) return;
  Diagnostic d;
  d.text = "a .glb holds at most " + std::to_string(options.most / 1'000'000) + " MB, and '" +
           path + "' would have more from its building " + std::to_string(roots.size()) + " on";
  d.help = "write a .gltf, a coarser level of detail (--lod 2), or fewer buildings into one file";
  throw Failure(std::move(d));
}

void GltfPiece::append() {
  std::string children;
  for (const Node& node : nodes_) {
    const std::string text = append_node(node);
    if (!text.empty()) add_to(children, file_.nodes.add(text));
  }
  if (children.empty()) return;
  const uint64_t root = file_.nodes.add(root_ + ",\"children\":[" + children + "]}");
  file_.roots.add(std::to_string(root));
  file_.check_size(file_.bytes());
}

/// Empty, where nothing is drawn. A mesh takes its number after those that it brings.
std::string GltfPiece::append_node(const Node& node) {
  const std::string own = append_parts(node.parts_begin, node.parts_end);
  std::size_t begin = node.parts_end;
  for (const auto& [mesh, end] : node.brought) {
    mesh->number = append_mesh(node, append_parts(begin, end));
    begin = end;
  }
  const std::string placed = append_places(node);
  if (own.empty() && placed.empty()) return {};
  std::string text = "{\"name\":" + node.name;
  if (!own.empty()) text += ",\"mesh\":" + std::to_string(append_mesh(node, own));
  if (!placed.empty()) text += ",\"children\":[" + placed + "]";
  return text + ",\"extras\":{\"symbol\":" + node.name + "}}";
}

/// As the primitives of a mesh.
std::string GltfPiece::append_parts(std::size_t begin, std::size_t end) {
  std::string primitives;
  for (std::size_t i = begin; i < end; ++i) {
    if (!primitives.empty()) primitives += ",";
    primitives += "{" + file_.buffers.add(parts_[i], parts_.bytes(i)) +
                  ",\"material\":" + std::to_string(file_.looks.material_of(parts_[i].look)) + "}";
  }
  return primitives;
}

uint64_t GltfPiece::append_mesh(const Node& node, const std::string& primitives) {
  return file_.meshes.add("{\"name\":" + node.name + ",\"primitives\":[" + primitives + "]}");
}

/// Numbers of the nodes that place the symbol's shared meshes.
std::string GltfPiece::append_places(const Node& node) {
  std::string numbers;
  for (const Places& places : node.places)
    add_to(numbers, file_.nodes.add(placed_node(node, places)));
  return numbers;
}

std::string GltfPiece::placed_node(const Node& node, const Places& places) {
  std::string text = "{\"name\":" + node.name + ",\"mesh\":" + std::to_string(*places.mesh->number);
  if (places.all.size() > 1) {
    file_.instanced = true;
    text += ",\"extensions\":{\"EXT_mesh_gpu_instancing\":{" + file_.buffers.add(places.all) + "}}";
  } else {
    const auto& [t, rotation, s] = places.all.front();
    text += ",\"translation\":[";
    put_list(text, std::array{t.x, t.y, t.z});
    text += ",\"rotation\":[";
    put_list(text, rotation);
    text += ",\"scale\":[";
    put_list(text, std::array{s.x, s.y, s.z});
  }
  return text + ",\"extras\":{\"symbol\":" + node.name + "}}";
}

}  // namespace mansard
