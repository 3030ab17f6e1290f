#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <vector>

namespace smile {

/// File that is read in windows: only the parts that are asked for, of a file of any size.
///
/// A jump reads 4 KiB. Each window that continues the one before has twice its size, up to 256 KiB,
/// so that a place costs little and reading on costs few calls.
class FileWindows {
 public:
  /// Opens a file.
  /// @throws InputError if it does not exist or is not a regular file; std::runtime_error with path
  ///         and reason if it cannot be opened.
  explicit FileWindows(const std::filesystem::path& path);
  ~FileWindows();
  FileWindows(FileWindows&& other) noexcept;
  FileWindows& operator=(FileWindows&&) = delete;

  /// Returns the size of the file when it was opened [bytes]; bytes appended since do not count.
  std::uint64_t size() const { return size_; }
  /// Returns `count` bytes from a place on; fewer at the end of the file, also if it has become
  /// shorter. Valid until the next call.
  /// @throws std::runtime_error with path and reason if they cannot be read.
  std::span<const std::byte> At(std::uint64_t place, std::size_t count);

  /// Returns the number of bytes read from the file so far.
  std::uint64_t bytes_read() const { return bytes_read_; }

 private:
  /// Reads a window that begins at a place.
  void Load(std::uint64_t place, std::size_t count);

  std::filesystem::path path_;
  int file_ = -1;
  std::uint64_t size_ = 0;
  std::vector<std::byte> window_;
  std::uint64_t window_place_ = 0;
  std::size_t next_window_ = 0;  ///< size of the next window if it continues this one
  std::uint64_t bytes_read_ = 0;
};

}  // namespace smile
