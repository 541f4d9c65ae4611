// The functions of expressions: one row each, as for operations.
#pragma once

#include <array>
#include <span>
#include <string_view>

#include "interpreter/signature.hpp"

namespace mansard {

class Machine;
struct Shape;

/// What a function may look at besides its arguments.
struct FunctionCall {
  Machine& machine;
  std::span<const Value> args;
  uint64_t draw = 0;             ///< random bits of this place
  uint32_t node = 0;             ///< the call, for messages
  const Shape* shape = nullptr;  ///< null where no shape may be read
};

/// What a function needs that only a round of waiting shapes knows.
enum class Asks : uint8_t {
  nothing,
  others,   ///< solids around the shape
  group,    ///< the shapes that are answered with it
  outcome,  ///< what came of an alternative: in the score of best() only
};

struct Function {
  std::string_view name, args, summary, example;
  Value (*invoke)(const FunctionCall&) = nullptr;
  std::array<Parameter, max_parameters> parameters{};
  uint8_t count = 0, required = 0;
  bool variadic = false;
  bool random = false;
  bool each = false;  ///< evaluates its first argument itself, for each shape of the group
  Asks asks = Asks::nothing;

  std::string_view parameter_name(std::size_t i) const { return name_of(args, i); }
};

std::span<const Function> functions();
const Function* find_function(std::string_view name);

}  // namespace mansard
