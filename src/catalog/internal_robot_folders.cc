#include "catalog/internal_robot_folders.h"

#include <algorithm>
#include <system_error>

#include "base/files.h"

// Folders of robots may be large, or may not be there.

namespace smile::catalog::internal {
namespace {

namespace fs = std::filesystem;

/// More robots of the user are not listed.
constexpr std::size_t kMaxEntries = 1000;

}  // namespace

fs::path ShippedFolder() { return DataFile("robots/baxter.urdf").parent_path(); }

std::vector<fs::path> EntriesOf(const fs::path& folder) {
  std::vector<fs::path> entries;
  std::error_code error;
  for (fs::directory_iterator it(folder, error), end; !error && it != end; it.increment(error)) {
    if (entries.size() == kMaxEntries) break;
    entries.push_back(it->path());
  }
  std::ranges::sort(entries);
  return entries;
}

}  // namespace smile::catalog::internal
