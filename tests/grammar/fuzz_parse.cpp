// Any bytes as a script: read, dumped, and every diagnostic printed. libFuzzer's entry, and the
// ctest over the kept corpus runs the same function.
#include <cstddef>
#include <cstdint>

#include "dump.hpp"
#include "grammar/parse.hpp"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, std::size_t size) {
  using namespace mansard;  // NOLINT: a main of sorts
  const Source source("fuzz.style", std::string(data, data + size));
  Diagnostics diagnostics;
  dump(parse(source, diagnostics));
  parse_expression(source, diagnostics);
  diagnostics.sort();
  for (const Diagnostic& diagnostic : diagnostics.all()) {
    to_text(diagnostic, true);
    to_json(diagnostic);
  }
  return 0;
}
