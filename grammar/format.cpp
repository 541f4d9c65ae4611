#include "grammar/format.hpp"

#include "grammar/layout.hpp"
#include "grammar/parse.hpp"

namespace mansard {

std::optional<std::string> format(const Source& source, Diagnostics& diagnostics) {
  Diagnostics found;  // its own: one that collects drops repeats
  const syntax::File file = parse(source, found);
  for (const Diagnostic& d : found.all()) diagnostics.add(d);
  if (found.has_errors()) return std::nullopt;
  const layout::Tokens tokens(source);
  return layout::Layout(file, tokens).text();
}

}  // namespace mansard
