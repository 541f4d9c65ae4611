// Words for what went wrong where the grammar got stuck.
#pragma once

#include "grammar/diagnostic.hpp"
#include "grammar/reading.hpp"

namespace mansard {

Diagnostic explain(const Source& source, const Trail::Place& place, const ErrorSite& around,
                   const Trail& trail, uint32_t brief_variable_end);
Diagnostic explain_missing_brace(const Source& source, const char* at, const char* open);
Complaint explain_escape(const char* begin, const char* end, const char* after_text);

}  // namespace mansard
