// The texts that are open in the editor, laid over the disk: what is not saved yet wins.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "cli/lsp/params.hpp"
#include "cli/lsp/positions.hpp"
#include "styles/files.hpp"

namespace mansard::lsp {

struct Document {
  std::string uri, path;
  std::string text;
  std::optional<uint32_t> version;
  uint64_t stamp = 0;  ///< another one after each change
};

class Documents final : public Files {
 public:
  std::optional<std::string> read(const std::string& path) override;
  bool exists(const std::string& path) override;
  std::string identity(const std::string& path) override { return disk_.identity(path); }

  /// Changes whenever the content of the file does; 0 while there is none.
  uint64_t stamp(const std::string& identity) const;

  void open(const std::string& uri, std::string text, std::optional<uint32_t> version);
  /// The changes of `textDocument/didChange`, each over the result of the one before; one without a
  /// range is the whole text. Changes to a text that is not open are dropped.
  void change(const std::string& uri, const std::vector<Params>& changes,
              std::optional<uint32_t> version, Encoding encoding);
  void close(const std::string& uri);

  /// By identity.
  const std::map<std::string, Document>& all() const { return open_; }
  /// As the editor named it when it is open.
  std::string uri(const std::string& path);

 private:
  DiskFiles disk_;
  std::map<std::string, Document> open_;
  uint64_t last_stamp_ = 1;
};

}  // namespace mansard::lsp
