// Names that nobody else has.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace mansard {

/// Hands out what is wanted, with a number behind it from the second time on: a, a:2, a:3. Keeps 8
/// to 32 bytes a name, its hash: of a million names two are mistaken for one with a probability of
/// 3e-8, and then the second is numbered.
class FreeNames {
 public:
  explicit FreeNames(char separator) : separator_(separator) {}

  std::string next(std::string_view wanted);
  bool is_taken(std::string_view name) const;

 private:
  bool take(uint64_t hash);  ///< false when it was

  char separator_;
  std::vector<uint64_t> slots_;  ///< of a power of two, at most half full; 0: free
  std::size_t count_ = 0;
  std::unordered_map<std::string, std::size_t> last_;  ///< number of those that came again
};

}  // namespace mansard
