#include "styles/standing.hpp"

#include <unordered_map>

namespace mansard {

namespace {

/// reaches[i][j]: the style at place i is that at j or inherits from it.
using Reach = std::vector<std::vector<bool>>;

/// A parent comes after all its heirs, so the order walked backwards knows the parents' answers.
Reach reach_of(const std::vector<Standing>& all) {
  Reach reach(all.size(), std::vector<bool>(all.size(), false));
  for (std::size_t i = all.size(); i-- > 0;) {
    reach[i][i] = true;
    for (const uint32_t parent : all[i].parents) {
      for (std::size_t j = 0; j < all.size(); ++j) {
        if (reach[parent][j]) reach[i][j] = true;
      }
    }
  }
  return reach;
}

/// The first parent after `from` that leads to an ancestor.
std::size_t leading_to(const Standing& style, const Reach& reach, std::size_t ancestor,
                       std::size_t from) {
  while (from < style.parents.size() && !reach[style.parents[from]][ancestor]) ++from;
  return from;
}

/// The most basic style that has both among its ancestors has named two parents that lead to them,
/// in this order: had it not, C3 would have taken them the other way round.
void explain(std::vector<Standing>& all, const Reach& reach, std::size_t place) {
  const std::size_t before = place - 1;
  if (reach[before][place]) return;
  std::size_t chooser = before;
  while (!reach[chooser][before] || !reach[chooser][place]) --chooser;  // the style itself has both
  const Standing& names = all[chooser];
  const std::size_t first = leading_to(names, reach, before, 0);
  const std::size_t second = leading_to(names, reach, place, first + 1);
  if (second >= names.parents.size()) return;
  all[place].chooser = names.style;
  all[place].first = all[names.parents[first]].style;
  all[place].second = all[names.parents[second]].style;
}

}  // namespace

std::vector<Standing> standings(const LinkedStyle& style) {
  std::vector<Standing> all(style.order.size());
  std::unordered_map<std::string_view, uint32_t> places;
  for (uint32_t i = 0; i < all.size(); ++i) {
    all[i].style = style.order[i];
    places.emplace(style.order[i]->name.text, i);
  }
  for (uint32_t i = 0; i < all.size(); ++i) {
    for (const syntax::Name& parent : all[i].style->parents) {
      const auto found = places.find(parent.text);
      if (found == places.end()) continue;
      all[i].parents.push_back(found->second);
      all[found->second].heirs.push_back(i);
    }
  }
  const Reach reach = reach_of(all);
  for (std::size_t place = 1; place < all.size(); ++place) explain(all, reach, place);
  return all;
}

}  // namespace mansard
