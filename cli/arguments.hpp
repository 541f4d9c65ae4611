// A parsed command line.
#pragma once

#include <exception>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "cli/command.hpp"

namespace mansard {

/// Wrong usage: exit status 2.
struct UsageError : std::exception {
  explicit UsageError(std::string t) : text(std::move(t)) {}
  const char* what() const noexcept override { return text.c_str(); }
  std::string text;
};

class Arguments {
 public:
  /// Throws UsageError for unknown flags (with the nearest), missing values and wrong counts.
  static Arguments parse(const Command& command, int argc, const char* const* argv);

  const std::vector<std::string>& positional() const { return positional_; }
  bool has(std::string_view flag) const { return values_.contains(flag); }
  /// The last value given.
  std::optional<std::string> value(std::string_view flag) const;
  const std::vector<std::string>& values(std::string_view flag) const;
  std::string text(std::string_view flag, std::string_view fallback) const;
  /// A whole number within [low, high].
  long long number(std::string_view flag, long long fallback, long long low, long long high) const;

 private:
  std::vector<std::string> positional_;
  std::map<std::string, std::vector<std::string>, std::less<>> values_;
};

}  // namespace mansard
