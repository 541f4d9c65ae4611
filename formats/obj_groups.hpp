// The order of one building's surfaces in an OBJ.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "geometry/mesh.hpp"

namespace mansard {

/// Sorts the runs of a building by symbol and look, each in the order of first appearance, so that
/// the caller's numbers leave no trace in the file. Keeps its memory from building to building.
class ObjGroups {
 public:
  void sort(std::span<const Surface::Run> runs);

  /// Calls symbol(number), look(number) and run(number) in order.
  template <class Symbol, class Look, class Run>
  void for_each(Symbol symbol, Look look, Run run) const {
    for (const Group& head : groups_) {
      if (!head.is_head) continue;
      symbol(head.symbol);
      for (const Group* g = &head;; g = &groups_[g->next]) {
        look(g->material);
        for (uint32_t r = g->first; r != none; r = next_run_[r]) run(r);
        if (g->next == none) break;
      }
    }
  }

 private:
  static constexpr uint32_t none = 0xffffffff;
  struct Group {
    uint32_t symbol, material;
    uint32_t first, last;  ///< runs
    uint32_t next = none;  ///< group of the same symbol
    bool is_head = true;   ///< the first of its symbol
  };

  uint32_t find_or_add(const Surface::Run& run);

  std::vector<Group> groups_;
  std::vector<uint32_t> heads_;     ///< a symbol's first group
  std::vector<uint32_t> next_run_;  ///< of the same group
};

}  // namespace mansard
