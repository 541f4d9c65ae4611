// From buildings to what writers and painters take.
#pragma once

#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "formats/footprints.hpp"
#include "formats/surface_writer.hpp"
#include "interpreter/building.hpp"
#include "interpreter/derivation.hpp"
#include "interpreter/program.hpp"
#include "render/picture.hpp"

namespace mansard {

/// One numbering of looks for all buildings: the program's materials first, then those that single
/// buildings bring, in their order.
class Looks {
 public:
  explicit Looks(const Program& program);
  /// Renumbers the runs of a building to this list.
  void adopt(Building& building);
  const std::vector<Look>& all() const { return looks_; }
  std::vector<Paint> paints() const;

 private:
  uint32_t number(const Material& material);

  std::size_t shared_;
  std::vector<Look> looks_;
  std::unordered_map<std::string, uint32_t> numbers_;
};

std::vector<std::string_view> symbol_names(const Program& program);
/// What stands in the head of a model: style, seed, and how to get back to the footprints' place.
std::string model_comment(const Program& program, const FootprintFacts& set,
                          const DeriveOptions& options);

/// sRGB to linear, per channel.
Vec3 linear(Vec3 srgb);
/// Glass by its name or because it can be seen through.
bool is_glass(std::string_view name, double opacity);

}  // namespace mansard
