#include "recording/beginning.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <system_error>

#include "base/files.h"
#include "recording/recording.h"

// A recording can be opened once its demo.json exists, which is written last. Until then a mark
// file with a lock shows that its program is alive; a directory with a mark and without a lock was
// abandoned and may be replaced.

namespace smile::recording {
namespace {

constexpr const char* kMark = ".smile-beginning";

/// Makes the directory, without the rest of an abandoned beginning, and returns the path of its
/// mark.
std::filesystem::path MakeRoom(const std::filesystem::path& directory) {
  if (IsAbandoned(directory)) {
    std::error_code error;  // errors are ignored here: writing the mark will report them
    std::filesystem::remove_all(directory, error);
  }
  MakeDirectories(directory);
  return directory / kMark;
}

}  // namespace

BeginningMark::BeginningMark(const std::filesystem::path& directory)
    : path_(MakeRoom(directory)), lock_(path_, AppendFile::kNew) {}

void BeginningMark::Remove() {
  std::error_code error;  // a mark in a recording that can be opened does no harm
  std::filesystem::remove(path_, error);
}

bool IsAbandoned(const std::filesystem::path& directory) {
  if (IsRecording(directory)) return false;
  // The process that begins a recording holds an exclusive lock, which ends with the process. A
  // shared lock is granted only if no such process is alive. O_NOFOLLOW: a link is no mark.
  const int file = open((directory / kMark).c_str(), O_RDONLY | O_CLOEXEC | O_NOFOLLOW);
  if (file < 0) return false;
  const bool is_free = flock(file, LOCK_SH | LOCK_NB) == 0;
  close(file);
  return is_free;
}

}  // namespace smile::recording
