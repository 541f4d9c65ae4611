// The loop of the derivation: take a shape, choose a production, carry out its successor.
#include "interpreter/context.hpp"

#include <algorithm>
#include <cmath>

#include "interpreter/building_height.hpp"
#include "interpreter/measure.hpp"

namespace mansard {

Machine::Machine(const Program& p, MeshSource& meshes, const DeriveOptions& o)
    : program(p),
      options(o),
      mesh_source(meshes),
      counts_(p.symbols.size()),
      placer_(*this),
      variable_values_(p.variables.size()),
      variable_known_(p.variables.size(), 0),
      variable_varies_(p.variables.size(), false),
      property_values_(p.properties.size(), nullptr),
      property_known_(p.properties.size(), 0),
      variable_property_(p.variables.size(), none) {}

Machine::~Machine() = default;

Measurer& Machine::measurer() {
  if (!measurer_) measurer_ = std::make_unique<Measurer>(*this);
  return *measurer_;
}

void Machine::derive(const Footprint& input, Building& result) {
  reset(input, result);
  try {
    Shape start = footprint_shape();
    nodes_.push_back({Shape::none, start.symbol, start.seed});
    start.node = 0;
    if (keeps_tree) building->tree.push_back({start, Shape::none, false});
    stack_.push_back(start);
    derive_all();
    if (!result.drips.empty()) draw_stains();
    for (SnapSplit& split : result.snap_splits) split.late = planes.any(split.to);
  } catch (Failure& failure) {
    explain(failure.diagnostic);
    auto warnings = std::move(result.warnings);
    result.clear();
    result.id = input.id;
    result.warnings = std::move(warnings);
    throw;
  }
}

void Machine::derive_all() {
  for (;;) {
    while (!stack_.empty()) {
      Shape shape = stack_.back();
      stack_.pop_back();
      expand(shape);
    }
    if (waiting_.empty()) return;
    answer_round();
  }
}

void Machine::derive_below(Shape& shape) {
  const std::size_t below = stack_.size();
  replace(shape);
  while (stack_.size() > below) {
    Shape next = stack_.back();
    stack_.pop_back();
    expand(next);
  }
}

void Machine::reset(const Footprint& input, Building& result) {
  footprint = &input;
  building = &result;
  result.clear();
  result.id = input.id;
  result.terminals.resize(program.symbols.size());
  result.taken.resize(program.productions.size());
  stack_.clear();
  waiting_.clear();
  world.clear();
  nodes_.clear();
  polygons_.reset();
  meshes_.reset();
  values_.reset();
  characters_.reset();
  settings.clear();
  uv_frames.clear();
  scratch_shapes.clear();
  scratch_sizes.clear();
  scratch_counts.clear();
  std::fill(counts_.begin(), counts_.end(), Count{});
  expanding = none;
  meeting = nullptr;
  meetings_.reset();
  trials_.reset();
  tried_ = 0;
  lod = options.lod;
  keeps_tree = options.keep_tree;
  scoring_ = explained_ = false;
  production = nullptr;
  current_rules_ = none;
  depth_ = super_depth_ = 0;
  calls_ = rounds_ = parts = 0;
  siblings_ = {};
  sibling_counts_.clear();
  size_values.clear();
  measuring = false;
  if (measurer_) measurer_->reset();
  placer_.reset(options.share_parts);
  reads = 0;
  ++building_number_;
  building_seed_ = mix(options.seed, hash_of(input.id));
  for (const uint32_t slot : overridden_) variable_property_[slot] = none;
  overridden_.clear();
  for (const Property& property : input.properties) {
    if (const auto slot = program.properties.find(property.name)) {
      property_values_[*slot] = &property.value;
      property_known_[*slot] = building_number_;
      const auto named = program.variables_by_property.find(property.name);
      if (named == program.variables_by_property.end()) continue;
      for (const uint32_t variable : named->second) {
        if (program.variables[variable].from_command_line) continue;
        variable_property_[variable] = *slot;
        overridden_.push_back(variable);
      }
    }
  }
}

Shape Machine::footprint_shape() {
  const Polygon& plan = footprint->polygon;
  if (plan.points.size() < 3 || plan.rings() == 0) {
    fail({}, "the footprint has fewer than three points", "leave it out with --keep-going");
  }
  const auto outline = plan.ring(0);
  const Vec2 along = normalized(outline[1] - outline[0]), into = left_of(along);
  Shape shape;
  shape.form = Form::polygon;
  shape.ground = true;
  shape.geometry = polygons_.take();
  PooledPolygon& pooled = polygons_[shape.geometry];
  pooled.polygon.clear();
  for (std::size_t r = 0; r < plan.rings(); ++r) {
    for (uint32_t i = plan.ring_begin(r); i < plan.ring_ends[r]; ++i) {
      const Vec2 p = plan.points[i] - outline[0];
      pooled.polygon.add_point({dot(p, along), dot(p, into)}, plan.tags[i]);
    }
    pooled.polygon.close_ring();
  }
  const Box2 box = bounds(pooled.polygon.points);
  for (Vec2& p : pooled.polygon.points) p = p - box.low;
  pooled.natural = box.size();
  base_elevation = base_of(*footprint);
  const Vec2 corner = outline[0] + along * box.low.x + into * box.high.y;
  shape.scope.origin = {corner.x, base_elevation, -corner.y};
  shape.scope.x = {along.x, 0, -along.y};
  shape.scope.z = {along.y, 0, along.x};
  shape.scope.size = {pooled.natural.x, 0, pooled.natural.y};
  planes.clear(shape.scope.origin);
  shape.style = program.main_style;
  shape.symbol = program.styles[program.main_style].start;
  shape.seed = building_seed_;
  if (!std::isfinite(pooled.natural.x + pooled.natural.y + corner.x + corner.y)) {
    fail({}, "the footprint has coordinates that are not numbers");
  }
  return shape;
}

uint32_t Machine::rules_of(const Shape& shape) const {
  return shape.plain ? none : program.styles[shape.style].rules[shape.symbol];
}

void Machine::expand(Shape& shape) {
  const uint32_t rule_set = rules_of(shape);
  if (rule_set != none && program.rule_sets[rule_set].waits) return waiting_.push_back(shape);
  if (placer_.takes(shape)) return placer_.place(shape);
  replace(shape);
}

void Machine::replace(Shape& shape) {
  const uint32_t rule_set = rules_of(shape);
  expanding = shape.node;
  if (rule_set == none) return finish(shape);
  const RuleSet& rules = program.rule_sets[rule_set];
  const std::size_t first = stack_.size();
  emitted = 0;
  siblings_ = {};
  // Operations change the shape; guards and arguments read it as it is at their place.
  const Scope frame = shape.scope;
  Env env{&shape, shape.arguments, shape.seed, &frame};
  rewrite(rules, rule_set, shape, env);
  production = nullptr;
  if (emitted == 0) return finish(shape);
  std::reverse(stack_.begin() + static_cast<std::ptrdiff_t>(first), stack_.end());
}

void Machine::rewrite(const RuleSet& rules, uint32_t rule_set, Shape& shape, Env& env) {
  const Production* const before = production;
  const Production* chosen = choose(rules, shape, env);
  if (!chosen) {
    no_candidate(rules, shape);
    production = before;
    return;
  }
  const uint32_t rules_before = current_rules_;
  const auto number = static_cast<uint32_t>(chosen - program.productions.data());
  ++building->taken[number];
  placer_.note_taken(number);
  production = chosen;
  current_rules_ = rule_set;
  bind_index(*chosen, rules, shape, env);
  run(chosen->body, shape, env);
  production = before;
  current_rules_ = rules_before;
}

void Machine::run(BodyId body, Shape& shape, const Env& env) {
  const Body& b = program.bodies[body];
  for (const Step *s = program.steps.data() + b.first, *end = s + b.count; s != end; ++s) {
    step(*s, shape, env);
  }
}

void Machine::step(const Step& s, Shape& shape, const Env& outer) {
  Env env{&shape, outer.parameters, outer.draws, outer.frame};
  switch (s.kind) {
    case StepKind::emit:
      emit(s, s.what, s.style == 0xffff ? shape.style : s.style, shape, env);
      break;
    case StepKind::emit_value: {
      const Value symbol = emitted_symbol(s, env);
      emit(s, symbol.symbol, symbol.size > 0 ? symbol.size - 1 : shape.style, shape, env);
      break;
    }
    case StepKind::operation: {
      const Call& call = program.calls[s.what];
      ++building->operations;
      if (call.has_parts && !call.operation->is_split) {
        Shape piece = shape;  // after the parts the shape is what it was
        Context context(*this, call, piece, env);
        call.operation->invoke(context);
      } else {
        Context context(*this, call, shape, env);
        call.operation->invoke(context);
      }
      break;
    }
    case StepKind::push: {
      Shape inner = shape;
      run(s.what, inner, env);
      break;
    }
    case StepKind::super:
      run_super(shape, env);
      break;
    case StepKind::branch:
      for (const BranchArm& arm : program.branches[s.what].arms) {
        if (arm.condition != none && !condition(arm.condition, env)) continue;
        run(arm.body, shape, env);
        break;
      }
      break;
  }
}

void Machine::run_super(Shape& shape, const Env& env) {
  const uint32_t next = program.rule_sets[current_rules_].super;
  Step plain;
  plain.kind = StepKind::super;
  if (next == none) {
    return emit(plain, nodes_[expanding].symbol, shape.style, shape, env);
  }
  constexpr int most_supers = 200;
  if (++super_depth_ > most_supers) fail({}, "'super' goes on more than 200 times");
  Shape inner = shape;  // what follows super goes on with the shape as it was
  Env inside{&inner, env.parameters, mix(env.draws, hash_of("super")), env.frame};
  const std::size_t before = emitted;
  rewrite(program.rule_sets[next], next, inner, inside);
  --super_depth_;
  if (emitted == before) emit(plain, nodes_[expanding].symbol, inner.style, inner, env);
}

PooledPolygon& Machine::new_polygon(Shape& shape) {
  shape.geometry = polygons_.take();
  PooledPolygon& pooled = polygons_[shape.geometry];
  pooled.polygon.clear();
  return pooled;
}

void Machine::adopt(Shape& shape, Polygon&& polygon) {
  const Box2 box = bounds(polygon.points);
  const Vec2 size = box.size();
  translate(polygon, box.low * -1);
  constexpr double touch = 1e-9;
  if (box.low.x > touch) shape.corner_left = 180;
  if (box.high.x < shape.scope.size.x - touch) shape.corner_right = 180;
  const double old_depth = shape.scope.size.z;
  const Vec3 low =
      shape.ground ? Vec3{box.low.x, 0, old_depth - box.high.y} : Vec3{box.low.x, box.low.y, 0};
  shape.scope.origin = shape.scope.at(low);
  shape.scope.size = shape.ground ? Vec3{size.x, shape.scope.size.y, size.y}
                                  : Vec3{size.x, size.y, shape.scope.size.z};
  // A rectangle has no tags of its edges: only polygons whose edges are like the face become one.
  const auto like_the_face = [&](EdgeTag t) {
    return ((t.flags ^ shape.tag.flags) & ~EdgeTag::cut) == 0;
  };
  if (!shape.ground && shape.form == Form::polygon && is_axis_rectangle(polygon, 1e-9) &&
      std::ranges::all_of(polygon.tags, like_the_face)) {
    shape.form = Form::rectangle;
    shape.geometry = Shape::none;
    return;
  }
  shape.geometry = polygons_.take();
  polygons_[shape.geometry].polygon = std::move(polygon);
  polygons_[shape.geometry].natural = size;
}

void Machine::adopt(Shape& shape, Mesh&& mesh) {
  const Box3 box = bounds(mesh.points);
  shape.scope.origin = shape.scope.at(box.low);
  shape.scope.size = box.size();
  shape.form = Form::mesh;
  shape.ground = false;
  shape.geometry = add_mesh(std::move(mesh));
}

uint32_t Machine::add_mesh(Mesh&& mesh) {
  const uint32_t number = meshes_.take();
  PooledMesh& pooled = meshes_[number];
  pooled.own = std::move(mesh);
  pooled.borrowed = nullptr;
  const Box3 box = bounds(pooled.own.points);
  pooled.low = box.low;
  pooled.natural = box.size();
  return number;
}

uint32_t Machine::borrow_mesh(const Mesh& mesh) {
  const uint32_t number = meshes_.take();
  PooledMesh& pooled = meshes_[number];
  pooled.borrowed = &mesh;
  const Box3 box = bounds(mesh.points);
  pooled.low = box.low;
  pooled.natural = box.size();
  return number;
}

void Machine::frame_uvs(Shape& shape) { add_frame(shape, frame_on(shape.scope)); }

void Machine::add_frame(Shape& shape, UvFrame frame) {
  shape.uv_frame = frame.number = static_cast<uint32_t>(uv_frames.size());
  uv_frames.push_back(frame);
}

Derivation::Derivation(const Program& program, MeshSource& meshes, const DeriveOptions& options)
    : machine_(std::make_unique<Machine>(program, meshes, options)) {}
Derivation::~Derivation() = default;
void Derivation::derive(const Footprint& footprint, Building& building) {
  machine_->derive(footprint, building);
}

}  // namespace mansard
