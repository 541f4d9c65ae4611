// How editors name files.
#pragma once

#include <string>
#include <string_view>

namespace mansard::lsp {

/// The path of a `file://` URI, with its %-escapes resolved; other URIs stay as they are, as names
/// of texts that are on no disk.
std::string path_of(std::string_view uri);
/// A `file://` URI of an absolute path.
std::string uri_of(std::string_view path);

}  // namespace mansard::lsp
