// Which variables and functions anything reads. Private to the warnings of `check`.
#pragma once

#include <set>
#include <string>
#include <utility>
#include <vector>

#include "interpreter/program.hpp"

namespace mansard {

/// Reads of productions that are in force or reached by `super`, of variables by others, and of
/// functions by others. Symbols that nothing reaches read too: they have a warning of their own.
class Reads {
 public:
  explicit Reads(const Program& program);

  /// Whether, in any style that inherits from this one, the variable or function of this name
  /// ("Block.Name") is read.
  bool variable(const syntax::Style& style, const std::string& name) const {
    return variables_.contains({&style, name});
  }
  bool function(const syntax::Style& style, const std::string& name) const {
    return functions_.contains({&style, name});
  }

  // For Walk.
  void step(const Step&) {}
  void expression(ExprId expr);

 private:
  const Program& program_;
  std::vector<bool> read_, called_;         ///< by slot
  uint32_t reader_ = none, caller_ = none;  ///< the variable or function being walked
  std::set<std::pair<const syntax::Style*, std::string>> variables_, functions_;
};

}  // namespace mansard
