// Pages of `mansard help` on the language.
#pragma once

#include <span>
#include <string_view>

namespace mansard {

struct Topic {
  std::string_view name, title, page;
};

std::span<const Topic> topics();

}  // namespace mansard
