// Colour and texture: inherited by all that is derived from the shape.
#include "interpreter/messages.hpp"
#include "interpreter/operations/functions.hpp"
#include "interpreter/picture.hpp"
#include "interpreter/selectors.hpp"

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
  look.texture = find_picture(file, c.at(0), c.machine.program, c.machine.mesh_source);
  if (look.texture.empty()) {
    const bool computed = c.machine.program.nodes[c.call.args[0].value].kind != ExprKind::constant;
    return computed ? c.machine.warn(missing_picture(file, c.at(0))) : void();  // else said before
  }
  look.color = {1, 1, 1};
  look.metres = {wide, high};
  look.name = "texture_" + std::string(file.substr(file.rfind('/') + 1));
  choose_look(c, look);
}

}  // namespace operation
}  // namespace mansard
