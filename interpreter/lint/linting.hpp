// What the warnings of `check` share. Private to them.
#pragma once

#include <set>
#include <string>
#include <unordered_map>
#include <vector>

#include "interpreter/lint.hpp"
#include "interpreter/lint/reach.hpp"
#include "interpreter/lint/reads.hpp"

namespace mansard {

struct Linting {
  Linting(const Program& program, const syntax::File& file, Diagnostics& diagnostics);

  const Program& program;
  const syntax::File& file;
  Diagnostics& diagnostics;
  Reach reach;
  Reads reads;
  /// Each looks at all names of a style; a script of a hundred thousand slips gets no more.
  int suggestions_left = 50;
  /// Symbols that a warning has named as what somebody may have meant.
  std::set<uint32_t> suspected;

  bool here(Span at) const { return at.source == file.source; }
  /// Null when the style could not be linked.
  const LinkedStyle* linked(const syntax::Style& style) const;
  /// Styles that inherit from this one, itself among them, and that can be derived or are derived
  /// in part by another.
  const std::vector<uint16_t>& live_heirs(const syntax::Style& style) const;
  bool reached(const syntax::Style& style, uint32_t symbol) const;

  void warn(std::string_view code, Span at, std::string text, std::string help = {},
            std::vector<Note> notes = {});
  /// The nearest of the candidates, or an empty name.
  std::string_view nearest_of(std::string_view word,
                              const std::vector<std::string_view>& candidates);

 private:
  std::unordered_map<const syntax::Style*, std::vector<uint16_t>> heirs_;
};

// One file each.
void warn_of_unreached(Linting& linting);
void warn_of_terminals(Linting& linting);
void warn_of_unread(Linting& linting);
void warn_of_chances(Linting& linting);
void warn_of_indices(Linting& linting);
void warn_of_shadows(Linting& linting);
void warn_of_defaults(Linting& linting);
void warn_of_snapping(Linting& linting);

}  // namespace mansard
