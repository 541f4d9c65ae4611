// Which variables read which, and in what order they can be known. Private to the interpreter.
#pragma once

#include <cstdint>
#include <vector>

#include "interpreter/program.hpp"

namespace mansard {

/// The variables that each variable's expression reads, by slot. What functions read is not
/// followed: it is read anew at each call.
class VariableGraph {
 public:
  explicit VariableGraph(const Program& program);

  const std::vector<uint32_t>& read_by(uint32_t slot) const { return reads_[slot]; }

  /// Slots that read each other, directly or not, together; each group after all that it reads
  /// (Tarjan 1972). A slot alone is a group.
  std::vector<std::vector<uint32_t>> groups() const;

  /// A shortest way from a slot back to itself: the slots on it, the given one first. Empty when
  /// there is none.
  std::vector<uint32_t> ring_from(uint32_t slot) const;

 private:
  std::vector<std::vector<uint32_t>> reads_;
};

}  // namespace mansard
