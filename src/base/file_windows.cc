// Positional reads, and not a mapping of the file: if a mapped file becomes shorter, because
// another program cuts it or a network drive fails, the access to its missing pages ends the
// program by a signal. A positional read then returns fewer bytes, which is checked here like any
// other end.

#include "base/file_windows.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <stdexcept>
#include <string>
#include <utility>

#include "base/diagnostic.h"

namespace smile {
namespace {

constexpr std::size_t kFirstWindow = std::size_t{4} << 10, kLargestWindow = std::size_t{256} << 10;

[[noreturn]] void Fail(const std::filesystem::path& path, const char* what) {
  throw std::runtime_error(path.string() + ": " + what + ": " + std::strerror(errno));
}

}  // namespace

// O_NONBLOCK: opening a pipe must not wait for its writer. Reads of regular files are not affected.
FileWindows::FileWindows(const std::filesystem::path& path)
    : path_(path), file_(open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK)) {
  if (file_ < 0 && (errno == ENOENT || errno == ENOTDIR))
    throw InputError({path.string(), 0, "", "no such file"});
  if (file_ < 0) Fail(path, "cannot be opened");
  struct stat found {};
  const bool is_known = fstat(file_, &found) == 0;
  if (is_known && S_ISREG(found.st_mode)) {
    size_ = static_cast<std::uint64_t>(found.st_size);
    return;
  }
  close(file_);
  if (!is_known) Fail(path, "cannot be read");
  throw InputError({path.string(), 0, "", "is not a regular file"});
}

FileWindows::~FileWindows() {
  if (file_ >= 0) close(file_);
}

FileWindows::FileWindows(FileWindows&& other) noexcept
    : path_(std::move(other.path_)),
      file_(std::exchange(other.file_, -1)),
      size_(other.size_),
      window_(std::move(other.window_)),
      window_place_(other.window_place_),
      next_window_(other.next_window_),
      bytes_read_(other.bytes_read_) {}

std::span<const std::byte> FileWindows::At(std::uint64_t place, std::size_t count) {
  if (place >= size_) return {};
  count = static_cast<std::size_t>(std::min<std::uint64_t>(count, size_ - place));
  const auto is_loaded = [&] {
    return place >= window_place_ && place - window_place_ <= window_.size() &&
           count <= window_.size() - (place - window_place_);
  };
  if (!is_loaded()) Load(place, count);
  // Fewer bytes than asked for only if the file has become shorter.
  const auto window = std::span<const std::byte>(window_).subspan(place - window_place_);
  return window.first(std::min(count, window.size()));
}

void FileWindows::Load(std::uint64_t place, std::size_t count) {
  const bool continues =
      !window_.empty() && place >= window_place_ && place - window_place_ <= window_.size();
  const std::size_t size = continues ? next_window_ : kFirstWindow;
  next_window_ = std::min(2 * size, kLargestWindow);
  window_.resize(
      static_cast<std::size_t>(std::min<std::uint64_t>(std::max(size, count), size_ - place)));
  window_place_ = place;
  std::size_t num_read = 0;
  while (num_read < window_.size()) {
    const ssize_t now = pread(file_, window_.data() + num_read, window_.size() - num_read,
                              static_cast<off_t>(place + num_read));
    if (now < 0 && errno == EINTR) continue;
    if (now < 0) {
      window_.clear();
      Fail(path_, "cannot be read");
    }
    if (now == 0) break;
    num_read += static_cast<std::size_t>(now);
  }
  window_.resize(num_read);
  bytes_read_ += num_read;
}

}  // namespace smile
