// Scripts read by themselves, without their imports: enough for the names they declare.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "cli/lsp/documents.hpp"
#include "cli/lsp/positions.hpp"
#include "cli/lsp/word.hpp"

namespace mansard::lsp {

struct ScriptAlone {
  ScriptAlone(std::string path, std::string text, Encoding encoding);
  ScriptAlone(const ScriptAlone&) = delete;
  ScriptAlone& operator=(const ScriptAlone&) = delete;

  Source source;
  syntax::File file;
  std::vector<Word> words;
  Lines lines;
};

class ScriptsAlone {
 public:
  explicit ScriptsAlone(Documents& documents) : documents_(documents) {}

  /// Read again only when it has changed; null when it can not be read. Valid until it is asked for
  /// again.
  const ScriptAlone* find(const std::string& identity, Encoding encoding);

 private:
  struct Kept {
    uint64_t stamp = 0;
    std::unique_ptr<ScriptAlone> script;
  };
  Documents& documents_;
  std::map<std::string, Kept> kept_;
};

}  // namespace mansard::lsp
