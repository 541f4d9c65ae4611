#include "formats/nameless_file.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cstdlib>

namespace mansard {

int open_nameless(const std::string& folder) {
  const int nameless = open(folder.c_str(), O_RDWR | O_TMPFILE | O_CLOEXEC, 0600);
  if (nameless >= 0) return nameless;
  // Not every file system can; for a moment it has a name there.
  std::string name = folder + "/mansardXXXXXX";
  const int file = mkostemp(name.data(), O_CLOEXEC);
  if (file >= 0) unlink(name.c_str());
  return file;
}

}  // namespace mansard
