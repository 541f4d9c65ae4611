// JSON as the server writes it; reading it is params.hpp's.
#pragma once

#include <concepts>
#include <cstddef>
#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace mansard::lsp {

/// The text of a JSON value.
class Json {
 public:
  using Member = std::pair<std::string_view, Json>;

  Json(std::nullptr_t) : text_("null") {}  // NOLINT: values convert by design
  Json(std::string_view value);            // NOLINT
  Json(const std::string& value) : Json(std::string_view(value)) {}  // NOLINT
  Json(const char* value) : Json(std::string_view(value)) {}         // NOLINT
  template <std::integral T>
  Json(T value) {  // NOLINT
    if constexpr (std::same_as<T, bool>) {
      text_ = value ? "true" : "false";
    } else {
      text_ = std::to_string(value);
    }
  }
  static Json object(std::initializer_list<Member> members);
  static Json array(const std::vector<Json>& items);
  /// Text that is JSON already.
  static Json raw(std::string text);

  /// Adds a member to an object.
  Json& put(std::string_view name, const Json& value);
  const std::string& text() const { return text_; }

 private:
  Json() = default;
  std::string text_;
};

}  // namespace mansard::lsp
