// Names that every OBJ reader takes.
#pragma once

#include <algorithm>
#include <string>
#include <string_view>

namespace mansard {

/// Space ends a name for many readers, a backslash joins lines, # starts a comment for some.
inline char safe_letter(char c) {
  const auto code = static_cast<unsigned char>(c);
  return code <= ' ' || code == 127 || c == '\\' || c == '#' ? '_' : c;
}

inline std::string safe_name(std::string_view name) {
  std::string safe(name.empty() ? "_" : name);
  std::transform(safe.begin(), safe.end(), safe.begin(), safe_letter);
  return safe;
}

}  // namespace mansard
