#include "cli/output.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>

#include "formats/obj_names.hpp"

namespace mansard {
namespace {

Look look_of(const Material& m) {
  return {m.name, m.color, m.opacity, m.texture, m.finish, m.stains};
}

std::string key_of(const Material& m) {
  const Finish& f = m.finish;
  char text[240];
  std::snprintf(text, sizeof text, "|%.6f|%.6f|%.6f|%.6f|%.6f|%.6f|%.6f|", m.color.x, m.color.y,
                m.color.z, m.opacity, f.roughness, f.metallic, f.relief);
  return m.name + text + m.texture + "|" + f.roughness_map + "|" + f.metallic_map + "|" +
         f.normal_map;
}

}  // namespace

Looks::Looks(const Program& program) : shared_(program.materials.size()) {
  for (const Material& m : program.materials) looks_.push_back(look_of(m));
}

uint32_t Looks::number(const Material& material) {
  const auto [it, fresh] =
      numbers_.try_emplace(key_of(material), static_cast<uint32_t>(looks_.size()));
  if (!fresh) return it->second;
  Look look = look_of(material);
  const auto taken = [&](const std::string& name) {
    return std::ranges::any_of(looks_,
                               [&](const Look& l) { return safe_name(l.name) == safe_name(name); });
  };
  for (int i = 2; taken(look.name); ++i) look.name = material.name + "_" + std::to_string(i);
  looks_.push_back(std::move(look));
  return it->second;
}

void Looks::adopt(Building& building) {
  if (building.materials.empty()) return;
  std::vector<uint32_t> numbers;
  for (const Material& m : building.materials) numbers.push_back(number(m));
  for (Surface::Run& run : building.surface.runs) {
    if (run.material >= shared_) run.material = numbers[run.material - shared_];
  }
}

std::vector<std::string_view> symbol_names(const Program& program) {
  std::vector<std::string_view> names;
  for (uint32_t i = 0; i < program.symbols.size(); ++i) names.push_back(program.symbols[i]);
  return names;
}

std::string model_comment(const Program& program, const FootprintFacts& set,
                          const DeriveOptions& options) {
  return "style " + std::string(program.styles[program.main_style].name) + ", seed " +
         std::to_string(options.seed) + (set.origin.empty() ? "" : "\n" + set.origin);
}

Vec3 linear(Vec3 c) {
  const auto decode = [](double v) {
    return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
  };
  return {decode(c.x), decode(c.y), decode(c.z)};
}

bool is_glass(std::string_view name, double opacity) {
  std::string lower(name);
  std::ranges::transform(lower, lower.begin(),
                         [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return opacity < 1 || lower.find("glass") != std::string::npos ||
         lower.find("window") != std::string::npos;
}

std::vector<Paint> Looks::paints() const {
  std::vector<Paint> paints;
  for (const Look& l : looks_)
    paints.push_back({linear(l.color), is_glass(l.name, l.opacity), l.texture, l.finish,
                      linear(l.color), l.stains});
  return paints;
}

}  // namespace mansard
