// What the server answers, a function a request: the parameters of the message in, the result out.
// Positions outside the text count as its nearest; texts that are not there are refused.
#pragma once

#include "cli/lsp/json.hpp"
#include "cli/lsp/params.hpp"
#include "cli/lsp/project.hpp"

namespace mansard::lsp {

Json hover(Project& project, const Params& params);

Json definition(Project& project, const Params& params);
/// What the definition overrides; where it overrides nothing, the definition.
Json declaration(Project& project, const Params& params);
/// Where heirs override it.
Json implementation(Project& project, const Params& params);
Json references(Project& project, const Params& params);
Json highlights(Project& project, const Params& params);

Json prepare_rename(Project& project, const Params& params);
Json rename(Project& project, const Params& params);

Json completion(Project& project, const Params& params);
Json signature_help(Project& project, const Params& params);

Json document_symbols(Project& project, const Params& params);
Json workspace_symbols(Project& project, const Params& params);
Json folding_ranges(Project& project, const Params& params);

Json formatting(Project& project, const Params& params);
Json code_actions(Project& project, const Params& params);

}  // namespace mansard::lsp
