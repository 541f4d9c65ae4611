// Files without a name, which are gone with whoever opened them, also when that is killed.
#pragma once

#include <string>

namespace mansard {

/// To read and write, in the folder. -1 on failure, with errno.
int open_nameless(const std::string& folder);

}  // namespace mansard
