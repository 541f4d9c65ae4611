// Which terminals shed rain, and what it leaves on the walls below.
#include "interpreter/stains.hpp"

#include <algorithm>
#include <cmath>

#include "interpreter/compiler.hpp"
#include "interpreter/machine.hpp"
#include "interpreter/messages.hpp"

namespace mansard {

std::string wrong_stain_rate(double rate) {
  return "a rate of staining is between 0 and 1, not " + number_text(rate);
}

namespace {

/// WINDOW_SILL and windowSill end in "sill".
bool ends_in(std::string_view name, std::string_view word) {
  if (name.size() < word.size()) return false;
  name.remove_prefix(name.size() - word.size());
  return std::ranges::equal(name, word, [](char a, char b) { return (a | 0x20) == b; });
}

bool is_named(std::string_view name, std::initializer_list<std::string_view> words) {
  return std::ranges::any_of(words, [&](std::string_view word) { return ends_in(name, word); });
}

}  // namespace

/// For all of the program, once: the look of stains, and what the names of symbols say.
void Compiler::prepare_stains() {
  const Operation* const stain = find_operation("stain");
  const auto call = std::ranges::find(program_.calls, stain, &Call::operation);
  if (call == program_.calls.end()) return;
  Material look;
  look.name = "stain";
  look.color = {0.13, 0.115, 0.10};
  look.stains = true;
  look.texture = picture("stains.png", call->at);
  if (look.texture.empty()) return;
  program_.stain_look = static_cast<uint32_t>(program_.materials.size());
  program_.materials.push_back(std::move(look));
  program_.stain_symbol = program_.symbols.intern("STAIN");
  for (uint32_t i = 0; i < program_.symbols.size(); ++i) {
    const std::string_view name = program_.symbols[i];
    program_.sheds_rain.push_back(is_named(name, {"sill", "ledge"}));
    program_.stays_clean.push_back(is_named(name, {"glass", "window", "door", "pane"}));
  }
}

void Compiler::check_stain(const Call& call) {
  if (call.operation != find_operation("stain")) return;
  const auto rate = constant_number(call.args[0].value);
  if (rate && !is_stain_rate(*rate)) {
    refuse(program_.spans[call.args[0].value], wrong_stain_rate(*rate),
           std::string(stain_rate_help));
  }
}

/// 0 for what sheds no rain. Sills and ledges do by their name, whatever stands out from its wall
/// where the very rule that emitted it says stain().
double Machine::stain_rate(const Shape& shape, uint32_t symbol) const {
  constexpr double relief = 0.01;  // metres
  for (uint32_t i = shape.settings; i != none; i = settings[i].next) {
    if (settings[i].setting != stain_setting) continue;
    const std::span<const Value> said = settings[i].value.list();
    const bool direct = shape.depth <= said[1].number + 1 && shape.scope.size.z >= relief;
    return direct || program.sheds_rain[symbol] ? said[0].number : 0;
  }
  return 0;
}

/// Of shapes that stand upright: what slopes sheds its water at one end.
void Machine::note_drip(const Shape& shape, uint32_t symbol) {
  if (lod < 3 || shape.form <= Form::line) return;
  const Scope& s = shape.scope;
  constexpr double upright = 0.9999;
  if (s.y.y < upright || (shape.ground && is_flat(shape))) return;
  const double rate = stain_rate(shape, symbol);
  if (!(rate > 0)) return;
  Vec3 from = s.origin, to = s.origin + s.x * s.size.x;
  if (mirrored(s)) std::swap(from, to);
  const double top = s.origin.y + s.size.y;
  reads |= read_bits::aloud;
  building->drips.push_back(
      {from, to, s.z, top, s.size.z, rate, mix(shape.seed, hash_of("stain"))});
}

/// Rain runs off panes, off what can be seen through and off elements.
bool Machine::takes_stains(const Surface::Run& run) const {
  if (program.stays_clean[run.symbol] || material(run.material).opacity < 1) return false;
  return std::ranges::none_of(program.styles, [&](const CompiledStyle& style) {
    return style.elements[run.symbol] != none;
  });
}

void Machine::draw_stains() {
  Surface& surface = building->surface;
  std::vector<uint32_t> walls;
  uint32_t polygon = 0;
  for (const Surface::Run& run : surface.runs) {
    const bool takes = takes_stains(run);
    for (; polygon < run.end; ++polygon) {
      if (takes) walls.push_back(polygon);
    }
  }
  add_streaks(surface, building->drips, walls, program.stain_symbol, program.stain_look);
}

}  // namespace mansard
