#pragma once

#include <filesystem>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "library/library.h"

namespace smile::sharing {

/// Link at which anyone who has it sees one recording.
struct ShareLink {
  std::string secret;     ///< web_server::RandomSecret()
  std::string recording;  ///< id in the library
  std::string directory;  ///< identity of its directory, so that no other one takes its place
  std::string made;       ///< ISO 8601, UTC

  bool operator==(const ShareLink&) const = default;
};

/// Share links: the links of a library's recordings. They are kept in the folder `.sharing` of the
/// library, which only its owner can read, and survive the end of the program.
///
/// Thread-safe. All members throw InputError if the file of links is damaged, and
/// std::runtime_error if it cannot be read or written.
class ShareLinks {
 public:
  static constexpr std::size_t kMaxLinks = 1000;  ///< of all recordings

  /// @param library  must outlive this.
  explicit ShareLinks(const library::Library* library) : library_(library) {}

  /// Makes a new link.
  /// @throws library::LibraryError if there is no such recording, it is in the bin, or there are
  ///         kMaxLinks links.
  ShareLink Make(const std::string& recording);
  /// Returns the links of a recording, oldest first.
  std::vector<ShareLink> Of(const std::string& recording) const;
  /// Ends a link of a recording for good.
  /// @throws library::LibraryError if the recording has no such link.
  void Stop(const std::string& recording, const std::string& secret);
  /// Ends all links of a recording for good.
  void StopAll(const std::string& recording);
  /// Returns the link with a secret; nullopt if there is none, or its recording is gone. All
  /// secrets are compared, each in constant time.
  std::optional<ShareLink> Find(std::string_view secret) const;

  /// Returns the file of links.
  std::filesystem::path file() const { return library_->root() / ".sharing" / "links.json"; }

 private:
  /// Returns the links of the file; the caller holds mutex_.
  const std::vector<ShareLink>& Read() const;
  void Write(const std::vector<ShareLink>& links);
  /// Returns true if a link's recording is where it was when the link was made.
  bool IsThere(const ShareLink& link) const;

  const library::Library* library_;
  mutable std::mutex mutex_;   ///< guards the file and the members below
  mutable std::string stamp_;  ///< of the file that was read last
  mutable std::vector<ShareLink> links_;
};

}  // namespace smile::sharing
