// A place in a source, as JSON says it.
#pragma once

#include "grammar/source.hpp"

namespace mansard {

/// Adds file, line, column, end_line and end_column, lines and columns from 1, to a JSON object;
/// nothing when there is no place.
template <class Json>
void put_place(Json& into, Span at) {
  if (!at) return;
  const Source::Position begin = at.source->position(at.begin), end = at.source->position(at.end);
  into["file"] = at.source->name();
  into["line"] = begin.line;
  into["column"] = begin.column;
  into["end_line"] = end.line;
  into["end_column"] = end.column;
}

}  // namespace mansard
