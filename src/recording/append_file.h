#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <span>
#include <string_view>

namespace smile::recording {

/// Append-only file, locked against other writers. The bytes of Append() are with the operating
/// system when it returns, so a process that dies loses nothing that was complete.
class AppendFile {
 public:
  enum Existence { kNew, kExisting };

  /// @throws std::runtime_error with path and reason, as every other member does: if a new file
  ///         exists already, or an existing one is being written by another process.
  explicit AppendFile(const std::filesystem::path& path, Existence existence = kNew);

  /// Truncates the file to its first `size` bytes.
  void Cut(std::uint64_t size);
  void Append(std::string_view text);
  void Append(std::span<const std::byte> bytes);
  std::uint64_t size() const { return size_; }

 private:
  std::filesystem::path path_;
  std::unique_ptr<std::FILE, int (*)(std::FILE*)> file_;
  std::uint64_t size_ = 0;
};

}  // namespace smile::recording
