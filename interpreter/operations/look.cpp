// Colour, texture and stains: inherited by all that is derived from the shape.
#include <algorithm>
#include <array>
#include <cmath>

#include "interpreter/component.hpp"
#include "interpreter/messages.hpp"
#include "interpreter/operations/functions.hpp"
#include "interpreter/picture.hpp"
#include "interpreter/selectors.hpp"
#include "interpreter/stains.hpp"

namespace mansard {
namespace {

void choose_look(Context& c, const Material& look) {
  c.shape.material = c.machine.add_material(look);
  c.shape.look_by = c.machine.expanding;
}

}  // namespace

namespace operation {

void color(Context& c, std::string_view text) {
  Material look = c.machine.material(c.shape.material);
  if (!parse_color(text, look.color)) {
    c.fail(0, "\"" + std::string(text) + "\" is no colour",
           "\"#445566\", \"#456\", or a CSS colour name such as \"slategray\"");
  }
  look.name = "color_" + std::string(text.starts_with('#') ? text.substr(1) : text);
  if (!look.texture.empty()) look.name += "_" + look.texture.substr(look.texture.rfind('/') + 1);
  choose_look(c, look);
}

void texture(Context& c, std::string_view file, std::optional<double> u, std::optional<double> v) {
  Material look = c.machine.material(c.shape.material);
  const double wide = u.value_or(1), high = v.value_or(wide);
  if (wide <= 0) c.fail(1, "a repeat of a texture covers more than 0 m, not " + number_text(wide));
  if (high <= 0) c.fail(2, "a repeat of a texture covers more than 0 m, not " + number_text(high));
  FoundPicture found = find_picture(file, c.at(0), c.machine.program, c.machine.mesh_source);
  if (found.problem) {
    const bool computed = c.machine.program.nodes[c.call.args[0].value].kind != ExprKind::constant;
    return computed ? c.machine.warn(std::move(*found.problem)) : void();  // else said before
  }
  look.texture = std::move(found.path);
  look.color = {1, 1, 1};
  look.metres = {wide, high};
  look.name = "texture_" + std::string(file.substr(file.rfind('/') + 1));
  choose_look(c, look);
}

/// The alternative is drawn here, once for all that is derived from the shape.
void material(Context& c, Value name) {
  const Program& program = c.machine.program;
  std::optional<uint32_t> symbol;
  if (name.type == Type::symbol) symbol = name.symbol;
  if (name.type == Type::string) symbol = program.symbols.find(name.string());
  if (name.type != Type::symbol && name.type != Type::string)
    c.wrong_type(0, name, "the name of an entry of Materials");
  const CompiledStyle& style = program.styles[c.shape.style];
  if (!symbol || style.materials[*symbol] == none) {
    const std::string word(symbol ? program.symbols[*symbol] : name.string());
    c.fail(0, "style '" + std::string(style.name) + "' has no materials for '" + word + "'",
           "write them in its block Materials { " + word + " : color(\"tan\") }");
  }
  c.shape.material = c.machine.draw_material(style.materials[*symbol], c.shape);
  c.shape.look_by = c.machine.expanding;
}

/// Turned, the repeats are counted along the turned directions over all of the shape's scope.
void uv(Context& c, std::optional<double> across, std::optional<double> up, Option<double> turn) {
  if (!is_flat(c.shape)) {
    c.machine.fail(c.call.at, "'uv' needs a flat shape, this one is a solid or has no surface",
                   "take its faces first: comp { side : A | top : B }");
  }
  if (across && !up) {
    c.fail(0, "'uv' takes the repeats across and those up, or none",
           "uv(1, 1) shows the whole picture once");
  }
  if (across && !(*across > 0))
    c.fail(0, "there are more than 0 repeats, not " + number_text(*across));
  if (up && !(*up > 0)) c.fail(1, "there are more than 0 repeats, not " + number_text(*up));
  const Shape face = c.shape.ground ? lying_face(c.shape) : c.shape;
  const Vec3 size = face.scope.size;
  const double angle = turn.value_or(0) * 3.14159265358979323846 / 180;
  const Vec2 u{std::cos(angle), std::sin(angle)}, v = left_of(u);
  // Where the scope's corners lie along u and v.
  Vec2 low{}, high{};
  for (const Vec2 corner : {Vec2{size.x, 0}, Vec2{size.x, size.y}, Vec2{0, size.y}}) {
    const Vec2 at{dot(corner, u), dot(corner, v)};
    low = {std::min(low.x, at.x), std::min(low.y, at.y)};
    high = {std::max(high.x, at.x), std::max(high.y, at.y)};
  }
  const Vec2 extent = high - low;
  const auto in_space = [&](Vec2 d) { return face.scope.direction({d.x, d.y, 0}); };
  const Vec2 corner = u * low.x + v * low.y;
  Vec3 along = in_space(u), upwards = in_space(v);
  if (across && extent.x > 0 && extent.y > 0) {
    along = along * (*across / extent.x);
    upwards = upwards * (*up / extent.y);
  }
  UvFrame frame{face.scope.at({corner.x, corner.y, 0}), along, upwards, face.scope.z};
  frame.in_repeats = across.has_value();
  c.machine.add_frame(c.shape, frame);
}

void stain(Context& c, double rate) {
  if (!is_stain_rate(rate)) c.fail(0, wrong_stain_rate(rate), std::string(stain_rate_help));
  const std::array said{Value::of(rate), Value::of(double(c.shape.depth))};
  const Value kept = Value::of(std::span(c.machine.keep(said), said.size()));
  c.machine.settings.push_back({stain_setting, c.shape.settings, kept});
  c.shape.settings = static_cast<uint32_t>(c.machine.settings.size() - 1);
}

}  // namespace operation
}  // namespace mansard
