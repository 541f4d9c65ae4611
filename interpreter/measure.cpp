#include "interpreter/measure.hpp"

#include <algorithm>
#include <cmath>

#include "interpreter/context.hpp"
#include "interpreter/function.hpp"
#include "interpreter/messages.hpp"

namespace mansard {
namespace {

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
constexpr double aligned = 1 - 1e-9;  ///< cosine

Vec3 axis_of(const Scope& scope, Axis axis) {
  return axis == Axis::x ? scope.x : axis == Axis::y ? scope.y : scope.z;
}

}  // namespace

NaturalSize operator+(const NaturalSize& a, const NaturalSize& b) {
  return {a.minimum + b.minimum, a.preferred + b.preferred, a.maximum + b.maximum};
}

NaturalSize longest(const NaturalSize& a, const NaturalSize& b) {
  const double preferred = std::max(a.preferred, b.preferred);
  return {std::max(a.minimum, b.minimum), preferred,
          std::max(preferred, std::min(a.maximum, b.maximum))};
}

void Measurer::Result::add(const NaturalSize& natural, const Piece& piece) {
  ++met;
  if (piece.lost || !natural.is_known()) return;
  const auto above = [&](double v) { return v * piece.scale + piece.more; };
  size = longest(size, {above(natural.minimum), above(natural.preferred), above(natural.maximum)});
}

/// What is empty, or NIL throughout, takes no room.
NaturalSize Measurer::Result::all() const { return met == 0 ? NaturalSize::exactly(0) : size; }

void Measurer::reset() {
  reads_.clear();
  known_.clear();
  open_.clear();
  depth_ = 0;
  shapes_ = 0;
}

/// Holds what the machine and the pass are about, while something else is measured. After a failure
/// it leaves all as it is, for the message; the building is lost then.
class Measurer::Enter {
 public:
  Enter(Measurer& measurer, Vec3 direction, Axis letter, Span at)
      : pass_(measurer),
        direction_(measurer.direction_),
        letter_(measurer.letter_),
        measuring_(measurer.machine_.measuring) {
    pass_.direction_ = direction;
    pass_.letter_ = letter;
    pass_.open_.push_back(at);
    pass_.machine_.measuring = true;
  }
  void leave() {
    pass_.open_.pop_back();
    pass_.direction_ = direction_;
    pass_.letter_ = letter_;
    pass_.machine_.measuring = measuring_;
  }

 private:
  Measurer& pass_;
  Vec3 direction_;
  Axis letter_;
  bool measuring_;
};

/// The shape with its size and place along the axis unknown. Flat ones count as rectangles: where
/// it will be cut is not known.
Measurer::Piece Measurer::unknown(const Shape& whole, Axis axis) const {
  Piece piece{whole};
  Shape& shape = piece.shape;
  along(shape.scope.size, axis) = nothing;
  const Vec3 direction = axis_of(shape.scope, axis);
  for (const Axis a : {Axis::x, Axis::y, Axis::z}) {
    if (std::abs(along(direction, a)) > 1e-12) along(shape.scope.origin, a) = nothing;
  }
  if (shape.form == Form::polygon && !shape.ground) shape.form = Form::rectangle;
  return piece;
}

NaturalSize Measurer::part(Context& c, const CallPart& part, const Shape& whole, Axis axis,
                           Span at) {
  Piece piece = unknown(whole, axis);
  Shape& shape = piece.shape;
  if (axis == Axis::x) {  // what it has beside it are parts of the same wall
    if (shape.split_index > 0) shape.corner_left = 180;
    if (shape.split_index + 1 < shape.split_count && shape.split_count != Shape::none)
      shape.corner_right = 180;
  }
  const Scope frame = shape.scope;
  const Env env{&shape, c.env.parameters, mix(c.env.draws, mix(c.call.salt, shape.split_index)),
                &frame};
  Enter enter(*this, axis_of(whole.scope, axis), axis, at);
  const Machine::Apart numbered(machine_, c.stream_of(part, shape));
  Result result;
  body(part.body, piece, env, result);
  enter.leave();
  return result.all();
}

NaturalSize Measurer::shape(const Shape& whole, Axis axis, Span at) {
  Piece piece = unknown(whole, axis);
  Enter enter(*this, axis_of(whole.scope, axis), axis, at);
  const NaturalSize natural = symbol(piece.shape, at);
  enter.leave();
  return natural;
}

/// The axis of unknown size that lies along what is measured.
std::optional<Axis> Measurer::open_axis(const Shape& shape) const {
  for (const Axis axis : {Axis::x, Axis::y, Axis::z}) {
    if (std::isnan(along(shape.scope.size, axis)) &&
        std::abs(dot(axis_of(shape.scope, axis), direction_)) > aligned)
      return axis;
  }
  return std::nullopt;
}

/// Of a shape whose size is known, or that lies askew.
NaturalSize Measurer::extent(const Shape& shape) const {
  double length = 0;
  for (const Axis axis : {Axis::x, Axis::y, Axis::z}) {
    const double share = std::abs(dot(axis_of(shape.scope, axis), direction_));
    if (share > 1e-9) length += share * along(shape.scope.size, axis);
  }
  return std::isnan(length) ? NaturalSize{} : NaturalSize::exactly(length);
}

NaturalSize Measurer::symbol(Shape& child, Span at) {
  const std::optional<Axis> axis = open_axis(child);
  if (!axis) return extent(child);
  const uint32_t rule_set = machine_.rules_of(child);
  if (rule_set == none) return terminal(child, *axis);
  const uint64_t key = key_of(child, *axis);
  const uint32_t before = machine_.reads;
  if (const auto read = reads_.find(key); read != reads_.end()) {
    const auto known = known_.find(mix(key, read_of(child, read->second)));
    if (known != known_.end()) {
      machine_.reads |= read->second;
      return known->second;
    }
  }
  deeper(at);
  machine_.reads = 0;
  const NaturalSize natural = rules(child, rule_set);
  --depth_;
  const uint32_t all = reads_[key] |= machine_.reads;
  known_[mix(key, read_of(child, all))] = natural;
  machine_.reads |= before;
  return natural;
}

void Measurer::deeper(Span at) {
  constexpr int deepest = 400;
  if (++depth_ > deepest || ++shapes_ > machine_.options.max_shapes) {
    Diagnostic d;
    d.at = at;
    d.text = "measuring a size ':' comes to no end: more than " +
             (depth_ > deepest ? std::to_string(deepest) + " shapes deep"
                               : std::to_string(machine_.options.max_shapes) + " shapes");
    d.help = "does a rule call itself without end? give the part a size";
    refuse(std::move(d));
  }
}

/// As the derivation would, under a node of its own for the while.
NaturalSize Measurer::rules(Shape& child, uint32_t rule_set) {
  Machine& m = machine_;
  const uint32_t expanding = m.expanding, current = m.current_rules_;
  const Production* const production = m.production;
  const std::size_t supers = static_cast<std::size_t>(m.super_depth_);
  m.nodes_.push_back({child.node, child.symbol, child.seed});
  child.node = m.expanding = static_cast<uint32_t>(m.nodes_.size() - 1);
  m.super_depth_ = 0;
  NaturalSize natural;
  {
    const Machine::Apart numbered(m, child.seed);
    Piece piece{child};
    const Scope frame = piece.shape.scope;
    Env env{&piece.shape, child.arguments, child.seed, &frame};
    Result result;
    rewrite(rule_set, piece, env, result);
    if (result.emitted == 0) {  // it stays a terminal of its symbol
      const auto axis = open_axis(piece.shape);
      result.add(axis ? terminal(piece.shape, *axis) : extent(piece.shape), piece);
    }
    natural = result.all();
  }
  m.nodes_.pop_back();
  m.expanding = expanding;
  m.current_rules_ = current;
  m.production = production;
  m.super_depth_ = static_cast<int>(supers);
  return natural;
}

void Measurer::rewrite(uint32_t rule_set, Piece& piece, Env& env, Result& result) {
  Machine& m = machine_;
  const RuleSet& rules = m.program.rule_sets[rule_set];
  const Production* const before = m.production;
  const uint32_t rules_before = m.current_rules_;
  const Production* const chosen = m.choose(rules, piece.shape, env);
  m.production = chosen ? chosen : before;
  if (!chosen) return;  // said when it is derived
  m.current_rules_ = rule_set;
  m.bind_index(*chosen, rules, piece.shape, env);
  body(chosen->body, piece, env, result);
  m.production = before;
  m.current_rules_ = rules_before;
}

void Measurer::body(BodyId id, Piece& piece, const Env& env, Result& result) {
  const Body& body = machine_.program.bodies[id];
  for (uint32_t i = body.first; i < body.first + body.count; ++i) {
    const Step& s = machine_.program.steps[i];
    step(s, piece, Env{&piece.shape, env.parameters, env.draws, env.frame}, result);
  }
}

void Measurer::step(const Step& s, Piece& piece, const Env& env, Result& result) {
  switch (s.kind) {
    case StepKind::emit:
    case StepKind::emit_value:
      return emit(s, piece, env, result);
    case StepKind::operation:
      return operation(machine_.program.calls[s.what], piece, env, result);
    case StepKind::push: {
      Piece inner = piece;
      return body(s.what, inner, env, result);
    }
    case StepKind::super:
      return super(piece, env, result);
    case StepKind::branch:
      for (const BranchArm& arm : machine_.program.branches[s.what].arms) {
        if (arm.condition != none && !machine_.condition(arm.condition, env)) continue;
        return body(arm.body, piece, env, result);
      }
  }
}

void Measurer::emit(const Step& s, Piece& piece, const Env& env, Result& result) {
  uint32_t symbol = s.what, style = s.style == 0xffff ? piece.shape.style : s.style;
  if (s.kind == StepKind::emit_value) {
    const Value value = machine_.emitted_symbol(s, env);
    symbol = value.symbol;
    style = value.size > 0 ? value.size - 1 : piece.shape.style;
  } else if (s.kind == StepKind::super) {
    symbol = machine_.nodes_[machine_.expanding].symbol;
  }
  ++result.emitted;
  if (symbol == nil_symbol) return;
  if (piece.lost) {
    machine_.next_seed(symbol);
    return result.add({}, piece);
  }
  Shape child = piece.shape;
  machine_.make_child(s, symbol, style, env, child);
  const uint32_t rules = machine_.rules_of(child);
  if (rules != none) machine_.check_arguments(s, machine_.program.rule_sets[rules], child);
  child.node = machine_.expanding;
  result.add(this->symbol(child, s.at), piece);
}

void Measurer::super(Piece& piece, const Env& env, Result& result) {
  Machine& m = machine_;
  const uint32_t next = m.program.rule_sets[m.current_rules_].super;
  const std::size_t before = result.emitted;
  Piece inner = piece;
  Step plain;
  plain.kind = StepKind::super;
  Env inside{&inner.shape, env.parameters, mix(env.draws, hash_of("super")), env.frame};
  if (next != none) {
    deeper(m.program.productions[m.program.rule_sets[next].first].syntax->head);
    rewrite(next, inner, inside, result);
    --depth_;
  }
  if (result.emitted == before) emit(plain, inner, inside, result);
}

/// Elements have the size of their mesh, in metres; the nearest one's whatever level of detail is
/// asked for, so that the splits do not depend on it.
NaturalSize Measurer::terminal(const Shape& shape, Axis axis) {
  const uint32_t number = machine_.program.styles[shape.style].elements[shape.symbol];
  if (number == none) return {};
  const ElementTable& table = machine_.program.element_tables[number];
  if (table.choices.empty() || shape.form == Form::line) return {};
  if (table.choices.size() > 1) machine_.reads |= read_bits::chance;
  const ElementTable::Choice& choice = Machine::choose_element(table, shape);
  const auto mesh = std::ranges::find_if(choice.meshes, [](const Mesh* m) { return m != nullptr; });
  if (mesh == choice.meshes.end()) return {};
  const auto [at, fresh] = mesh_sizes_.try_emplace(*mesh);
  if (fresh) at->second = bounds((*mesh)->points).size();
  return NaturalSize::exactly(along(at->second, axis));
}

}  // namespace mansard
