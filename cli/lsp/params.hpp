// What a message from the editor says: any part of it may be missing or of another type.
#pragma once

#include <cstdint>
#include <exception>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace mansard::lsp {

/// A request that is answered by an error. The codes are JSON-RPC's and the protocol's.
struct Refusal : std::exception {
  enum Code : int {
    parse_error = -32700,
    invalid_request = -32600,
    method_not_found = -32601,
    invalid_params = -32602,
    internal_error = -32603,
    not_initialized = -32002,
    cancelled = -32800,
    request_failed = -32803,
  };
  Refusal(Code c, std::string t) : code(c), text(std::move(t)) {}
  const char* what() const noexcept override { return text.c_str(); }
  Code code;
  std::string text;
};

/// A value inside a message that was read. Copies are cheap and keep the message alive.
class Params {
 public:
  /// Nothing when the text is no JSON.
  static std::optional<Params> parse(const std::string& text);

  /// `params["textDocument.uri"]`: the value at the end of the path, null where there is none.
  Params operator[](std::string_view path) const;
  bool is_null() const;
  bool is_object() const;
  bool is_array() const;
  std::optional<std::string> text() const;
  /// Whole numbers from 0 to 2^31 - 1.
  std::optional<uint32_t> number() const;
  bool is_true() const;
  /// Of an array; of anything else none.
  std::vector<Params> items() const;
  /// As JSON again.
  std::string written() const;

  /// Refuses the request when there is none.
  std::string needed_text(std::string_view path) const;
  uint32_t needed_number(std::string_view path) const;

 private:
  // The library's own type stays in params.cpp.
  Params(std::shared_ptr<const void> message, const void* value)
      : message_(std::move(message)), value_(value) {}
  std::shared_ptr<const void> message_;
  const void* value_;  ///< null for what is missing
};

}  // namespace mansard::lsp
