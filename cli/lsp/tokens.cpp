#include "cli/lsp/tokens.hpp"

#include <algorithm>

namespace mansard::lsp {

namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_word(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_' || is_digit(c);
}

class Scan {
 public:
  explicit Scan(std::string_view text) : text_(text) {}

  std::vector<Token> run() {
    while (at_ < text_.size()) {
      const char c = text_[at_];
      if (c == ' ' || c == '\t' || c == '\n' || c == '\r') {
        ++at_;
        continue;
      }
      const std::size_t begin = at_;
      const TokenKind kind = pass(c);
      tokens_.push_back({kind, static_cast<uint32_t>(begin), static_cast<uint32_t>(at_),
                         text_.substr(begin, at_ - begin)});
    }
    return std::move(tokens_);
  }

 private:
  bool starts(std::string_view sign) const { return text_.substr(at_, sign.size()) == sign; }

  /// Moves past the token that begins here.
  TokenKind pass(char c) {
    if (starts("//"))
      return at_ = std::min(text_.find('\n', at_), text_.size()), TokenKind::comment;
    if (starts("/*")) return pass_comment(), TokenKind::comment;
    if (c == '"') return pass_text(), TokenKind::text;
    const bool point = c == '.' && at_ + 1 < text_.size() && is_digit(text_[at_ + 1]);
    if (is_digit(c) || point) return pass_number(), TokenKind::number;
    if (is_word(c)) return pass_word(), TokenKind::name;
    at_ += starts("->") || starts("::") ? 2 : 1;
    return TokenKind::sign;
  }

  void pass_word() {
    while (at_ < text_.size() && is_word(text_[at_])) ++at_;
  }
  void pass_number() {
    while (at_ < text_.size() && (is_word(text_[at_]) || text_[at_] == '.')) ++at_;
  }
  void pass_text() {
    for (++at_; at_ < text_.size() && text_[at_] != '"' && text_[at_] != '\n'; ++at_) {
      if (text_[at_] == '\\' && at_ + 1 < text_.size()) ++at_;
    }
    if (at_ < text_.size() && text_[at_] == '"') ++at_;
  }
  void pass_comment() {
    int depth = 0;
    do {
      if (starts("/*")) ++depth, ++at_;
      if (starts("*/")) --depth, ++at_;
      ++at_;
    } while (depth > 0 && at_ < text_.size());
    at_ = std::min(at_, text_.size());
  }

  std::string_view text_;
  std::size_t at_ = 0;
  std::vector<Token> tokens_;
};

}  // namespace

std::vector<Token> tokens_of(std::string_view text) { return Scan(text).run(); }

std::vector<std::string> imported_paths(std::string_view text) {
  std::vector<std::string> paths;
  const std::vector<Token> tokens = tokens_of(text);
  int depth = 0;
  for (std::size_t i = 0; i < tokens.size(); ++i) {
    const Token& token = tokens[i];
    if (token.is("{")) ++depth;
    if (token.is("}")) --depth;
    if (depth > 0 || i == 0 || token.kind != TokenKind::text || token.text.size() < 3) continue;
    if (tokens[i - 1].is("import")) paths.emplace_back(token.text.substr(1, token.text.size() - 2));
  }
  return paths;
}

}  // namespace mansard::lsp
