// Which solids a question is about.
#pragma once

#include <array>
#include <string_view>

#include "interpreter/machine.hpp"

namespace mansard {

inline constexpr std::array<std::string_view, 4> occluder_sets{"all", "noparent", "active",
                                                               "neighbours"};

class SolidSet {
 public:
  /// `word` is one of occluder_sets, or a label.
  SolidSet(const Machine& machine, const Shape& asking, std::string_view word);

  /// Whether a solid of the world belongs.
  bool has(uint32_t solid) const;
  /// Whether the buildings around do.
  bool has_neighbours() const {
    return kind_ == Kind::all || kind_ == Kind::noparent || kind_ == Kind::neighbours;
  }

 private:
  enum class Kind : uint8_t { all, noparent, active, neighbours, label };
  const Machine& machine_;
  const Shape& asking_;
  Kind kind_;
  uint32_t label_ = Shape::none;
};

}  // namespace mansard
