#include "cli/lsp/json.hpp"

#include <array>
#include <cstdio>

#include "grammar/utf8.hpp"

namespace mansard::lsp {

namespace {

constexpr std::string_view replacement = "\xEF\xBF\xBD";  // U+FFFD for bytes that are no text

void escape(char c, std::string& into) {
  switch (c) {
    case '"':
    case '\\':
      into += '\\';
      into += c;
      return;
    case '\n':
      into += "\\n";
      return;
    case '\t':
      into += "\\t";
      return;
    default:
      break;
  }
  if (static_cast<unsigned char>(c) >= 0x20) {
    into += c;
    return;
  }
  std::array<char, 8> code{};
  std::snprintf(code.data(), code.size(), "\\u%04x", c);
  into += code.data();
}

}  // namespace

Json::Json(std::string_view value) {
  text_.reserve(value.size() + 2);
  text_ += '"';
  for (std::size_t at = 0; at < value.size();) {
    if (static_cast<unsigned char>(value[at]) < 0x80) {
      escape(value[at++], text_);
      continue;
    }
    const CodePoint c = decode(value, at);
    text_ += c.valid ? value.substr(at, c.bytes) : replacement;
    at += c.bytes;
  }
  text_ += '"';
}

Json Json::object(std::initializer_list<Member> members) {
  Json made;
  made.text_ = "{}";
  for (const Member& member : members) made.put(member.first, member.second);
  return made;
}

Json Json::array(const std::vector<Json>& items) {
  Json made;
  made.text_ = "[";
  for (const Json& item : items) {
    if (made.text_.size() > 1) made.text_ += ',';
    made.text_ += item.text_;
  }
  made.text_ += ']';
  return made;
}

Json Json::raw(std::string text) {
  Json made;
  made.text_ = std::move(text);
  return made;
}

Json& Json::put(std::string_view name, const Json& value) {
  text_.pop_back();
  if (text_.size() > 1) text_ += ',';
  text_ += Json(name).text_;
  text_ += ':';
  text_ += value.text_;
  text_ += '}';
  return *this;
}

}  // namespace mansard::lsp
