#include "grammar/tokens.hpp"

#include <algorithm>
#include <array>

#include "grammar/parse.hpp"
#include "grammar/reading.hpp"
#include "grammar/utf8.hpp"

namespace mansard::layout {

namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }

int width_of(std::string_view text) {
  int width = 0;
  for (std::size_t at = 0; at < text.size();) {
    const CodePoint c = decode(text, at);
    width += columns(c.value);
    at += c.bytes;
  }
  return width;
}

std::string_view trimmed(std::string_view text) {
  const std::size_t last = text.find_last_not_of(" \t\r\n");
  return text.substr(0, last == text.npos ? 0 : last + 1);
}

}  // namespace

Tokens::Tokens(const Source& source) : text_(source.text()) {
  if (text_.starts_with("\xEF\xBB\xBF")) at_ = 3;  // a byte order mark
  line_ends_ = 1;                                  // the file begins a line
  do {
    const auto first = static_cast<uint32_t>(comments_.size());
    read_space();
    Token token = read_token();
    token.comments = first;
    token.comments_end = static_cast<uint32_t>(comments_.size());
    all_.push_back(token);
  } while (all_.back().kind != Kind::end);
}

uint32_t Tokens::from(uint32_t offset) const {
  const auto at = std::partition_point(all_.begin(), all_.end(),
                                       [&](const Token& token) { return token.begin < offset; });
  return static_cast<uint32_t>(at - all_.begin());
}

// ---- space and comments

void Tokens::read_space() {
  line_seen_ = false;
  for (; at_ < text_.size(); ++at_) {
    const char c = text_[at_];
    if (c == '\n') {
      ++line_ends_;
      line_seen_ = true;
    } else if (c == '/' && at_ + 1 < text_.size() &&
               (text_[at_ + 1] == '/' || text_[at_ + 1] == '*')) {
      read_comment();
      --at_;
    } else if (c != ' ' && c != '\t' && c != '\r') {
      return;
    }
  }
}

void Tokens::read_comment() {
  Comment comment;
  const uint32_t begin = at_;
  comment.to_line_end = text_[at_ + 1] == '/';
  if (comment.to_line_end) {
    at_ = static_cast<uint32_t>(std::min(text_.find('\n', at_), text_.size()));
  } else {
    std::size_t depth = 0;
    do {
      const std::string_view two = text_.substr(at_, 2);
      if (two == "/*") ++depth;
      if (two == "*/") --depth;
      at_ += two == "/*" || two == "*/" ? 2 : 1;
    } while (depth > 0);
  }
  comment.text = trimmed(text_.substr(begin, at_ - begin));
  comment.own_line = line_ends_ > 0;
  comment.blank_before = line_ends_ > 1;
  comment.many_lines = comment.text.find('\n') != std::string_view::npos;
  if (comment.many_lines) line_seen_ = true;
  comment.width = width_of(comment.text.substr(comment.text.rfind('\n') + 1));
  const std::size_t next = std::min(text_.find_first_not_of(" \t\r", at_), text_.size());
  comment.ends_line = next == text_.size() || text_[next] == '\n';
  comments_.push_back(comment);
  line_ends_ = 0;
}

// ---- tokens

Token Tokens::read_token() {
  Token token;
  token.begin = at_;
  token.line_before = line_seen_;
  token.blank_before = line_ends_ > 1;
  line_ends_ = 0;
  if (at_ == text_.size()) {
    token.end = at_;
    token.kind = Kind::end;
    return token;
  }
  at_ += length_of(text_[at_]);
  token.end = at_;
  token.text = text_.substr(token.begin, token.end - token.begin);
  classify(token);
  token.width = width_of(token.text);
  return token;
}

uint32_t Tokens::length_of(char first) const {
  const std::string_view rest = text_.substr(at_);
  const auto leading = [&](auto belongs) {
    return static_cast<uint32_t>(std::find_if_not(rest.begin(), rest.end(), belongs) -
                                 rest.begin());
  };
  if (is_digit(first) || (first == '.' && rest.size() > 1 && is_digit(rest[1])))
    return number_length();
  if (Reading::is_word(first)) return leading(Reading::is_word);
  if (first == '"') {
    uint32_t length = 1;
    for (; rest[length] != '"'; ++length) length += rest[length] == '\\';
    return length + 1;
  }
  constexpr std::array<std::string_view, 8> longer{"->", "::", "<=", ">=", "==", "!=", "&&", "||"};
  return std::find(longer.begin(), longer.end(), rest.substr(0, 2)) == longer.end() ? 1 : 2;
}

// As `number` and `unit` of the grammar.
uint32_t Tokens::number_length() const {
  const auto at = [&](uint32_t i) { return at_ + i < text_.size() ? text_[at_ + i] : '\0'; };
  uint32_t length = 0;
  while (is_digit(at(length))) ++length;
  if (at(length) == '.') ++length;
  while (is_digit(at(length))) ++length;
  if (at(length) == 'e' || at(length) == 'E') {
    const uint32_t sign = at(length + 1) == '+' || at(length + 1) == '-';
    if (is_digit(at(length + 1 + sign))) length += 2 + sign;
    while (is_digit(at(length))) ++length;
  }
  if (at(length) == '%' || (at(length) == 'r' && !Reading::is_word(at(length + 1)))) ++length;
  return length;
}

void Tokens::classify(Token& token) {
  const char first = token.text[0];
  if (is_digit(first) || (first == '.' && token.text.size() > 1)) {
    token.kind = Kind::number;
  } else if (first == '"') {
    token.kind = Kind::text;
  } else if (Reading::is_word(first)) {
    token.kind = Kind::word;
    if (all_.empty()) {
      token.keyword = true;
    } else {
      const Token& before = all_.back();
      const auto words = keywords();
      token.keyword = before.text != "." && before.text != "@" &&
                      std::find(words.begin(), words.end(), token.text) != words.end();
      const bool against = before.text == ")" && before.end == token.begin;
      token.glued = against && token.text == "r" && !all_[before.match].call;
    }
    if (token.keyword && token.text == "class") token.text = "style";
  } else {
    classify_sign(token);
    pair(token);
  }
}

void Tokens::classify_sign(Token& token) {
  const Token none;
  const Token& before = all_.empty() ? none : all_.back();
  const bool named = before.kind == Kind::word && !before.keyword;
  const bool declared = named && all_.size() > 1 && all_[all_.size() - 2].keyword &&
                        all_[all_.size() - 2].text == "var";  // `var X (1 + 2)`
  const bool value = before.kind == Kind::number || before.kind == Kind::text || before.glued ||
                     before.text == ")" || before.text == "]" || before.text == "true" ||
                     before.text == "false" || (named && !declared);
  const char sign = token.text[0];
  if (sign == '(') token.call = (named && !declared) || before.text == "style";
  if (sign == '[') token.call = value && before.end == token.begin;
  if (sign == '%') token.glued = true;
  if (sign == '~' || sign == '@' || token.text == "!") token.prefix = true;
  if (token.text == "-") token.prefix = !value;
}

void Tokens::pair(Token& token) {
  const char sign = token.text[0];
  const auto here = static_cast<uint32_t>(all_.size());
  if (sign == '(' || sign == '[' || sign == '{') open_.push_back(here);
  if (sign != ')' && sign != ']' && sign != '}') return;
  token.match = open_.back();
  all_[open_.back()].match = here;
  open_.pop_back();
}

}  // namespace mansard::layout
