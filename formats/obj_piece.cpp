#include "formats/obj_piece.hpp"

#include <algorithm>

#include "formats/obj_names.hpp"

namespace mansard {

void ObjPiece::prepare(const NamedSurface& building) {
  building_ = building;
  normals_.find(building.surface->normals);
}

void ObjPiece::number(std::span<const std::string_view> symbols, std::span<const Look> looks) {
  const Surface& surface = *building_.surface;
  if (surface.polygons() == 0) return;
  name_ = shared_.names.next(safe_name(building_.id));
  before_ = shared_.counts;
  shared_.counts.points += surface.points.size();
  if (surface.has_uvs()) shared_.counts.uvs += surface.uvs.size();
  shared_.counts.normals += normals_.count();
  symbols_ = symbols;
  groups_.sort(surface.runs);
  look_names_.clear();
  look_ends_.clear();
  groups_.for_each([](uint32_t) {},
                   [&](uint32_t look) {
                     shared_.stained = shared_.stained || looks[look].stains;
                     look_names_.name("usemtl ", looks[look].name);
                     look_ends_.push_back(look_names_.text().size());
                   },
                   [](uint32_t) {});
}

/// Its text would take more memory than is good: it is made while it is appended, slice by slice.
bool ObjPiece::is_large() const { return building_.surface->points.size() > 100'000; }

void ObjPiece::format() {
  text_.clear();
  if (!is_large()) write();
}

void ObjPiece::append() {
  if (is_large()) write();
  shared_.out.put(text_.text());
}

void ObjPiece::spill() {
  if (!is_large()) return;
  shared_.out.put(text_.text());
  text_.clear();
}

namespace {

constexpr std::size_t slice = 1 << 15;

/// put(begin, end) for one slice after the other of so many.
template <class Put>
void in_slices(std::size_t begin, std::size_t end, Put put) {
  for (; begin < end; begin += slice) put(begin, std::min(begin + slice, end));
}

}  // namespace

void ObjPiece::write() {
  const Surface& surface = *building_.surface;
  if (surface.polygons() == 0) return;
  const std::span points(surface.points);
  const std::span uvs(surface.uvs);
  text_.name("o ", name_);
  in_slices(0, points.size(), [&](std::size_t begin, std::size_t end) {
    text_.points(points.subspan(begin, end - begin));
    spill();
  });
  in_slices(0, surface.has_uvs() ? uvs.size() : 0, [&](std::size_t begin, std::size_t end) {
    text_.uvs(uvs.subspan(begin, end - begin));
    spill();
  });
  write_normals();
  std::size_t look_line = 0;
  groups_.for_each([&](uint32_t symbol) { text_.name("g ", symbols_[symbol]); },
                   [&](uint32_t) {
                     const std::size_t begin = look_line == 0 ? 0 : look_ends_[look_line - 1];
                     const std::size_t end = look_ends_[look_line++];
                     text_.put(look_names_.text().substr(begin, end - begin));
                   },
                   [&](uint32_t run) {
                     const uint32_t begin = run == 0 ? 0 : surface.runs[run - 1].end;
                     write_faces(begin, surface.runs[run].end);
                   });
}

void ObjPiece::write_normals() {
  uint32_t written = 0;
  for (std::size_t i = 0; written < normals_.count(); ++i) {
    if (normals_.numbers()[i] < written) continue;
    text_.normal(building_.surface->normals[i]);
    if (++written % slice == 0) spill();
  }
}

void ObjPiece::write_faces(std::size_t begin, std::size_t end) {
  in_slices(begin, end, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i)
      text_.face(*building_.surface, i, before_.normals + normals_.numbers()[i] + 1, before_);
    spill();
  });
}

}  // namespace mansard
