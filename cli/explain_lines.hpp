// The lines that a member has on the page of its style. Private to cli/explain*.cpp.
#pragma once

#include <string>
#include <vector>

#include "cli/explain.hpp"

namespace mansard {

/// What somebody gives, and where.
struct MemberLine {
  std::string label;  ///< the member's name on the first line; then "hides", "super", "set()" …
  std::string what;
  std::string who;    ///< a style, "--set" or "property"
  std::string where;  ///< "house.style:12"
  std::string share;  ///< "30%"
  bool in_force = false;
};

/// What is in force first, then what is not, the most derived first.
std::vector<MemberLine> lines_of(const Explained& explained, const Story& story);
std::vector<MemberLine> element_lines(const Explained& explained, const Story& symbol);
std::vector<MemberLine> material_lines(const Explained& explained, const Story& symbol);

}  // namespace mansard
