// What the server tells the editor that it can do.
#pragma once

#include "cli/lsp/json.hpp"
#include "cli/lsp/positions.hpp"

namespace mansard::lsp {

Json capabilities(Encoding encoding);

}  // namespace mansard::lsp
