#include "cli/lsp/uri.hpp"

#include <charconv>

namespace mansard::lsp {

namespace {

constexpr std::string_view scheme = "file://";

/// Of "%41", -1 when the two are no hexadecimal digits.
int escaped(std::string_view text) {
  int value = -1;
  if (text.size() < 3) return -1;
  const auto [end, error] = std::from_chars(text.data() + 1, text.data() + 3, value, 16);
  return error == std::errc() && end == text.data() + 3 ? value : -1;
}

bool is_plain(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
         std::string_view("/-._~").find(c) != std::string_view::npos;
}

}  // namespace

std::string path_of(std::string_view uri) {
  if (!uri.starts_with(scheme)) return std::string(uri);
  uri.remove_prefix(scheme.size());
  const auto slash = uri.find('/');  // past the host, which is empty or this one
  if (slash != std::string_view::npos) uri.remove_prefix(slash);
  std::string path;
  for (std::size_t at = 0; at < uri.size(); ++at) {
    const int value = uri[at] == '%' ? escaped(uri.substr(at)) : -1;
    path += value > 0 ? static_cast<char>(value) : uri[at];
    if (value > 0) at += 2;
  }
  return path;
}

std::string uri_of(std::string_view path) {
  constexpr std::string_view digits = "0123456789ABCDEF";
  std::string uri(scheme);
  for (const char c : path) {
    const auto byte = static_cast<unsigned char>(c);
    if (is_plain(c)) {
      uri += c;
    } else {
      uri += {'%', digits[byte >> 4], digits[byte & 15]};
    }
  }
  return uri;
}

}  // namespace mansard::lsp
