#include "cli/lsp/place.hpp"

#include <algorithm>
#include <array>

namespace mansard::lsp {

namespace {

using Where = Place::Where;

constexpr std::array<std::string_view, 7> member_words{"var",      "def",   "abstract", "final",
                                                       "override", "start", "replace"};

bool is_operand(const Token& token) {
  return token.kind == TokenKind::name || token.kind == TokenKind::number ||
         token.kind == TokenKind::text || token.is(")") || token.is("]");
}
bool is_joint(const Token& token) { return token.is("else") || token.is("if") || token.is("then"); }

/// Braces, brackets and parentheses that stand open.
struct Frame {
  enum class Kind : uint8_t { file, style, rules, elements, materials, parens, index, steps };
  enum class Mode : uint8_t { item, name, parents, head, guard, body, probability, value };
  explicit Frame(Kind k) : kind(k) {}

  Kind kind;
  Mode mode = Mode::item;
  std::string_view name;       ///< of the style, the block, the call, or the operation with parts
  OpenCall call;               ///< of parens
  bool part_start = false;     ///< of steps
  bool labels = false;         ///< of steps: these are the parts of an operation
  bool condition = false;      ///< between `if` and its brace
  std::string_view made_name;  ///< of the style or member that is begun
  std::string_view head_name;
  std::vector<std::string_view> params;
};

class Reader {
 public:
  Reader(const std::vector<Token>& tokens, std::size_t count) : tokens_(tokens), count_(count) {
    stack_.emplace_back(Frame::Kind::file);
  }

  Place run() {
    for (at_ = 0; at_ < count_; ++at_) {
      const Token& token = tokens_[at_];
      if (token.kind == TokenKind::comment) continue;
      take(token);
      last_ = &token;
    }
    return place();
  }

 private:
  using Kind = Frame::Kind;
  using Mode = Frame::Mode;
  Frame& top() { return stack_.back(); }

  void take(const Token& token) {
    if (token.is("}") || token.is(")") || token.is("]")) return close();
    if (token.is("(")) return open_parens();
    if (token.is("[")) return open_bracket(token);
    if (token.is("{")) return open_brace();
    Frame& frame = top();
    switch (frame.kind) {
      case Kind::file:
      case Kind::style:
      case Kind::rules:
        return take_member(token, frame);
      case Kind::elements:
      case Kind::materials:
        frame.mode = token.kind == TokenKind::sign && !token.is("|") ? Mode::value : frame.mode;
        return;
      case Kind::parens:
        if (token.is(",")) ++frame.call.argument;
        return;
      case Kind::index:
        return;
      case Kind::steps:
        if (token.is("if")) frame.condition = true;
        frame.part_start = token.is("|");
        return;
    }
  }

  void take_member(const Token& token, Frame& frame) {
    const bool word = token.kind == TokenKind::name;
    if (frame.kind == Kind::file && (token.is("style") || token.is("class"))) {
      frame.mode = Mode::name;
    } else if (frame.kind != Kind::file && word &&
               std::ranges::find(member_words, token.text) != member_words.end()) {
      const bool names = token.is("var") || token.is("def");
      frame.mode = names ? Mode::name : token.is("start") ? Mode::value : Mode::item;
    } else if (frame.mode == Mode::name && word) {
      frame.made_name = token.text;
      frame.mode = Mode::head;
      frame.params.clear();
    } else if (frame.kind == Kind::rules && word && is_head(at_)) {
      frame.mode = Mode::head;
      frame.head_name = token.text;
      frame.params = parameters(at_);
    } else if (token.is("->")) {
      frame.mode = Mode::body;
    } else if (token.is(":")) {
      frame.mode = frame.kind == Kind::file   ? Mode::parents
                   : frame.mode == Mode::body ? Mode::probability
                                              : Mode::guard;
    } else if (token.is("=") && frame.mode == Mode::head) {
      frame.mode = Mode::value;
    } else if (token.is("if") && frame.mode == Mode::body) {
      frame.condition = true;
    }
  }

  void close() {
    if (stack_.size() > 1) stack_.pop_back();
    Frame& frame = top();
    if (frame.kind == Kind::style || frame.kind == Kind::file) frame.mode = Mode::item;
    frame.condition = false;
  }

  /// In a successor? Then a call is an operation or a symbol.
  bool in_steps() {
    const Frame& frame = top();
    return !frame.condition && (frame.kind == Kind::steps || frame.kind == Kind::materials ||
                                (frame.kind == Kind::rules && frame.mode == Mode::body));
  }

  void open_parens() {
    OpenCall call;
    call.is_step = in_steps();
    if (last_ && last_->kind == TokenKind::name && !is_joint(*last_)) {
      call.name = last_->text;
      if (at_ >= 3 && tokens_[at_ - 2].is(".")) call.block = tokens_[at_ - 3].text;
    }
    Frame frame(Kind::parens);
    frame.call = call;
    stack_.push_back(std::move(frame));
  }

  void open_bracket(const Token& token) {
    const bool tight = last_ && last_->end == token.begin && is_operand(*last_);
    Frame frame(in_steps() && !tight ? Kind::steps : Kind::index);
    stack_.push_back(std::move(frame));
  }

  void open_brace() {
    Frame& frame = top();
    if (frame.kind == Kind::file) {
      Frame style(Kind::style);
      style.name = frame.made_name;
      frame.mode = Mode::item;
      stack_.push_back(std::move(style));
    } else if (frame.kind == Kind::style) {
      const std::string_view name = last_ ? last_->text : std::string_view{};
      Frame block(name == "Elements"    ? Kind::elements
                  : name == "Materials" ? Kind::materials
                                        : Kind::rules);
      block.name = name;
      stack_.push_back(std::move(block));
    } else {
      Frame parts(Kind::steps);
      parts.part_start = true;
      parts.labels = !frame.condition;
      if (!frame.condition) parts.name = operation_before(at_);
      frame.condition = false;
      frame.part_start = false;
      stack_.push_back(std::move(parts));
    }
  }

  /// Before the brace at `brace`: `name {`, `name(…) {`, `name(…)[…] {`. A group has the operation
  /// of the parts it stands in.
  std::string_view operation_before(std::size_t brace) {
    std::size_t at = brace;
    while (at > 0 && (tokens_[at - 1].is(")") || tokens_[at - 1].is("]"))) {
      int depth = 0;
      do {
        --at;
        depth += tokens_[at].is(")") || tokens_[at].is("]");
        depth -= tokens_[at].is("(") || tokens_[at].is("[");
      } while (depth > 0 && at > 0);
    }
    if (at == 0) return {};
    if (tokens_[at - 1].kind == TokenKind::name) return tokens_[at - 1].text;
    return top().kind == Kind::steps ? top().name : std::string_view{};
  }

  /// Past brackets that open at `at`.
  std::size_t past(std::size_t at) const {
    int depth = 0;
    for (; at < tokens_.size(); ++at) {
      depth += tokens_[at].is("(") || tokens_[at].is("[");
      depth -= tokens_[at].is(")") || tokens_[at].is("]");
      if (depth == 0) return at + 1;
    }
    return at;
  }

  /// NAME (params) [index] : guard ->
  bool is_head(std::size_t at) const {
    const auto is = [&](std::string_view sign) {
      return at < tokens_.size() && tokens_[at].is(sign);
    };
    ++at;
    if (is("(")) at = past(at);
    if (is("[")) at = past(at);
    if (is("->")) return true;
    if (!is(":")) return false;
    for (++at; at < tokens_.size() && !is("->"); ++at) {
      if (is("{") || is("}") || is("|") || is(":") || is("=")) return false;
      const Token &token = tokens_[at], &before = tokens_[at - 1];
      const bool begins = token.kind != TokenKind::sign && token.kind != TokenKind::comment;
      if (begins && is_operand(before) && !is_joint(before) && !is_joint(token)) return false;
      if (is("(") || is("[")) at = past(at) - 1;
    }
    return at < tokens_.size();
  }

  std::vector<std::string_view> parameters(std::size_t at) const {
    std::vector<std::string_view> names;
    for (++at; at < tokens_.size() && (tokens_[at].is("(") || tokens_[at].is("["));) {
      const std::size_t end = past(at);
      for (; at < end; ++at) {
        if (tokens_[at].kind == TokenKind::name) names.push_back(tokens_[at].text);
      }
    }
    return names;
  }

  Place place() {
    Place place;
    for (const Frame& frame : stack_) {
      if (frame.kind == Kind::style) place.style = frame.name;
      const bool block = frame.kind == Kind::rules || frame.kind == Kind::elements ||
                         frame.kind == Kind::materials;
      if (block) place.block = frame.name;
      if (frame.kind == Kind::rules) place.rule = frame.head_name, place.params = frame.params;
      if (frame.kind == Kind::parens) place.calls.push_back(frame.call);
      if (frame.kind == Kind::steps) place.parts_of = frame.name;
    }
    place.where = where();
    place.after_value = last_ && (is_operand(*last_) || last_->is("}"));
    if (!last_ || at_before_last() == nullptr) return place;
    if (last_->is("@")) place.where = Where::annotation;
    if (last_->is(".") || last_->is("::")) {
      place.before = at_before_last()->text;
      place.where = last_->is(".") ? Where::of_block : Where::of_style;
    }
    return place;
  }

  const Token* at_before_last() const { return last_ > tokens_.data() ? last_ - 1 : last_; }

  Where where() {
    const Frame& frame = top();
    if (frame.condition) return Where::expression;
    switch (frame.kind) {
      case Kind::file:
        return frame.mode == Mode::parents ? Where::parents
               : frame.mode == Mode::item  ? Where::file
                                           : Where::nowhere;
      case Kind::elements:
        return Where::elements;
      case Kind::materials:
        return Where::materials;
      case Kind::parens:
      case Kind::index:
        return Where::expression;
      case Kind::steps:
        return frame.part_start && frame.labels ? Where::part : Where::successor;
      case Kind::style:
      case Kind::rules:
        break;
    }
    const Where members = frame.kind == Kind::style ? Where::style : Where::rules;
    if (frame.mode == Mode::body) return Where::successor;
    if (frame.mode == Mode::name || frame.mode == Mode::head) return Where::nowhere;
    if (frame.mode == Mode::item) return members;
    return last_ && (is_operand(*last_) || last_->is("}")) && !is_joint(*last_) ? members
                                                                                : Where::expression;
  }

  const std::vector<Token>& tokens_;
  std::size_t count_, at_ = 0;
  const Token* last_ = nullptr;
  std::vector<Frame> stack_;
};

}  // namespace

Place place_at(std::string_view text, const std::vector<Token>& tokens, uint32_t offset) {
  std::size_t count = 0;
  while (count < tokens.size() && tokens[count].begin < offset) ++count;
  uint32_t begin = offset;
  const Token* const here = count > 0 ? &tokens[count - 1] : nullptr;
  const bool inside = here && offset <= here->end;
  if (inside && here->kind == TokenKind::comment) {
    const bool closed = here->text.starts_with("/*") && offset == here->end;
    if (!closed) return {};
  }
  const bool in_text =
      here && here->kind == TokenKind::text &&
      offset < here->end + (here->text.size() < 2 || here->text.back() != '"' ? 1u : 0u);
  if (inside && (here->kind == TokenKind::name || in_text)) {
    --count;
    begin = here->begin + (in_text ? 1 : 0);
  }
  Place place = Reader(tokens, count).run();
  if (in_text) {
    const bool imports = count > 0 && tokens[count - 1].is("import");
    place.where = imports ? Where::import_path : Where::text;
  }
  place.begin = begin;
  const std::size_t line = text.substr(0, begin).rfind('\n') + 1;
  place.first_on_line = text.substr(line, begin - line).find_first_not_of(" \t") == text.npos;
  return place;
}

}  // namespace mansard::lsp
