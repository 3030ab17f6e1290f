#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <span>
#include <string_view>

namespace smile::record {

/// A file that grows. What Append() wrote is with the operating system when it returns, so a
/// process that dies loses nothing that was complete.
class AppendFile {
 public:
  /// Creates the file.
  /// @throws std::runtime_error with path and reason; so does every other member.
  explicit AppendFile(const std::filesystem::path& path);
  /// Goes on with an existing one; what is behind its first `size` bytes is cut off.
  AppendFile(const std::filesystem::path& path, std::uint64_t size);

  void Append(std::string_view text);
  void Append(std::span<const std::byte> bytes);
  std::uint64_t size() const { return size_; }

 private:
  std::filesystem::path path_;
  std::unique_ptr<std::FILE, int (*)(std::FILE*)> file_;
  std::uint64_t size_ = 0;
};

}  // namespace smile::record
