#include "grammar/syntax.hpp"

namespace mansard::syntax {

File::File() = default;
File::~File() = default;
File::File(File&&) noexcept = default;
File& File::operator=(File&&) noexcept = default;

}  // namespace mansard::syntax
