#pragma once

#include <cstddef>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <span>
#include <string_view>

namespace smile::record {

/// A file that only grows. What Append() wrote is with the operating system when it returns, so a
/// process that dies loses nothing that was complete.
class AppendFile {
 public:
  /// Creates the file.
  /// @throws std::runtime_error with path and reason; so does every other member.
  explicit AppendFile(const std::filesystem::path& path);

  void Append(std::string_view text);
  void Append(std::span<const std::byte> bytes);

 private:
  std::filesystem::path path_;
  std::unique_ptr<std::FILE, int (*)(std::FILE*)> file_;
};

}  // namespace smile::record
