// The user's own words in a message.
#pragma once

#include <string>
#include <string_view>

namespace mansard {

/// `'text'`; a long text is cut.
std::string in_quotes(std::string_view text);

}  // namespace mansard
