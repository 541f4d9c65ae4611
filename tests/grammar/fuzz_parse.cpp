// Any bytes as a script: read, dumped, formatted twice, and every diagnostic printed. libFuzzer's
// entry, and the ctest over the kept corpus runs the same function.
#include <cstddef>
#include <cstdint>
#include <cstdlib>

#include "dump.hpp"
#include "grammar/format.hpp"
#include "grammar/parse.hpp"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, std::size_t size) {
  using namespace mansard;  // NOLINT: a main of sorts
  const Source source("fuzz.style", std::string(data, data + size));
  Diagnostics diagnostics;
  dump(parse(source, diagnostics));
  parse_expression(source, diagnostics);
  if (const auto text = format(source, diagnostics)) {
    const Source again("again.style", *text);
    if (format(again, diagnostics) != text) std::abort();
  }
  diagnostics.sort();
  for (const Diagnostic& diagnostic : diagnostics.all()) {
    to_text(diagnostic, true);
    to_json(diagnostic);
  }
  return 0;
}
