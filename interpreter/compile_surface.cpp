// What a surface looks like: the words of Materials.
#include <algorithm>
#include <array>
#include <functional>
#include <set>

#include "interpreter/compiler.hpp"
#include "interpreter/messages.hpp"
#include "interpreter/picture.hpp"

namespace mansard {

const Value& Compiler::literal(const syntax::Arg& arg) {
  uint16_t salt = 0;
  NameScope scope{program_.main_style, {}, {}, none, false, false, &salt};
  const ExprId id = plain_argument(arg, scope);
  const ExprNode& node = program_.nodes[id];
  if (node.kind != ExprKind::constant)
    refuse(arg.at, "in Materials stand plain strings and numbers");
  return program_.constants[node.first];
}

std::string Compiler::picture(std::string_view file, Span at) {
  FoundPicture found = find_picture(file, at, program_, meshes_);
  if (found.problem) diagnostics_.add(std::move(*found.problem));
  return std::move(found.path);
}

namespace {

/// A look as it stands in the script.
struct Said {
  const syntax::Emit& look;
  std::vector<Value> values;
  std::function<std::string(std::string_view, Span)> picture;  ///< path, empty when unusable

  std::string name() const { return std::string(look.name.text); }
  bool is(std::size_t i, Type type) const { return i < values.size() && values[i].type == type; }
  /// The value's own characters, else those of the brackets.
  Span at(std::size_t i) const {
    if (i < values.size()) return (*look.args)[i].at;
    return look.args_at ? look.args_at : look.name.at;
  }
  std::string file(std::size_t i) const { return picture(values[i].string(), at(i)); }
};

/// From one value to `most`, all behind the first numbers.
void take(const Said& said, std::size_t most, Type first, std::string_view what,
          std::string_view example) {
  const auto wrong = [&](std::size_t i) {
    refuse(said.at(i), said.name() + "() takes " + std::string(what), std::string(example));
  };
  if (!said.is(0, first)) wrong(0);
  if (said.values.size() > most) wrong(most);
  for (std::size_t i = 1; i < said.values.size(); ++i)
    if (!said.is(i, Type::number)) wrong(i);
}

/// The number at `i`, from 0 to 1; 1 when it is left out behind a file.
double share(const Said& said, std::size_t i) {
  if (i > 0 && i >= said.values.size()) return 1;
  if (!said.is(i, Type::number) || !(said.values[i].number >= 0 && said.values[i].number <= 1))
    refuse(said.at(i), said.name() + "() takes a number between 0 and 1");
  return said.values[i].number;
}

/// Metres across and up, of which the second may be left out.
Vec2 metres_of(const Said& said, std::size_t first) {
  for (std::size_t i = first; i < said.values.size(); ++i) {
    if (!(said.values[i].number > 0))
      refuse(said.at(i), "a repeat of a texture covers more than 0 m");
  }
  const double across = said.values[first].number;
  return {across, first + 1 < said.values.size() ? said.values[first + 1].number : across};
}

void color(const Said& said, Material& material) {
  if (said.values.size() == 1 && said.is(0, Type::string) &&
      parse_color(said.values[0].string(), material.color))
    return;
  refuse(said.look.args_at ? said.look.args_at : said.look.name.at,
         "color() takes \"#rgb\", \"#rrggbb\" or a CSS colour name",
         "for instance color(\"#445566\") or color(\"slategray\")");
}

void texture(const Said& said, Material& material) {
  take(said, 3, Type::string, "a file and the metres of one repeat",
       "texture(\"brick.jpg\", 2, 1)");
  material.texture = said.file(0);
  if (!material.texture.empty()) material.color = {1, 1, 1};
  if (said.values.size() > 1) material.metres = metres_of(said, 1);
}

void metres(const Said& said, Material& material) {
  take(said, 2, Type::number, "the metres of one repeat, across and up", "metres(2, 1)");
  material.metres = metres_of(said, 0);
}

void opacity(const Said& said, Material& material) {
  if (said.values.size() > 1) refuse(said.at(1), "opacity() takes a number between 0 and 1");
  material.opacity = share(said, 0);
}

/// roughness() and metallic(): a number, or a picture and what it is multiplied by.
void scaled(const Said& said, double& factor, std::string& map) {
  const bool is_file = said.is(0, Type::string);
  if (!is_file && said.values.size() > 1)
    refuse(said.at(1), said.name() + "() takes a number, or a file and a number",
           said.name() + "(\"brick.png\", 0.8)");
  take(said, 2, is_file ? Type::string : Type::number, "a number between 0 and 1, or a file",
       said.name() + "(0.4) or " + said.name() + "(\"brick.png\")");
  factor = share(said, is_file ? 1 : 0);
  if (is_file) map = said.file(0);
}

void roughness(const Said& said, Material& material) {
  scaled(said, material.finish.roughness, material.finish.roughness_map);
}

void metallic(const Said& said, Material& material) {
  scaled(said, material.finish.metallic, material.finish.metallic_map);
}

void normals(const Said& said, Material& material) {
  take(said, 2, Type::string, "a file and how strong its relief is",
       "normals(\"brick_normal.png\", 1)");
  const double relief = said.values.size() > 1 ? said.values[1].number : 1;
  if (!(relief >= 0 && relief <= 10))
    refuse(said.at(1), "the relief of a normals() picture is from 0 to 10");
  material.finish.relief = relief;
  material.finish.normal_map = said.file(0);
}

struct Word {
  std::string_view name;
  void (*apply)(const Said&, Material&);
};
constexpr std::array<Word, 7> words{{{"color", color},
                                     {"texture", texture},
                                     {"metres", metres},
                                     {"opacity", opacity},
                                     {"roughness", roughness},
                                     {"metallic", metallic},
                                     {"normals", normals}}};

}  // namespace

Material Compiler::material_of(const syntax::MaterialAlternative& alternative, std::string name) {
  Material material = program_.materials[0];
  material.name = std::move(name);
  std::set<std::string_view> known;
  Span scaled_by;  // texture(), when it gives the metres of a repeat
  for (const syntax::Emit& look : alternative.looks) {
    const auto* const word = std::ranges::find(words, look.name.text, &Word::name);
    if (word == words.end()) {
      refuse(look.name.at, "'" + std::string(look.name.text) + "' is no look of this version",
             "color(), texture(), metres(), opacity(), roughness(), metallic() or normals()");
    }
    if (!known.insert(word->name).second) {
      refuse(look.name.at, "a second " + std::string(word->name) + "() for the same surface",
             "write a '|' between alternatives: color(\"tan\") | color(\"gray\")");
    }
    Said said{look, {}, [this](std::string_view file, Span at) { return picture(file, at); }};
    if (look.args) {
      for (const syntax::Arg& arg : *look.args) said.values.push_back(literal(arg));
    }
    const bool scales =
        word->name == "metres" || (word->name == "texture" && said.values.size() > 1);
    if (scales && scaled_by) {
      Diagnostic d;
      d.at = look.name.at;
      d.text = "the metres of a repeat are said twice: the pictures of a surface repeat together";
      d.notes.push_back({"here for the first time", scaled_by});
      throw Failure(std::move(d));
    }
    if (scales) scaled_by = look.name.at;
    word->apply(said, material);
  }
  return material;
}

}  // namespace mansard
