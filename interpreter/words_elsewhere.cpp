#include "interpreter/words_elsewhere.hpp"

#include <algorithm>
#include <array>

namespace mansard {
namespace {

struct Elsewhere {
  std::string_view name, here;
};

constexpr std::array names{
    Elsewhere{"gable", "roof(\"gable\", pitch)"},
    Elsewhere{"hip", "roof(\"hip\", pitch)"},
    Elsewhere{"i", "insert(\"mesh.obj\")"},
    Elsewhere{"I", "insert(\"mesh.obj\")"},
    Elsewhere{"primitiveCube", "box()"},
    Elsewhere{"cube", "box()"},
    Elsewhere{"primitiveQuad", "quad()"},
    Elsewhere{"primitiveCylinder", "cylinder()"},
    Elsewhere{"primitiveSphere", "sphere()"},
    Elsewhere{"primitiveCone", "cone()"},
    Elsewhere{"translate", "t(x, y, z)"},
    Elsewhere{"T", "t(x, y, z)"},
    Elsewhere{"rotate", "r(x, y, z), in degrees"},
    Elsewhere{"R", "r(x, y, z), in degrees"},
    Elsewhere{"scale", "s(x, y, z), the new size"},
    Elsewhere{"S", "s(x, y, z), the new size"},
    Elsewhere{"rotateScope", "r(x, y, z), in degrees"},
    Elsewhere{"alignScopeToAxes", "align(\"axes\")"},
    Elsewhere{"alignScopeToGeometry", "align(\"geometry\")"},
    Elsewhere{"mirrorScope", "mirror(\"x\")"},
    Elsewhere{"innerRect", "inner_rectangle() { inside : A | rest : B }"},
    Elsewhere{"innerRectangle", "inner_rectangle() { inside : A | rest : B }"},
    Elsewhere{"setbackPerEdge", "setback(distance, edges) { kept : A | strip : B }"},
    Elsewhere{"setupProjection", "texture(\"picture.png\", u, v), u and v metres for one repeat"},
    Elsewhere{"projectUV", "texture(\"picture.png\", u, v), u and v metres for one repeat"},
    Elsewhere{"subdivide", "subdiv(axis, sizes) { A | B }"},
    Elsewhere{"Subdiv", "subdiv(axis, sizes) { A | B }"},
    Elsewhere{"component", "comp { side : A | top : B }"},
    Elsewhere{"components", "comp { side : A | top : B }"},
    Elsewhere{"faces", "comp { side : A | top : B }"},
    Elsewhere{
        "inset",
        "detrude(depth) { inner : A | reveal : B } into a wall, offset(distance) on the ground"},
    Elsewhere{"recess", "detrude(depth) { inner : A | reveal : B }"},
    Elsewhere{"extrusion", "extrude(height) { A }"},
    Elsewhere{"deleteFaces", "comp { … : NIL }"},
};

}  // namespace

std::string_view operation_elsewhere(std::string_view name) {
  const auto it = std::ranges::find(names, name, &Elsewhere::name);
  return it == names.end() ? std::string_view{} : it->here;
}

}  // namespace mansard
