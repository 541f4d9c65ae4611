// What the variables of a style are worth in one building, before there is any shape: for
// `mansard explain` and editors.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "interpreter/footprint.hpp"
#include "interpreter/program.hpp"

namespace mansard {

/// What a value depends on.
struct Dependence {
  bool shape = false;      ///< the shape: another value at each use
  bool random = false;     ///< draws: another value for each seed
  bool abstract = false;   ///< a variable that a child has to give first
  bool footprint = false;  ///< properties of the footprint
  bool set = false;        ///< a variable that some rule says set() for
};

struct VariableValue {
  enum class Giver : uint8_t { style, property, command_line };
  Giver giver = Giver::style;
  /// What --set and the footprint's property of this name say, as it stands there, when they are
  /// given: also a property that is too weak or can not be taken.
  std::optional<std::string> command_line, property;
  Dependence dependence;  ///< of the value in force
  /// As a script would write it; nothing when it depends on the shape or can not be evaluated.
  std::optional<std::string> value;
  std::string problem;    ///< why it can not be, or why a property was not taken
  bool settable = false;  ///< some rule says set() for it, which is stronger than a property
};

/// Of the program's main style. The program and the footprint must outlive it.
class BuildingValues {
 public:
  /// `footprint` needs no outline.
  BuildingValues(const Program& program, const Footprint& footprint, uint64_t seed);
  ~BuildingValues();

  /// Nothing when the style has no such variable. `block` empty: a style-wide one.
  std::optional<VariableValue> variable(std::string_view block, std::string_view name);
  /// The weight that stands behind a rule of the main style, 1 when none does. Nothing when it
  /// depends on the shape or can not be evaluated.
  std::optional<double> weight(const syntax::Rule& rule);

 private:
  class Evaluator;
  std::unique_ptr<Evaluator> evaluator_;
};

}  // namespace mansard
