#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "page/page_meshes.h"

namespace smile::sharing {

/// Recording as a page plays it by itself.
struct PageRecording {
  std::string bytes;  ///< docs/studio-protocol.md specifies them
  std::unique_ptr<const page::PageMeshes> meshes;
  /// Files of the pictures of the robot's eye: paths from the recording's directory.
  std::vector<std::string> eye_pictures;
};

/// Number of a shared recording's scene in messages.
inline constexpr std::uint32_t kSharedScene = 1;
/// Limits of a shared recording.
inline constexpr std::size_t kMaxSharedBytes = 96u << 20, kMaxSharedChanges = 20'000,
                             kMaxSharedEvents = 5000;

/// Reads a recording from its trace, without physics.
/// @throws InputError if it cannot be read, or exceeds a limit.
PageRecording ReadForPage(const std::filesystem::path& directory);

/// Shared recording: everything that pages need to play a recording, computed once. Immutable, so
/// that any thread may read.
class SharedRecording {
 public:
  /// @throws as ReadForPage().
  explicit SharedRecording(const std::filesystem::path& directory);

  /// Returns the recording for a page, compressed by gzip.
  const std::shared_ptr<const std::string>& gzipped() const { return gzipped_; }
  const page::PageMeshes& meshes() const { return *meshes_; }
  /// Returns the file of a picture of the robot's eye, a path from the recording's directory;
  /// nullopt if there is no such picture.
  std::optional<std::string> EyePicture(std::size_t number) const;

 private:
  std::shared_ptr<const std::string> gzipped_;
  std::unique_ptr<const page::PageMeshes> meshes_;
  std::vector<std::string> eye_pictures_;
};

}  // namespace smile::sharing
