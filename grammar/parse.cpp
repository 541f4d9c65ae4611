#include "grammar/parse.hpp"

#include "grammar/recovery.hpp"
#include "grammar/utf8.hpp"

namespace mansard {

namespace {

using Input = tao::pegtl::memory_input<tao::pegtl::tracking_mode::lazy, tao::pegtl::eol::lf_crlf,
                                       const char*>;

Diagnostic error(Span at, std::string text, std::string help) {
  return {Severity::error, {}, at, std::move(text), {}, {}, std::move(help)};
}

bool is_control(char32_t c) {
  return (c < 0x20 && c != '\t' && c != '\n' && c != '\r') || c == 0x7F;
}

// What is no text is not read at all: everything said about it would be nonsense.
bool is_text(const Source& source, Diagnostics& diagnostics) {
  const std::string_view text = source.text();
  if (text.size() > Source::max_bytes) {
    diagnostics.add(error({&source, 0, 0},
                          "the file is larger than the " + std::to_string(Source::max_bytes >> 20) +
                              " MB that a script may have",
                          {}));
    return false;
  }
  for (uint32_t at = 0; at < text.size();) {
    const char first = text[at];
    if (first >= 0x20 && first < 0x7F) {
      ++at;
      continue;
    }
    if (first == '\r' && text.substr(at + 1, 1) != "\n") {
      diagnostics.add(error({&source, at, at + 1}, "a carriage return without a line feed",
                            "save the script with the line ends LF or CRLF"));
      return false;
    }
    const CodePoint c = decode(text, at);
    if (!c.valid || is_control(c.value)) {
      diagnostics.add(error({&source, at, at + 1},
                            c.valid ? "a control character stands here" : "this is not UTF-8 text",
                            "a script is a plain text file in UTF-8"));
      return false;
    }
    at += c.bytes;
  }
  return true;
}

}  // namespace

syntax::File parse(const Source& source, Diagnostics& diagnostics) {
  syntax::File nothing;
  nothing.source = &source;
  if (!is_text(source, diagnostics)) return nothing;
  Reading reading(source, diagnostics);
  Input in(source.text().data(), source.text().data() + source.text().size(), "");
  tao::pegtl::parse<peg::file, peg::action, peg::control>(in, reading);
  reading.finish();
  return std::move(reading.tree.file);
}

syntax::ExprPtr parse_expression(const Source& source, Diagnostics& diagnostics) {
  if (!is_text(source, diagnostics)) return nullptr;
  Reading reading(source, diagnostics);
  Input in(source.text().data(), source.text().data() + source.text().size(), "");
  const bool matched = tao::pegtl::parse<peg::only_expr, peg::action, peg::control>(in, reading);
  if (!matched) {
    ErrorSite around;
    around.member = reading.after_space(source.text().data());
    reading.report(around);
  }
  reading.finish();
  return matched && !diagnostics.has_errors() ? reading.tree.take_expr() : nullptr;
}

}  // namespace mansard
