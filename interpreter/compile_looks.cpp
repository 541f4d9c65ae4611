// Elements and materials.
#include <algorithm>

#include "interpreter/compiler.hpp"
#include "interpreter/messages.hpp"
#include "interpreter/random.hpp"

namespace mansard {

double Compiler::weight(const syntax::ExprPtr& source, uint16_t) {
  if (!source) return 1;
  const auto* number = std::get_if<syntax::Number>(&source->is);
  if (!number || number->value < 0) refuse(source->at, "a weight is a number that is not negative");
  return number->value;
}

void Compiler::compile_elements(uint16_t number) {
  for (const ElementBinding& binding : program_.styles[number].linked->elements) {
    attempt(number, "Elements", [&] {
      ElementTable table;
      for (const ElementChoice& alternative : binding.alternatives) {
        element_choice(alternative, table);
        table.choices.back().weight = weight(alternative.syntax->weight, number);
        table.total += table.choices.back().weight;
      }
      const uint32_t symbol = program_.symbols.intern(binding.symbol);
      CompiledStyle& style = program_.styles[number];
      if (style.elements.size() <= symbol) style.elements.resize(symbol + 1, none);
      if (table.choices.empty() || table.total <= 0) return;
      style.elements[symbol] = static_cast<uint32_t>(program_.element_tables.size());
      program_.element_tables.push_back(std::move(table));
    });
  }
}

void Compiler::element_choice(const ElementChoice& alternative, ElementTable& table) {
  ElementTable::Choice choice;
  for (const syntax::ExprPtr& path : alternative.syntax->meshes) {
    const auto& text = std::get<syntax::Text>(path->is).value;
    const Mesh* const mesh = element_mesh(text, path->at);
    choice.meshes.push_back(mesh);
    auto& looks = choice.materials.emplace_back();
    if (!mesh) continue;
    for (const Mesh::Material& own : mesh->materials) {
      looks.push_back(static_cast<uint32_t>(program_.materials.size()));
      program_.materials.push_back(material_from(own));
    }
  }
  table.choices.push_back(std::move(choice));
}

/// The file as named, beside the script and on the style path; then the same stem as .obj and .glb.
const Mesh* Compiler::element_mesh(const std::string& path, Span at) {
  std::vector<std::string> folders{Library::folder_of(at)};
  folders.insert(folders.end(), library_.style_path().begin(), library_.style_path().end());
  const std::size_t dot = path.rfind('.'), slash = path.rfind('/');
  const std::string stem =
      slash != path.npos && dot != path.npos && dot < slash ? path : path.substr(0, dot);
  std::string problem = "no such file", last;
  for (const std::string& name : {path, stem + ".obj", stem + ".glb"}) {
    for (const std::string& folder : folders) {
      const std::string full = path.starts_with('/') || folder.empty() ? name : folder + "/" + name;
      if (!library_.files().exists(full)) continue;
      if (const Mesh* mesh = meshes_.mesh(full, problem)) return mesh;
      last = full;
    }
  }
  Diagnostic d;
  d.severity = Severity::warning;
  d.code = "W008";
  d.at = at;
  d.text = "mesh \"" + path + "\" can not be read: " + problem +
           (last.empty() || last == path ? "" : " (" + last + ")");
  d.help = "its terminal stays plain; a file of the same name with .obj or .glb would be taken too";
  diagnostics_.add(std::move(d));
  return nullptr;
}

/// The same alternative is the same material in every heir; names are numbered until they are free.
uint32_t Compiler::material_number(const MaterialChoice& choice, std::string_view symbol) {
  const auto [known, fresh] = material_numbers_.try_emplace(choice.syntax, 0);
  if (!fresh) return known->second;
  const std::string base = std::string(choice.from.style->name.text) + "." + std::string(symbol);
  std::string name = base;
  const auto taken = [&](const Material& m) { return m.name == name; };
  for (int i = 2; std::ranges::any_of(program_.materials, taken); ++i) {
    name = base + "." + std::to_string(i);
  }
  Material material = material_of(*choice.syntax, name);
  known->second = static_cast<uint32_t>(program_.materials.size());
  program_.materials.push_back(std::move(material));
  return known->second;
}

void Compiler::compile_materials(uint16_t number) {
  for (const MaterialBinding& binding : program_.styles[number].linked->materials) {
    attempt(number, "Materials", [&] {
      MaterialTable table;
      for (std::size_t i = 0; i < binding.alternatives.size(); ++i) {
        const MaterialChoice& choice = binding.alternatives[i];
        table.materials.push_back(material_number(choice, binding.symbol));
        table.weights.push_back(weight(choice.syntax->weight, number));
        table.total += table.weights.back();
      }
      if (table.materials.empty()) return;
      if (table.total <= 0) {
        refuse(binding.alternatives.back().syntax->weight->at,
               "the weights of '" + std::string(binding.symbol) +
                   "' add up to 0: none of them is ever drawn",
               "give one of them more than 0, or leave the weights away");
      }
      const auto* per = binding.entry && binding.entry->per
                            ? std::get_if<syntax::Text>(&binding.entry->per->is)
                            : nullptr;
      if (per && per->value == "building") {
        table.per = VariableSlot::Per::building;
      } else if (per && per->value != "shape") {
        table.per = VariableSlot::Per::symbol;
        table.per_symbol = program_.symbols.intern(per->value);
      }
      table.salt = hash_of(binding.symbol);
      const uint32_t symbol = program_.symbols.intern(binding.symbol);
      CompiledStyle& style = program_.styles[number];
      if (style.materials.size() <= symbol) style.materials.resize(symbol + 1, none);
      style.materials[symbol] = static_cast<uint32_t>(program_.material_tables.size());
      program_.material_tables.push_back(std::move(table));
    });
  }
}

}  // namespace mansard
