#include "cli/order_drawing.hpp"

#include <algorithm>
#include <array>

namespace mansard {

namespace {

constexpr uint32_t nobody = 0xffffffff;

enum Side : unsigned { up = 1, down = 2, left = 4, right = 8 };
constexpr std::array<std::string_view, 16> strokes{" ", "╵", "╷", "│", "╴", "╯", "╮", "┤",
                                                   "╶", "╰", "╭", "├", "─", "┴", "┬", "┼"};

/// Every lane waits for a style that some dot above it named as a parent; no two for the same.
class Lanes {
 public:
  std::string dot(uint32_t place) {
    at_ = lane_of(place);
    std::string text;
    for (std::size_t i = 0; i < waiting_.size(); ++i) {
      if (i > 0) text += ' ';
      text += i == at_ ? "●" : waiting_[i] == nobody ? " " : "│";
    }
    waiting_[at_] = nobody;
    return without_end(std::move(text));
  }

  /// From the last dot down to its parents; empty when a straight line does it.
  std::string to_parents(const std::vector<uint32_t>& parents) {
    const std::vector<uint32_t> before = waiting_;
    std::vector<std::size_t> targets;
    targets.reserve(parents.size());
    for (const uint32_t parent : parents) targets.push_back(lane_of(parent));
    if (targets.empty() || (targets.size() == 1 && targets[0] == at_)) return {};
    const auto [first, last] = std::ranges::minmax(targets);
    const std::size_t low = std::min(first, at_), high = std::max(last, at_);
    std::string text;
    for (std::size_t i = 0; i < waiting_.size(); ++i) {
      unsigned sides = 0;
      if (i == at_ || (i < before.size() && before[i] != nobody)) sides |= up;
      if (waiting_[i] != nobody) sides |= down;
      if (i > low && i <= high) sides |= left;
      if (i >= low && i < high) sides |= right;
      text += strokes[sides];
      text += (sides & right) != 0 ? "─" : " ";
    }
    return without_end(std::move(text));
  }

 private:
  /// The lane that waits for it, or a free one: the dot's own if it can be, else to the right.
  std::size_t lane_of(uint32_t place) {
    if (const auto found = std::ranges::find(waiting_, place); found != waiting_.end())
      return static_cast<std::size_t>(found - waiting_.begin());
    const auto from =
        waiting_.begin() + static_cast<std::ptrdiff_t>(std::min(at_, waiting_.size()));
    const auto free = std::find(from, waiting_.end(), nobody);
    const auto lane = static_cast<std::size_t>(free - waiting_.begin());
    if (free == waiting_.end()) waiting_.push_back(nobody);
    waiting_[lane] = place;
    return lane;
  }

  static std::string without_end(std::string text) {
    text.erase(text.find_last_not_of(' ') + 1);
    return text;
  }

  std::vector<uint32_t> waiting_;
  std::size_t at_ = 0;  ///< lane of the last dot
};

std::string name_of(const syntax::Style& style) { return std::string(style.name.text); }

}  // namespace

std::vector<DrawnLine> drawn_order(const std::vector<Standing>& standings) {
  Lanes lanes;
  std::vector<DrawnLine> lines;
  for (uint32_t place = 0; place < standings.size(); ++place) {
    lines.push_back({lanes.dot(place), &standings[place]});
    if (std::string between = lanes.to_parents(standings[place].parents); !between.empty())
      lines.push_back({std::move(between), nullptr});
  }
  return lines;
}

std::string why(const std::vector<Standing>& standings, std::size_t place) {
  const Standing& standing = standings[place];
  if (standing.chooser) {
    const bool itself = standing.second == standing.style;
    return name_of(*standing.chooser) + " names " + name_of(*standing.first) + " before " +
           (itself ? "it" : name_of(*standing.second));
  }
  constexpr std::size_t most_named = 3;
  std::string text;
  const std::size_t heirs = standing.heirs.size(), named = std::min(heirs, most_named);
  for (std::size_t i = 0; i < named; ++i) {
    const bool last = i + 1 == heirs;
    text += i == 0 ? "parent of " : last ? " and " : ", ";
    text += name_of(*standings[standing.heirs[i]].style);
  }
  if (heirs > named) text += " and " + std::to_string(heirs - named) + " more";
  return text;
}

}  // namespace mansard
