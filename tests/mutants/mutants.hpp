// Scripts with one slip in each: what people do to a sound script by accident, and what a message
// must name so that they see what it was.
#pragma once

#include <cstdint>
#include <deque>
#include <random>
#include <string>
#include <vector>

#include "grammar/tokens.hpp"

namespace mansard::test {

struct Mutant {
  std::string kind;  ///< "deleted '}'"
  std::string path;  ///< of the script it was made from
  std::string text;
  uint32_t line = 0;  ///< where the slip is
  /// The message names the cause when it has all words of one of these.
  std::vector<std::vector<std::string>> causes;
};

/// A sound script and what is known of its words.
class Original {
 public:
  Original(std::string path, const std::string& text);

  const std::string& path() const { return path_; }
  std::string text() const { return std::string(source_.text()); }
  const layout::Tokens& tokens() const { return tokens_; }
  uint32_t line(uint32_t token) const { return source_.line_of(tokens_[token].begin); }

  /// The innermost bracket around the token; the token itself when there is none.
  uint32_t around(uint32_t token) const { return around_[token]; }
  /// The name of the operation whose arguments or parts stand in these brackets, else nothing.
  std::string_view operation_of(uint32_t bracket) const;
  /// The two words stand somewhere one behind the other.
  bool has(std::string_view word, std::string_view next) const;

  /// The script with tokens [first, last] replaced.
  Mutant replaced(uint32_t first, uint32_t last, const std::string& with) const;

 private:
  std::string path_;
  Source source_;
  layout::Tokens tokens_;
  std::vector<uint32_t> around_;
};

/// At most `each` of every kind of slip, from all scripts, always the same for one seed.
std::vector<Mutant> mutants(const std::deque<Original>& originals, uint32_t seed, std::size_t each);

/// The word with two letters swapped, one left out or one doubled.
std::string misspelt(std::string_view word, std::mt19937& random);

}  // namespace mansard::test
