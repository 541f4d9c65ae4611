#include "cli/lsp/documents.hpp"

#include <sys/stat.h>

#include <algorithm>
#include <utility>

#include "cli/lsp/uri.hpp"

namespace mansard::lsp {

std::optional<std::string> Documents::read(const std::string& path) {
  if (const auto found = open_.find(identity(path)); found != open_.end())
    return found->second.text;
  return disk_.read(path);
}

bool Documents::exists(const std::string& path) {
  return open_.contains(identity(path)) || disk_.exists(path);
}

// Of a file: when it was written and how long it is. Even, where those of open texts are odd.
uint64_t Documents::stamp(const std::string& identity) const {
  if (const auto found = open_.find(identity); found != open_.end()) return found->second.stamp;
  struct stat file {};
  if (::stat(identity.c_str(), &file) != 0) return 0;
  const auto seconds = static_cast<uint64_t>(file.st_mtim.tv_sec);
  const auto rest = static_cast<uint64_t>(file.st_mtim.tv_nsec);
  return (((seconds * 1'000'000'000 + rest) * 31 + static_cast<uint64_t>(file.st_size)) << 1) | 2;
}

void Documents::open(const std::string& uri, std::string text, std::optional<uint32_t> version) {
  const std::string path = path_of(uri);
  open_[identity(path)] = {uri, path, std::move(text), version, last_stamp_ += 2};
}

void Documents::change(const std::string& uri, const std::vector<Params>& changes,
                       std::optional<uint32_t> version, Encoding encoding) {
  const auto found = open_.find(identity(path_of(uri)));
  if (found == open_.end()) return;
  Document& document = found->second;
  for (const Params& change : changes) {
    const std::string text = change.needed_text("text");
    if (change["range"].is_null()) {
      document.text = text;
      continue;
    }
    const auto offset = [&, lines = Lines(document.text, encoding)](std::string_view end) {
      const Params place = change["range"][end];
      return lines.offset({place.needed_number("line"), place.needed_number("character")});
    };
    const uint32_t begin = offset("start"), end = std::max(begin, offset("end"));
    document.text.replace(begin, end - begin, text);
  }
  document.version = version;
  document.stamp = last_stamp_ += 2;
}

void Documents::close(const std::string& uri) { open_.erase(identity(path_of(uri))); }

std::string Documents::uri(const std::string& path) {
  const std::string same = identity(path);
  const auto found = open_.find(same);
  return found == open_.end() ? uri_of(same) : found->second.uri;
}

}  // namespace mansard::lsp
