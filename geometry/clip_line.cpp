#include "geometry/clip_line.hpp"

#include <algorithm>
#include <cmath>

namespace mansard {
namespace {

/// A maximal walk along kept edges, from where it leaves the line to where it comes back.
struct Chain {
  uint32_t begin, end;  // into Cutter::walked
  std::size_t next = 0;
};

/// One end of a chain. Just below the line, pieces lie between a start and the next end to the
/// right of it.
struct ChainEnd {
  double along;
  double lean;  // how far to the right the boundary moves for each metre away from the line
  std::size_t chain;
  bool start;
};

class Cutter {
 public:
  Cutter(std::span<const double> side, std::span<const double> along, double tolerance)
      : side_(side), along_(along), tolerance_(tolerance), kept_(side.size()) {}

  void walk_ring(uint32_t begin, uint32_t end);
  LineCut finish();

 private:
  bool mark_kept(uint32_t begin, uint32_t end);
  void start_chain(uint32_t from, uint32_t to);
  void end_chain(uint32_t from, uint32_t to);
  double along_of(CutCorner corner, uint32_t to) const;
  double lean(uint32_t inner, double position) const;
  void pair_ends();
  void pair_cluster(std::span<ChainEnd> cluster);
  void emit_loop(std::size_t first, std::vector<bool>& used);

  std::span<const double> side_, along_;
  double tolerance_;
  std::vector<bool> kept_;
  std::vector<CutCorner> walked_;
  std::vector<Chain> chains_;
  std::vector<ChainEnd> ends_;
  std::vector<std::size_t> open_starts_, open_ends_;
  LineCut result_;
};

/// Points below the line are kept. A run of points on the line is kept when the interior lies below
/// it (it runs to the left), or when it is a mere touch from below. False when nothing is kept.
bool Cutter::mark_kept(uint32_t begin, uint32_t end) {
  const uint32_t n = end - begin;
  uint32_t first = begin;
  while (first < end && side_[first] == 0) ++first;
  if (first == end) return false;
  bool any = false;
  for (uint32_t step = 0; step < n;) {
    const auto at = [&](uint32_t s) { return begin + (first - begin + s) % n; };
    if (side_[at(step)] != 0) {
      kept_[at(step)] = side_[at(step)] < 0;
      any = any || kept_[at(step)];
      ++step;
      continue;
    }
    uint32_t last = step;
    while (side_[at(last + 1)] == 0) ++last;
    const double moved = along_[at(last)] - along_[at(step)];
    const bool below = side_[at(step + n - 1)] < 0 && side_[at(last + 1)] < 0;
    const bool touch = below && std::abs(moved) <= tolerance_;
    const bool faces = moved < -tolerance_;
    for (; step <= last; ++step) kept_[at(step)] = touch || faces;
    any = any || touch || faces;
  }
  return any;
}

void Cutter::walk_ring(uint32_t begin, uint32_t end) {
  if (end - begin < 3 || !mark_kept(begin, end)) return;
  uint32_t first = begin;
  while (first < end && kept_[first]) ++first;
  if (first == end) {
    for (uint32_t i = begin; i < end; ++i) result_.corners.push_back({i});
    result_.loop_ends.push_back(static_cast<uint32_t>(result_.corners.size()));
    return;
  }
  const uint32_t n = end - begin;
  for (uint32_t step = 0; step < n; ++step) {
    const uint32_t from = begin + (first - begin + step) % n;
    const uint32_t to = begin + (first - begin + step + 1) % n;
    if (!kept_[from] && kept_[to]) start_chain(from, to);
    if (kept_[from]) walked_.push_back({from});
    if (kept_[from] && !kept_[to]) end_chain(from, to);
  }
}

void Cutter::start_chain(uint32_t from, uint32_t to) {
  const auto begin = static_cast<uint32_t>(walked_.size());
  double position = along_[to];  // a kept run on the line starts with itself
  if (side_[to] < 0) {
    const CutCorner corner{from, side_[from] > 0};
    walked_.push_back(corner);
    position = along_of(corner, to);
  }
  ends_.push_back({position, lean(to, position), chains_.size(), true});
  chains_.push_back({begin, begin});
}

void Cutter::end_chain(uint32_t from, uint32_t to) {
  double position = along_[from];
  if (side_[from] < 0) {
    const CutCorner corner = side_[to] > 0 ? CutCorner{from, true} : CutCorner{to};
    walked_.push_back(corner);
    position = corner.crossing ? along_of(corner, to) : along_[to];
  }
  ends_.push_back({position, lean(from, position), chains_.size() - 1, false});
  chains_.back().end = static_cast<uint32_t>(walked_.size());
}

double Cutter::along_of(CutCorner corner, uint32_t to) const {
  if (!corner.crossing) return along_[corner.edge];
  const double t = side_[corner.edge] / (side_[corner.edge] - side_[to]);
  return along_[corner.edge] + (along_[to] - along_[corner.edge]) * t;
}

double Cutter::lean(uint32_t inner, double position) const {
  return side_[inner] < 0 ? (along_[inner] - position) / -side_[inner] : 0;
}

LineCut Cutter::finish() {
  pair_ends();
  std::vector<bool> used(chains_.size());
  for (std::size_t c = 0; c < chains_.size(); ++c) {
    if (!used[c]) emit_loop(c, used);
  }
  return std::move(result_);
}

void Cutter::pair_ends() {
  if (chains_.size() == 1) return;  // linked to itself
  std::stable_sort(ends_.begin(), ends_.end(),
                   [](const ChainEnd& a, const ChainEnd& b) { return a.along < b.along; });
  for (std::size_t i = 0; i < ends_.size();) {
    std::size_t j = i + 1;
    while (j < ends_.size() && ends_[j].along - ends_[i].along <= tolerance_) ++j;
    pair_cluster({ends_.data() + i, ends_.data() + j});
    i = j;
  }
}

/// Ends at one point of the line: their order just below it, but with starts and ends taking turns.
void Cutter::pair_cluster(std::span<ChainEnd> cluster) {
  std::stable_sort(cluster.begin(), cluster.end(),
                   [](const ChainEnd& a, const ChainEnd& b) { return a.lean < b.lean; });
  for (auto next = cluster.begin(); next != cluster.end(); ++next) {
    const bool want_start = open_starts_.empty();
    const auto wanted =
        std::find_if(next, cluster.end(), [&](const ChainEnd& e) { return e.start == want_start; });
    if (wanted != cluster.end()) std::rotate(next, wanted, wanted + 1);
    if (next->start) {
      open_starts_.push_back(next->chain);
    } else {
      open_ends_.push_back(next->chain);
    }
    // Rings that cross themselves leave more than one open; every end still finds a start.
    if (!open_starts_.empty() && !open_ends_.empty()) {
      chains_[open_ends_.back()].next = open_starts_.back();
      open_ends_.pop_back();
      open_starts_.pop_back();
    }
  }
}

void Cutter::emit_loop(std::size_t first, std::vector<bool>& used) {
  std::size_t c = first;
  do {
    used[c] = true;
    const Chain& chain = chains_[c];
    result_.corners.insert(result_.corners.end(), walked_.begin() + chain.begin,
                           walked_.begin() + chain.end);
    result_.corners.back().cut_follows = true;
    c = chain.next;
  } while (!used[c]);
  result_.loop_ends.push_back(static_cast<uint32_t>(result_.corners.size()));
}

/// How many of a hole's corners and edge middles lie in a ring.
int votes(std::span<const Vec2> hole, const Polygon& outline) {
  int count = 0;
  for (std::size_t i = 0; i < hole.size(); ++i) {
    count += contains(outline, hole[i]);
    count += contains(outline, mix(hole[i], hole[(i + 1) % hole.size()], 0.5));
  }
  return count;
}

void append_ring(Polygon& to, const Polygon& from, std::size_t ring) {
  for (uint32_t i = from.ring_begin(ring); i < from.ring_ends[ring]; ++i) {
    to.add_point(from.points[i], from.tags[i]);
  }
  to.close_ring();
}

double ring_length(std::span<const Vec2> ring) {
  double sum = 0;
  for (std::size_t i = 0; i < ring.size(); ++i)
    sum += length(ring[(i + 1) % ring.size()] - ring[i]);
  return sum;
}

}  // namespace

LineCut cut_by_line(std::span<const double> side, std::span<const double> along,
                    std::span<const uint32_t> ring_ends, double tolerance) {
  Cutter cutter(side, along, tolerance);
  uint32_t begin = 0;
  for (const uint32_t end : ring_ends) {
    cutter.walk_ring(begin, end);
    begin = end;
  }
  return cutter.finish();
}

std::vector<Polygon> assemble(const Polygon& loops, double tolerance) {
  std::vector<Polygon> pieces;
  std::vector<std::size_t> holes;
  for (std::size_t r = 0; r < loops.rings(); ++r) {
    const auto ring = loops.ring(r);
    const double size = area(ring);
    if (ring.size() < 3 || 2 * std::abs(size) <= tolerance * ring_length(ring)) continue;
    if (size < 0) {
      holes.push_back(r);
    } else {
      append_ring(pieces.emplace_back(), loops, r);
    }
  }
  if (pieces.empty()) return pieces;
  // Holes are counted against bare outlines, before any hole is added to them.
  std::vector<std::size_t> owners(holes.size(), 0);
  for (std::size_t h = 0; h < holes.size() && pieces.size() > 1; ++h) {
    int best = 0;
    for (std::size_t p = 0; p < pieces.size(); ++p) {
      const int count = votes(loops.ring(holes[h]), pieces[p]);
      // Of nested outlines the inner one comes out with as many votes; it is the smaller.
      if (count < best || count == 0) continue;
      if (count == best && area(pieces[p]) > area(pieces[owners[h]])) continue;
      best = count;
      owners[h] = p;
    }
  }
  for (std::size_t h = 0; h < holes.size(); ++h) append_ring(pieces[owners[h]], loops, holes[h]);
  return pieces;
}

}  // namespace mansard
