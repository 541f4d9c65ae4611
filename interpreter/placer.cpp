#include "interpreter/placer.hpp"

#include <algorithm>
#include <bit>

#include "interpreter/machine.hpp"

namespace mansard {
namespace {

/// What was derived so is not the same for the next shape, or not all that came of it.
constexpr uint32_t once_only =
    read_bits::chance | read_bits::aloud | 1u << static_cast<int>(Attribute::seed);

}  // namespace

struct Placer::Before {
  std::size_t points, polygons, runs, placed, drips, terminals, taken, shapes, operations, pieces,
      calls, materials;

  Before(const Machine& machine, const Placer& placer)
      : points(machine.building->surface.points.size()),
        polygons(machine.building->surface.polygons()),
        runs(machine.building->surface.runs.size()),
        placed(machine.building->surface.placed.size()),
        drips(machine.building->drips.size()),
        terminals(placer.terminals_.size()),
        taken(placer.taken_.size()),
        shapes(machine.building->shapes),
        operations(machine.building->operations),
        pieces(machine.parts),
        calls(machine.calls_),
        materials(machine.building->materials.size()) {}
};

Placer::Placer(Machine& machine)
    : machine_(machine), seen_(machine.program.styles.size() * machine.program.symbols.size()) {}

void Placer::reset(bool shares) {
  shares_ = shares;
  open_ = 0;
  frame_ = none;
  hung_.clear();
  terminals_.clear();
  taken_.clear();
  if (store_.full()) store_.clear();
}

bool Placer::takes(const Shape& shape) const {
  if (machine_.keeps_tree || shape.plain) return false;
  const bool scope_says_all =
      shape.form == Form::rectangle || (shape.form == Form::box && !machine_.program.asks);
  return scope_says_all && machine_.program.styles[shape.style].placeable[shape.symbol];
}

void Placer::place(Shape& shape) {
  machine_.check_reach(shape, shape.symbol);
  const uint32_t before = std::exchange(machine_.reads, 0);
  Seen& like_it = seen(shape);
  const bool looks = shares_ && like_it.helps();
  const Part* known = looks ? store_.find(key_of(shape, like_it.reads)) : nullptr;
  like_it.tries += looks;
  if (known && fits(*known, shape)) {
    ++like_it.hits;
    put(*known, shape);
  } else {
    derive(shape);
  }
  machine_.reads |= before;
}

Placer::Seen& Placer::seen(const Shape& shape) {
  return seen_[shape.style * machine_.program.symbols.size() + shape.symbol];
}

/// At the origin, then moved to its place.
void Placer::derive(Shape& shape) {
  const Shape whole = shape;
  shape.scope.origin = {};
  if (shape.uv_frame != none) {
    UvFrame moved = machine_.uv_frames[shape.uv_frame];
    moved.origin = {};
    machine_.add_frame(shape, moved);
  }
  const double foot = std::exchange(machine_.base_elevation, 0);
  const uint32_t around = std::exchange(frame_, shape.uv_frame);
  if (open_++ == 0) first_polygon_ = static_cast<uint32_t>(machine_.building->surface.polygons());
  const Before before(machine_, *this);
  const uint32_t deepest = std::exchange(deepest_, whole.depth);
  machine_.derive_below(shape);
  machine_.base_elevation = foot;
  const uint32_t read = machine_.reads;
  const bool same_materials = machine_.building->materials.size() == before.materials;
  Seen& like_it = seen(whole);
  like_it.reads |= read & ~once_only;
  if (shares_ && like_it.helps() && !(read & once_only) && same_materials && !store_.full()) {
    keep(whole, before, read);
  }
  frame_ = around;
  settle(whole, before);
  deepest_ = std::max(deepest_, deepest);
  if (--open_ > 0) return;
  hung_.clear();
  terminals_.clear();
  taken_.clear();
}

/// Everything that the derivation of a rectangle or a box may depend on, its place apart.
PartKey Placer::key_of(const Shape& s, uint32_t reads) const {
  const Machine& m = machine_;
  const bool direct = s.look_by != none && s.look_by == m.parent_of(s);
  const bool own_material = s.material >= m.program.materials.size();
  PartKey key;
  key.add(s.symbol | static_cast<uint64_t>(s.style) << 32 | static_cast<uint64_t>(m.lod) << 48);
  key.add(static_cast<uint64_t>(s.form) | static_cast<uint64_t>(s.cuts) << 8 |
          static_cast<uint64_t>(s.open) << 16 | static_cast<uint64_t>(s.mass) << 24 |
          static_cast<uint64_t>(s.ground) << 25 | static_cast<uint64_t>(s.hides) << 26 |
          static_cast<uint64_t>(s.massive) << 27 | static_cast<uint64_t>(direct) << 28 |
          static_cast<uint64_t>(s.tag.flags) << 32 | static_cast<uint64_t>(s.tag.wall) << 48);
  key.add(s.material | static_cast<uint64_t>(s.label) << 32);
  key.add(s.scope.size);
  key.add(s.scope.x);
  key.add(s.scope.y);
  key.add(s.scope.z);
  key.add(s.pivot);
  key.add(s.index);
  key.add(std::bit_cast<uint32_t>(s.corner_left) |
          static_cast<uint64_t>(std::bit_cast<uint32_t>(s.corner_right)) << 32);
  key.add(m.inherited_values(s));
  key.add(reads);
  key.add(own_material || (reads & read_bits::building) ? m.building_number_ : 0);
  key.add(word_of(s, reads));
  key.add(m.program.stain_look == none ? 0 : s.depth);  // how far down stain() goes
  if (s.uv_frame == none) return key;
  const UvFrame& frame = m.uv_frames[s.uv_frame];
  key.add(frame.u);
  key.add(frame.v);
  key.add(frame.normal);
  key.add(static_cast<uint32_t>(frame.in_repeats) | static_cast<uint32_t>(frame.level) << 1);
  return key;
}

/// What splits and components left on the shape, as far as it is read.
uint64_t Placer::word_of(const Shape& s, uint32_t reads) const {
  const auto bit = [&](Attribute a) { return (reads >> static_cast<int>(a)) & 1; };
  uint64_t word = 0;
  const auto add = [&](Attribute a, uint32_t value) {
    if (bit(a)) word = mix(word, value);
  };
  add(Attribute::split_index, s.split_index);
  add(Attribute::split_count, s.split_count);
  add(Attribute::split_round, s.split_round);
  add(Attribute::comp_index, s.comp_index);
  add(Attribute::comp_count, s.comp_count);
  add(Attribute::comp_name, s.comp_name);
  add(Attribute::level, s.level);
  return word;
}

/// Whether none of the limits is reached with it: else it is derived, which tells where.
bool Placer::fits(const Part& part, const Shape& shape) const {
  const DeriveOptions& limits = machine_.options;
  const Building& building = *machine_.building;
  return building.shapes + part.shapes <= limits.max_shapes &&
         machine_.parts + part.pieces <= limits.max_shapes &&
         building.surface.polygons() + part.polygons.count <= 16 * limits.max_shapes &&
         shape.depth + part.depth <= limits.max_depth;
}

Moves Placer::moves_of(const Shape& shape) const {
  const Vec3 to = shape.scope.origin;
  const bool hangs = shape.uv_frame != none;
  return {to, hangs ? to - machine_.uv_frames[shape.uv_frame].origin : Vec3{},
          to.y - machine_.base_elevation};
}

/// Whether the part hangs on the same wall as the part around it.
bool Placer::stays_on_wall(const Shape& shape) const {
  return shape.uv_frame != none && shape.uv_frame == frame_;
}

/// Moves the textures of a part, polygon by polygon.
class Placer::Textures {
 public:
  Textures(Placer& placer, const Hangings& from, const Moves& moves, bool stays)
      : placer_(placer), from_(from), moves_(moves), stays_(stays) {}

  /// Gives the kind of hanging in the part around.
  uint32_t move(Surface& surface, std::size_t polygon, uint32_t kind) {
    if (kind != kind_) turn_to(kind);
    if (shift_ == Vec2{}) return around_;
    for (uint32_t k = surface.begin(polygon); k < surface.ends[polygon]; ++k) {
      surface.uvs[k] = surface.uvs[k] + shift_;
    }
    return around_;
  }

 private:
  void turn_to(uint32_t kind) {
    const Hang hang = from_.of_kind(kind);
    kind_ = kind;
    shift_ = moves_.shift(hang);
    around_ = placer_.hung_.kind({hang.on_wall && stays_, hang.level, hang.u, hang.v});
  }

  Placer& placer_;
  const Hangings& from_;
  const Moves moves_;
  const bool stays_;
  uint32_t kind_ = 0, around_ = 0;
  Vec2 shift_;
};

void Placer::put(const Part& part, const Shape& shape) {
  Building& building = *machine_.building;
  Surface& surface = building.surface;
  const Moves moves = moves_of(shape);
  const std::size_t first = surface.points.size(), first_polygon = surface.polygons();

  surface.points.resize(first + part.points.count);
  const Vec3* const points = store_.points.data() + part.points.first;
  for (std::size_t i = 0; i < part.points.count; ++i)
    surface.points[first + i] = points[i] + moves.by;
  const auto uvs = store_.uvs.begin() + part.points.first;
  surface.uvs.insert(surface.uvs.end(), uvs, uvs + part.points.count);
  const auto normals = store_.normals.begin() + part.polygons.first;
  surface.normals.insert(surface.normals.end(), normals, normals + part.polygons.count);
  surface.ends.resize(first_polygon + part.polygons.count);
  const uint32_t* const ends = store_.ends.data() + part.polygons.first;
  for (std::size_t i = 0; i < part.polygons.count; ++i) {
    surface.ends[first_polygon + i] = static_cast<uint32_t>(first) + ends[i];
  }
  put_textures(part, shape, moves);
  for (const Surface::Run& run : PartStore::slice(store_.runs, part.runs)) {
    machine_.add_run(run.symbol, run.material, static_cast<uint32_t>(first_polygon) + run.end);
  }
  for (Surface::Placed placed : PartStore::slice(store_.placed, part.placed)) {
    placed.origin = placed.origin + moves.by;
    placed.begin += static_cast<uint32_t>(first_polygon);
    placed.end += static_cast<uint32_t>(first_polygon);
    surface.placed.push_back(placed);
  }
  for (const auto& [symbol, n] : PartStore::slice(store_.counts, part.terminals)) {
    building.terminals[symbol] += n;
    if (open_ > 0) terminals_.emplace_back(symbol, n);
  }
  for (const auto& [production, n] : PartStore::slice(store_.counts, part.taken)) {
    building.taken[production] += n;
    if (open_ > 0) taken_.emplace_back(production, n);
  }
  building.shapes += part.shapes;
  building.copied += part.shapes;
  building.operations += part.operations;
  machine_.parts += part.pieces;
  machine_.calls_ += part.calls;
  machine_.reads |= part.reads;
  note_depth(shape.depth + part.depth);
}

void Placer::put_textures(const Part& part, const Shape& shape, const Moves& moves) {
  const std::size_t count = part.polygons.count;
  if (!part.hangs || (open_ == 0 && !moves.moves_textures())) {
    if (open_ > 0) hung_.add_loose(count);
    return;
  }
  Surface& surface = machine_.building->surface;
  const std::size_t first = surface.polygons() - count;
  Textures textures(*this, store_.hung, moves, stays_on_wall(shape));
  for (std::size_t i = 0; i < count; ++i) {
    const uint32_t kind = textures.move(surface, first + i, store_.hung[part.polygons.first + i]);
    if (open_ > 0) hung_.add(kind);
  }
}

/// Sorted by number, each number once.
void Placer::count(std::vector<PartCount>& counts, std::size_t first) {
  const auto begin = counts.begin() + static_cast<std::ptrdiff_t>(first);
  std::sort(begin, counts.end());
  auto last = begin;
  for (auto next = begin; next != counts.end(); ++next) {
    if (next != begin && next->first == last->first) {
      last->second += next->second;
    } else {
      last = next == begin ? begin : last + 1;
      *last = *next;
    }
  }
  if (begin != counts.end()) counts.erase(last + 1, counts.end());
}

void Placer::keep(const Shape& shape, const Before& before, uint32_t read) {
  const Building& building = *machine_.building;
  Part& part = store_.add(key_of(shape, seen(shape).reads));
  keep_surface(part, before);
  const auto keep_counts = [&](std::vector<PartCount>& noted, std::size_t first) {
    count(noted, first);
    const auto begin = noted.begin() + static_cast<std::ptrdiff_t>(first);
    const auto at = static_cast<uint32_t>(store_.counts.size());
    store_.counts.insert(store_.counts.end(), begin, noted.end());
    return Part::Range{at, static_cast<uint32_t>(noted.size() - first)};
  };
  part.terminals = keep_counts(terminals_, before.terminals);
  part.taken = keep_counts(taken_, before.taken);
  part.shapes = static_cast<uint32_t>(building.shapes - before.shapes);
  part.operations = static_cast<uint32_t>(building.operations - before.operations);
  part.pieces = static_cast<uint32_t>(machine_.parts - before.pieces);
  part.calls = static_cast<uint32_t>(machine_.calls_ - before.calls);
  part.depth = deepest_ - shape.depth;
  part.reads = read;
}

void Placer::keep_surface(Part& part, const Before& before) {
  const Surface& surface = machine_.building->surface;
  const auto range = [](std::size_t first, std::size_t count) {
    return Part::Range{static_cast<uint32_t>(first), static_cast<uint32_t>(count)};
  };
  const auto tail = [](const auto& all, std::size_t first) {
    return std::span(all).subspan(first);
  };
  const auto append = [](auto& to, const auto& from) {
    to.insert(to.end(), from.begin(), from.end());
  };
  const auto first_point = static_cast<uint32_t>(before.points);
  const auto first_polygon = static_cast<uint32_t>(before.polygons);

  part.points = range(store_.points.size(), surface.points.size() - before.points);
  append(store_.points, tail(surface.points, before.points));
  append(store_.uvs, tail(surface.uvs, before.points));
  part.polygons = range(store_.ends.size(), surface.polygons() - before.polygons);
  append(store_.normals, tail(surface.normals, before.polygons));
  for (const uint32_t end : tail(surface.ends, before.polygons))
    store_.ends.push_back(end - first_point);
  for (std::size_t i = before.polygons; i < surface.polygons(); ++i) {
    const uint32_t kind = hung_[i - first_polygon_];
    store_.hung.add(store_.hung.kind(hung_.of_kind(kind)));
    part.hangs = part.hangs || kind != 0;
  }
  part.runs.first = static_cast<uint32_t>(store_.runs.size());
  for (Surface::Run run : tail(surface.runs, before.runs > 0 ? before.runs - 1 : 0)) {
    if (run.end <= first_polygon) continue;
    run.end -= first_polygon;
    store_.runs.push_back(run);
  }
  part.runs.count = static_cast<uint32_t>(store_.runs.size()) - part.runs.first;
  part.placed = range(store_.placed.size(), surface.placed.size() - before.placed);
  for (Surface::Placed placed : tail(surface.placed, before.placed)) {
    placed.begin -= first_polygon;
    placed.end -= first_polygon;
    store_.placed.push_back(placed);
  }
}

/// The same arithmetic as put().
void Placer::settle(const Shape& shape, const Before& before) {
  Building& building = *machine_.building;
  Surface& surface = building.surface;
  const Moves moves = moves_of(shape);
  for (std::size_t i = before.points; i < surface.points.size(); ++i) {
    surface.points[i] = surface.points[i] + moves.by;
  }
  for (std::size_t i = before.placed; i < surface.placed.size(); ++i) {
    surface.placed[i].origin = surface.placed[i].origin + moves.by;
  }
  for (std::size_t i = before.drips; i < building.drips.size(); ++i) {
    building.drips[i].move(moves.by);
  }
  const bool stays = stays_on_wall(shape);
  if (!moves.moves_textures() && (stays || open_ == 1)) return;
  Textures textures(*this, hung_, moves, stays);
  for (std::size_t i = before.polygons; i < surface.polygons(); ++i) {
    uint32_t& kind = hung_[i - first_polygon_];
    kind = textures.move(surface, i, kind);
  }
}

}  // namespace mansard
