#include "experiment/folder_lock.h"

#include <fcntl.h>
#include <sys/file.h>

#include <cerrno>
#include <cstring>
#include <stdexcept>
#include <string>

#include "base/files.h"

namespace smile::experiment {

FolderLock::FolderLock(const std::filesystem::path& folder, std::string_view work) {
  MakeDirectories(folder);
  // The folder itself is locked: no lock file is needed, and the system releases the lock with the
  // process. O_CLOEXEC keeps it from the runs, which would hold it beyond the work's end.
  folder_ = process::UniqueFd(open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (!folder_) {
    throw std::runtime_error(folder.string() + ": cannot be opened: " + std::strerror(errno));
  }
  if (flock(folder_.get(), LOCK_EX | LOCK_NB) != 0) {
    throw std::runtime_error(folder.string() + ": another " + std::string(work) +
                             " is writing its results there");
  }
}

}  // namespace smile::experiment
