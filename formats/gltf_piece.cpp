#include "formats/gltf_piece.hpp"

#include <algorithm>
#include <cmath>

#include "formats/gltf_json.hpp"

namespace mansard {
namespace {

/// The middle of its base, to the millimetre: vertices are floats, which are precise near 0.
Vec3 origin_of(const Surface& surface) {
  const Box3 box = bounds(surface.points);
  const auto rounded = [](double v) { return std::round(v * 1000) / 1000; };
  return {rounded((box.low.x + box.high.x) / 2), rounded(box.low.y),
          rounded((box.low.z + box.high.z) / 2)};
}

}  // namespace

void GltfPiece::prepare(const NamedSurface& building) {
  building_ = building;
  if (building.surface->polygons() == 0) return;
  origin_ = origin_of(*building.surface);
  file_.shared.find_sharable(*building.surface, sharable_);
}

// ---- numbering

void GltfPiece::number(std::span<const std::string_view> symbols, std::span<const Look> looks) {
  const Surface& surface = *building_.surface;
  if (surface.polygons() == 0) return;
  symbols_ = symbols;
  file_.shared.find(surface, sharable_, meshes_);
  find_placed_symbols();
  brings_.assign(meshes_.size(), false);
  looks_.clear();
  groups_.sort(surface.runs);
  groups_.for_each([&](uint32_t symbol) { claim_meshes(symbol); },
                   [&](uint32_t look) {
                     const Look& seen = looks[look];
                     looks_.push_back({look, seen.has_pictures(), !seen.finish.normal_map.empty()});
                   },
                   [](uint32_t) {});
}

void GltfPiece::find_placed_symbols() {
  const Surface& surface = *building_.surface;
  placed_symbols_.assign(meshes_.size(), none);
  auto run = surface.runs.begin();
  for (std::size_t i = 0; i < meshes_.size(); ++i) {
    while (run->end <= surface.placed[i].begin) ++run;
    if (meshes_[i]) placed_symbols_[i] = run->symbol;
  }
}

/// A shared mesh is brought by the first building, there by the first symbol, that has it.
void GltfPiece::claim_meshes(uint32_t symbol) {
  for (std::size_t i = 0; i < meshes_.size(); ++i) {
    if (placed_symbols_[i] != symbol || meshes_[i]->claimed) continue;
    meshes_[i]->claimed = brings_[i] = true;
  }
}

// ---- formatting

void GltfPiece::format() {
  parts_.clear();
  nodes_.clear();
  const Surface& surface = *building_.surface;
  if (surface.polygons() == 0) return;
  primitive_ = file_.primitives.take();
  primitive_->clear(false);
  uint32_t symbol = none;
  const auto end_symbol = [&] {
    if (symbol == none) return;
    end_own_mesh();
    add_placed(symbol);
  };
  groups_.for_each(
      [&](uint32_t next) {
        end_symbol();
        symbol = next;
        nodes_.push_back({json_text(symbols_[symbol]), parts_.size(), 0, {}, {}});
      },
      [&](uint32_t look) { begin_primitive(look, surface.has_uvs()); },
      [&](uint32_t run) {
        add_polygons(run == 0 ? 0 : surface.runs[run - 1].end, surface.runs[run].end);
      });
  end_symbol();
  file_.primitives.give_back(primitive_);
  root_ = gltf_node(building_, origin_);
}

void GltfPiece::begin_primitive(uint32_t look, bool uvs) {
  end_primitive();
  look_ = look;
  const SeenLook& seen = *std::ranges::find(looks_, look, &SeenLook::look);
  primitive_->clear(uvs && seen.pictures, seen.normal_map);
}

void GltfPiece::end_primitive() {
  if (!primitive_->empty()) parts_.add(*primitive_, look_);
  primitive_->clear(false);
}

/// But those of shared meshes.
void GltfPiece::add_polygons(uint32_t begin, uint32_t end) {
  const Surface& surface = *building_.surface;
  const auto& placed = surface.placed;
  auto next = std::ranges::upper_bound(placed, begin, {}, &Surface::Placed::end);
  for (uint32_t i = begin; i < end;) {
    while (next != placed.end() &&
           (next->end <= i || placed_symbols_[std::size_t(next - placed.begin())] == none))
      ++next;
    if (next != placed.end() && next->begin <= i) {
      i = next->end;
    } else {
      primitive_->add(surface, i++, origin_);
    }
  }
}

void GltfPiece::end_own_mesh() {
  end_primitive();
  nodes_.back().parts_end = parts_.size();
}

void GltfPiece::add_placed(uint32_t symbol) {
  for (std::size_t i = 0; i < placed_symbols_.size(); ++i) {
    if (placed_symbols_[i] != symbol) continue;
    if (brings_[i]) bring_mesh(i);
    add_place(i);
  }
}

void GltfPiece::bring_mesh(std::size_t placed) {
  const Surface own = own_frame(*building_.surface, building_.surface->placed[placed]);
  uint32_t polygon = 0;
  for (const Surface::Run& run : own.runs) {
    begin_primitive(run.material, true);
    for (; polygon < run.end; ++polygon) primitive_->add(own, polygon, {});
  }
  end_primitive();
  nodes_.back().brought.push_back({meshes_[placed], parts_.size()});
}

/// Instances of one mesh stand together.
void GltfPiece::add_place(std::size_t placed) {
  std::vector<Places>& places = nodes_.back().places;
  const GltfPlace place = place_of(building_.surface->placed[placed], origin_);
  const auto known = file_.options.instancing == Instancing::gpu
                         ? std::ranges::find(places, meshes_[placed], &Places::mesh)
                         : places.end();
  if (known == places.end()) {
    places.push_back({meshes_[placed], {place}});
  } else {
    known->all.push_back(place);
  }
}

}  // namespace mansard
