#include "base/file_state.h"

#include <sys/stat.h>

namespace smile {

FileState StateOf(const std::filesystem::path& path) {
  struct stat found {};
  // A link itself is examined and not its target, so that its replacement is noticed.
  if (lstat(path.c_str(), &found) != 0) return {};
  return {.is_directory = S_ISDIR(found.st_mode),
          .is_file = S_ISREG(found.st_mode),
          .number = found.st_ino,
          .size = static_cast<std::uint64_t>(found.st_size),
          .changed = found.st_mtim.tv_sec * 1'000'000'000LL + found.st_mtim.tv_nsec};
}

std::string StampOf(const std::filesystem::path& path) {
  const FileState state = StateOf(path);
  // The inode notices a replacement of equal size within the resolution of the clock.
  return std::to_string(state.number) + "," + std::to_string(state.size) + "," +
         std::to_string(state.changed);
}

}  // namespace smile
