#include "interpreter/variable_order.hpp"

#include <algorithm>

#include "interpreter/compiler.hpp"
#include "interpreter/messages.hpp"

namespace mansard {

namespace {

void collect_reads(const Program& program, ExprId id, std::vector<uint32_t>& reads) {
  const ExprNode& node = program.nodes[id];
  if (node.kind == ExprKind::variable) reads.push_back(node.first);
  for (uint32_t i = 0; i < node.count; ++i) {
    collect_reads(program, program.children[node.children + i], reads);
  }
}

/// Attributes, and what may read them.
bool reads_shape_itself(const Program& program, ExprId id) {
  const ExprNode& node = program.nodes[id];
  if (node.kind == ExprKind::attribute || node.kind == ExprKind::fits ||
      node.kind == ExprKind::definition || is_question(node)) {
    return true;
  }
  for (uint32_t i = 0; i < node.count; ++i) {
    if (reads_shape_itself(program, program.children[node.children + i])) return true;
  }
  return false;
}

}  // namespace

VariableGraph::VariableGraph(const Program& program) : reads_(program.variables.size()) {
  for (std::size_t slot = 0; slot < reads_.size(); ++slot) {
    const ExprId value = program.variables[slot].value;
    if (value == none) continue;
    std::vector<uint32_t>& reads = reads_[slot];
    collect_reads(program, value, reads);
    std::ranges::sort(reads);
    reads.erase(std::unique(reads.begin(), reads.end()), reads.end());
  }
}

std::vector<std::vector<uint32_t>> VariableGraph::groups() const {
  // Tarjan's with a stack of its own: a script may chain tens of thousands of variables.
  struct Visit {
    uint32_t slot;
    std::size_t next = 0;
  };
  std::vector<uint32_t> number(reads_.size(), none), low(reads_.size(), 0), open;
  std::vector<bool> is_open(reads_.size(), false);
  std::vector<std::vector<uint32_t>> groups;
  std::vector<Visit> path;
  uint32_t count = 0;
  const auto enter = [&](uint32_t slot) {
    number[slot] = low[slot] = count++;
    open.push_back(slot);
    is_open[slot] = true;
    path.push_back({slot});
  };
  const auto leave = [&](uint32_t slot) {
    if (low[slot] == number[slot]) {
      const auto first = std::ranges::find(open.rbegin(), open.rend(), slot).base() - 1;
      groups.emplace_back(first, open.end());
      open.erase(first, open.end());
      for (const uint32_t member : groups.back()) is_open[member] = false;
      std::ranges::sort(groups.back());
    }
    path.pop_back();
    if (!path.empty()) low[path.back().slot] = std::min(low[path.back().slot], low[slot]);
  };
  for (uint32_t root = 0; root < reads_.size(); ++root) {
    if (number[root] == none) enter(root);
    while (!path.empty()) {
      Visit& at = path.back();
      if (at.next == reads_[at.slot].size()) {
        leave(at.slot);
        continue;
      }
      const uint32_t read = reads_[at.slot][at.next++];
      if (number[read] == none) {
        enter(read);
      } else if (is_open[read]) {
        low[at.slot] = std::min(low[at.slot], number[read]);
      }
    }
  }
  return groups;
}

std::vector<uint32_t> VariableGraph::ring_from(uint32_t slot) const {
  std::vector<uint32_t> from(reads_.size(), none), queue{slot};
  for (std::size_t i = 0; i < queue.size(); ++i) {
    for (const uint32_t read : reads_[queue[i]]) {
      if (from[read] != none) continue;
      from[read] = queue[i];
      queue.push_back(read);
      if (read != slot) continue;
      std::vector<uint32_t> ring;
      for (uint32_t at = from[slot]; at != slot; at = from[at]) ring.push_back(at);
      ring.push_back(slot);
      std::ranges::reverse(ring);
      return ring;
    }
  }
  return {};
}

/// A variable reads the shape if its expression does, directly or through others.
void Compiler::find_shape_readers() {
  const VariableGraph graph(program_);
  constexpr std::size_t deepest = 3000;  // levels of expressions, as when they are evaluated
  std::vector<std::size_t> levels(program_.variables.size(), 0);
  for (const std::vector<uint32_t>& group : graph.groups()) {
    const uint32_t slot = group.front();
    if (group.size() > 1 || std::ranges::binary_search(graph.read_by(slot), slot)) {
      attempt_anywhere([&] { refuse_ring(graph, slot); });
      continue;
    }
    VariableSlot& v = program_.variables[slot];
    v.reads_shape = v.settable || v.per != VariableSlot::Per::building;
    if (v.value == none) continue;
    if (reads_shape_itself(program_, v.value)) v.reads_shape = true;
    std::size_t below = 0;
    for (const uint32_t read : graph.read_by(slot)) {
      below = std::max(below, levels[read]);
      if (program_.variables[read].reads_shape) v.reads_shape = true;
    }
    levels[slot] = below + program_.depths[v.value] + 1u;
    if (levels[slot] <= deepest || below > deepest) continue;  // said where it grows too deep
    attempt_anywhere([&] {
      refuse(v.binding->syntax->at,
             "variable '" + v.name + "' stands on a chain of other variables that is too deep: " +
                 std::to_string(levels[slot]) + " levels, " + std::to_string(deepest) + " allowed",
             "put several steps of the chain into one expression");
    });
  }
}

/// One error a ring, at its first variable; a script full of rings gets no more than fifty.
void Compiler::refuse_ring(const VariableGraph& graph, uint32_t slot) {
  constexpr int most_rings = 50;
  if (++rings_ > most_rings) return;
  const std::vector<uint32_t> ring = graph.ring_from(slot);
  constexpr std::size_t most_notes = 5;
  std::vector<Note> notes;
  for (std::size_t i = 1; i < ring.size() && i <= most_notes; ++i) {
    const VariableSlot& v = program_.variables[ring[i]];
    notes.push_back({"it reads '" + v.name + "'", v.binding->syntax->name.at});
  }
  if (ring.size() > most_notes + 1) {
    notes.push_back({"and so on, through " + count_text(ring.size() - 1, "variable"), {}});
  }
  const VariableSlot& first = program_.variables[slot];
  refuse(first.binding->syntax->at, "variable '" + first.name + "' is defined by itself", {},
         std::move(notes));
}

}  // namespace mansard
