// What operations do to a length that is being measured.
#include <algorithm>
#include <array>
#include <cmath>

#include "interpreter/component.hpp"
#include "interpreter/measure.hpp"
#include "interpreter/operations/functions.hpp"

namespace mansard {

enum class Measurer::Effect : uint8_t {
  hides,    ///< nothing is known of what it makes
  keeps,    ///< lengths; it may go on in a part
  stands,   ///< likewise, in each of its parts
  first,    ///< in its first part, of the same outline
  sets,     ///< a variable
  resizes,  ///< s()
  turns,
  offsets,
  extrudes,
  inserts,
  splits,
  tries,  ///< its parts, to their ends: best()
};

Measurer::Measurer(Machine& machine) : machine_(machine) {
  using enum Effect;
  struct Known {
    std::string_view name;
    Effect effect;
  };
  constexpr Known rows[] = {
      {"subdiv", splits}, {"repeat", splits},  {"split", splits},     {"s", resizes},
      {"r", turns},       {"offset", offsets}, {"extrude", extrudes}, {"insert", inserts},
      {"set", sets},      {"detrude", first},  {"cut", stands},       {"box", keeps},
      {"quad", keeps},    {"cylinder", keeps}, {"sphere", keeps},     {"cone", keeps},
      {"t", keeps},       {"center", keeps},   {"mirror", keeps},     {"pivot", keeps},
      {"color", keeps},   {"texture", keeps},  {"label", keeps},      {"occluder", keeps},
      {"report", keeps},  {"print", keeps},    {"fail", keeps},       {"best", tries},
      {"snap", keeps},    {"material", keeps}, {"uv", keeps}};
  for (const Operation& operation : operations()) {
    const auto* row = std::ranges::find(rows, operation.name, &Known::name);
    effects_.push_back(row == std::end(rows) ? hides : row->effect);
  }
}

void Measurer::operation(const Call& call, Piece& held, const Env& env, Result& result) {
  const Effect effect = effects_[static_cast<std::size_t>(call.operation - operations().data())];
  if (effect == Effect::keeps && !call.has_parts) return;
  Piece inner = held;
  Piece& piece = call.has_parts ? inner : held;
  const Env inside{&piece.shape, env.parameters, env.draws, env.frame};
  Context c(machine_, call, piece.shape, inside);
  if (effect == Effect::sets) return call.operation->invoke(c);
  if (call.has_parts && (piece.lost || effect == Effect::hides || !open_axis(piece.shape))) {
    ++result.emitted;
    return result.add(extent(piece.shape), piece);
  }
  switch (effect) {
    case Effect::hides:
      piece.lost = true;
      break;
    case Effect::keeps:
    case Effect::sets:
      break;
    case Effect::stands:
    case Effect::first:
      for (std::size_t i = 0; i < call.part_of.size(); ++i) {
        if (call.part_of[i] == none) continue;
        if (i == 0 || effect == Effect::stands)
          on_part(c, call.parts[call.part_of[i]], 0, piece, result);
        if (i > 0) ++result.emitted;
      }
      return;
    case Effect::resizes:
      resize(call, piece, inside);
      break;
    case Effect::turns:
      turn(call, piece, inside);
      break;
    case Effect::offsets:
      return offset(c, piece, result);
    case Effect::extrudes:
      extrude(call, piece, inside);
      break;
    case Effect::inserts:
      insert(call, piece, inside);
      break;
    case Effect::splits:
      return split(c, piece, result);
    case Effect::tries:
      refuse_question(call.at);
      break;
  }
  if (call.has_parts) on_part(c, call.parts[0], 0, piece, result);
}

/// The i-th piece that the operation makes of it.
void Measurer::on_part(Context& c, const CallPart& part, std::size_t i, Piece piece,
                       Result& result) {
  const Scope frame = piece.shape.scope;
  const Env env{&piece.shape, c.env.parameters, mix(c.env.draws, mix(c.call.salt, i)), &frame};
  std::optional<Machine::Apart> numbered;
  if (c.call.measures) numbered.emplace(machine_, c.stream_of(part, piece.shape));
  body(part.body, piece, env, result);
}

/// NaN when it depends on what is measured.
double Measurer::known(ExprId expr, const Env& env) {
  try {
    return machine_.number(expr, env);
  } catch (const UnknownLength&) {
    return std::numeric_limits<double>::quiet_NaN();
  }
}

/// A length that depends on the unknown one, W in s(W, 0.1, 0.2), is taken for all of it.
void Measurer::resize(const Call& call, Piece& piece, const Env& env) {
  const std::optional<Axis> open = open_axis(piece.shape);
  for (const Axis axis : {Axis::x, Axis::y, Axis::z}) {
    const SizeExpr& arg = call.args[static_cast<std::size_t>(axis)];
    const double value = known(arg.value, env);
    double& size = along(piece.shape.scope.size, axis);
    const bool share = arg.kind == syntax::SizeKind::percent;
    if (share && axis == open && value > 0) {
      piece.scale /= value / 100;
    } else if (share) {
      size *= value / 100;
    } else if (!std::isnan(value)) {
      size = value;
    }
  }
}

void Measurer::turn(const Call& call, Piece& piece, const Env& env) {
  for (const SizeExpr& arg : call.args)
    piece.lost = piece.lost || std::isnan(known(arg.value, env));
  if (piece.lost) return;
  Context c(machine_, call, piece.shape, env);
  call.operation->invoke(c);
  if (!open_axis(piece.shape)) piece.lost = std::isnan(extent(piece.shape).preferred);
}

/// Only what decides its lengths; at every level of detail.
void Measurer::extrude(const Call& call, Piece& piece, const Env& env) {
  const double height = known(call.args[0].value, env);
  Shape& shape = piece.shape;
  if (!shape.ground && shape.scope.z.y > 0.7071) shape = standing_ground(shape);
  (shape.ground ? shape.scope.size.y : shape.scope.size.z) = height;
  const bool plain = shape.form == Form::rectangle;
  shape.form = plain ? Form::box : Form::prism;
  if (plain) shape.ground = false;
}

/// Of a rectangle, by all its edges; the border is as long as the whole.
void Measurer::offset(Context& c, Piece& piece, Result& result) {
  const double distance = known(c.call.args[0].value, c.env);
  ++result.emitted;
  const bool plain = piece.shape.form == Form::rectangle && !c.given(1) && distance > 0;
  if (!plain || !c.wants(0)) return result.add({}, piece);
  piece.shape.scope.size = piece.shape.scope.size - Vec3{2 * distance, 2 * distance, 0};
  piece.more += 2 * distance * piece.scale;
  on_part(c, c.call.parts[c.call.part_of[0]], 0, piece, result);
}

/// A mesh that is fitted prefers its own size, like an element.
void Measurer::insert(const Call& call, Piece& piece, const Env& env) {
  Context c(machine_, call, piece.shape, env);
  operation::put_mesh(c, c.take<std::string_view>(0),
                      taker<std::optional<std::string_view>>::take(c, 1));
  const Vec3 natural = machine_.mesh_of(piece.shape).natural;
  if (const auto open = open_axis(piece.shape))
    along(piece.shape.scope.size, *open) = along(natural, *open);
}

}  // namespace mansard
