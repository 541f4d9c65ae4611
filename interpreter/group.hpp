// What a shape asks about those that are answered with it: group.any, group.best and their like.
// A group are the shapes of one symbol and style that wait for the same round, all of a building or
// those below one ancestor; so a rule decides for all of them at once (the events of CGA++, Schwarz
// and Mueller 2015, as expressions).
#pragma once

#include <deque>
#include <optional>
#include <string_view>
#include <vector>

#include "interpreter/function.hpp"
#include "interpreter/shape.hpp"

namespace mansard {

enum class Gather : uint8_t { any, all, count, sum, most, least, rank, best };

/// Shapes that are answered in one round, each as it was when it began to wait.
class Meeting {
 public:
  std::vector<Shape> shapes;
  uint32_t current = 0;  ///< which of them is being rewritten

  /// Keeps its memory from round to round.
  void open() { shapes.clear(), used_ = current = 0; }
  /// What the current shape's group makes of the expression (none: 1 for each); below its nearest
  /// ancestor of the symbol `within`, or in the whole building where that is none or there is none.
  double gather(Machine& machine, Gather how, uint32_t expr, uint32_t within);

 private:
  struct Tally {
    Gather how = Gather::any;
    uint32_t expr = 0, within = 0, rules = 0;
    bool known = false;      ///< counted to the end
    std::vector<double> of;  ///< by shape
  };
  struct Member {
    uint32_t root, shape;
    double value;
  };

  static void reduce(Gather how, std::vector<Member>& members, std::vector<double>& of);

  std::deque<Tally> tallies_;
  std::size_t used_ = 0;
};

using Within = std::optional<std::string_view>;

Value group_any(const FunctionCall& call, Each<bool> each, Within within);
Value group_all(const FunctionCall& call, Each<bool> each, Within within);
Value group_count(const FunctionCall& call, Each<bool> each, Within within);
Value group_sum(const FunctionCall& call, Each<double> each, Within within);
Value group_max(const FunctionCall& call, Each<double> each, Within within);
Value group_min(const FunctionCall& call, Each<double> each, Within within);
Value group_rank(const FunctionCall& call, Each<double> each, Within within);
Value group_best(const FunctionCall& call, Each<double> each, Within within);

}  // namespace mansard
