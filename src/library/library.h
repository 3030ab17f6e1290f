#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <mutex>
#include <optional>
#include <string>

#include "base/json.h"
#include "texts/message_error.h"

namespace smile::library {

/// Expected failure: the recording does not exist, or it cannot be changed now.
class LibraryError : public texts::MessageError {
 public:
  using MessageError::MessageError;
};

/// Folder in that of the recordings, with those that `smile generate` made (docs/generation.md).
inline constexpr const char* kGeneratedFolder = "generated";

/// Folder in that of the recordings, with the films that pages have made.
inline constexpr const char* kFilmFolder = "films";

/// Returns the id of the recording of an attempt: `towers:seed-0007`.
/// @param set      folder in kGeneratedFolder.
/// @param attempt  folder among its episodes or failures.
inline std::string AttemptId(const std::string& set, const std::string& attempt) {
  return set + ":" + attempt;
}

/// Library: the recordings in one folder, which users rename, search, delete and restore. An id is
/// the name of a recording's directory, there or in the bin; ids that lead anywhere else, or to a
/// link, are refused. Recordings of generated sets are not listed, and never changed; AttemptId()
/// is their id.
///
/// Thread-safe.
class Library {
 public:
  /// Maximal number of listed recordings, the newest.
  static constexpr std::size_t kMaxListed = 1000;
  /// Maximal size of a recording to be packed into one file [bytes].
  static constexpr std::uint64_t kMaxZipped = 256u << 20;

  explicit Library(std::filesystem::path root) : root_(std::move(root)) {}

  /// Returns the recordings, newest first:
  /// `[{"id","title","notes","scene","seconds","made","segments","binned"}]`, with the duration to
  /// the last frame of the classic view [s] and the time of the last recording (ISO 8601, UTC). A
  /// recording that cannot be read has an `error` instead.
  Json List() const;
  /// Returns a text that changes whenever recordings appear, disappear or change title or notes, in
  /// the folder or the bin, and whenever generated sets appear or disappear.
  std::string Stamp() const;
  /// Returns the directory of a recording, also of one in the bin or of a generated set.
  /// @throws LibraryError if there is no such recording. So do all below.
  std::filesystem::path DirectoryOf(const std::string& id) const;
  /// The same of a recording that may be changed: not of a generated set.
  std::filesystem::path ChangeableDirectoryOf(const std::string& id) const;
  /// Changes title and notes. Also throws as recording::Retitle().
  void Rename(const std::string& id, const std::optional<std::string>& title,
              const std::optional<std::string>& notes) const;
  /// Moves a recording into the folder `.bin` under the root; nothing is deleted. Fails while it is
  /// being recorded.
  /// @returns its id there, `um~1`: its name is free for the next recording.
  std::string Bin(const std::string& id) const;
  /// Moves a recording out of the bin.
  /// @returns its new id: the original one, with a number if that is taken.
  std::string Unbin(const std::string& id) const;
  /// Returns the timeline, see library/timeline.h.
  Json TimelineOf(const std::string& id) const;
  /// Returns all files of a recording as one ZIP file.
  /// @throws std::runtime_error if they exceed kMaxZipped, or cannot be read.
  std::string ZipOf(const std::string& id) const;

  const std::filesystem::path& root() const { return root_; }

 private:
  struct Place;
  /// Listed facts of a recording, with the stamp of its files.
  struct Listed {
    std::string stamp;
    Json entry;
  };
  std::vector<Place> Places() const;
  std::filesystem::path bin() const { return root_ / ".bin"; }

  std::filesystem::path root_;
  mutable std::mutex mutex_;                      ///< of the next member
  mutable std::map<std::string, Listed> listed_;  ///< by directory
};

}  // namespace smile::library
