#include "cli/lsp/alone.hpp"

#include <utility>

#include "grammar/parse.hpp"

namespace mansard::lsp {

namespace {

syntax::File parsed(const Source& source) {
  Diagnostics unheard;
  return parse(source, unheard);
}

}  // namespace

ScriptAlone::ScriptAlone(std::string path, std::string text, Encoding encoding)
    : source(std::move(path), std::move(text)),
      file(parsed(source)),
      words(words_of(file)),
      lines(source.text(), encoding) {}

const ScriptAlone* ScriptsAlone::find(const std::string& identity, Encoding encoding) {
  Kept& kept = kept_[identity];
  const uint64_t stamp = documents_.stamp(identity);
  if (kept.script && kept.stamp == stamp) return kept.script.get();
  kept = {stamp, nullptr};
  if (auto text = documents_.read(identity))
    kept.script = std::make_unique<ScriptAlone>(identity, *std::move(text), encoding);
  return kept.script.get();
}

}  // namespace mansard::lsp
