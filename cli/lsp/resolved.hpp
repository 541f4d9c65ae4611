// A style as `mansard explain` sees it: what its variables are worth, and the story of each member.
#pragma once

#include <memory>
#include <string>

#include "cli/lsp/meaning.hpp"
#include "interpreter/building_values.hpp"
#include "styles/story.hpp"

namespace mansard::lsp {

/// Where the command line and the footprint say nothing.
class Resolved {
 public:
  /// Null while the style, or one that it derives with, has errors.
  static std::unique_ptr<Resolved> of(Library& library, const syntax::Style& style);

  /// What to say of a variable's value; empty when the declaration says it already.
  std::string worth(const Meaning& variable);
  /// Null when the style has no such member.
  const Story* story(const Meaning& member) const;
  const Stories& stories() const { return stories_; }

 private:
  explicit Resolved(std::unique_ptr<Program> program);

  std::unique_ptr<Program> program_;
  const Footprint bare_;
  BuildingValues values_;
  Stories stories_;
};

}  // namespace mansard::lsp
