#include "base/library_folder.h"

#include <dlfcn.h>
#include <link.h>

#include <system_error>

namespace smile {

std::filesystem::path LibraryFolder() {
  Dl_info info{};
  void* found = nullptr;
  ::dladdr1(reinterpret_cast<void*>(&LibraryFolder), &info, &found, RTLD_DL_LINKMAP);
  const auto* library = static_cast<const link_map*>(found);
  std::error_code error;
  // The name of the program itself is empty here; in `info` it may be relative.
  if (library == nullptr || *library->l_name == '\0') {
    return std::filesystem::read_symlink("/proc/self/exe", error).parent_path();
  }
  const auto file = std::filesystem::canonical(library->l_name, error);
  return error ? std::filesystem::path() : file.parent_path();
}

}  // namespace smile
