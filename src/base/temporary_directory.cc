#include "base/temporary_directory.h"

#include <stdlib.h>

#include <cerrno>
#include <cstring>
#include <stdexcept>
#include <string>
#include <system_error>

namespace smile {

TemporaryDirectory::TemporaryDirectory() {
  // mkdtemp() replaces the X and makes the directory for this user only; both in one step, so no
  // other program can take the name.
  std::string path = (std::filesystem::temp_directory_path() / "smile-XXXXXX").string();
  if (::mkdtemp(path.data()) == nullptr) {
    throw std::runtime_error(path + ": cannot be created: " + std::strerror(errno));
  }
  path_ = path;
}

TemporaryDirectory::~TemporaryDirectory() {
  // A destructor must not throw; what remains is in the temporary directory of the system.
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

}  // namespace smile
