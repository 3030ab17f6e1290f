#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <mutex>
#include <optional>
#include <stdexcept>
#include <string>

#include "base/json.h"

namespace smile::library {

/// An ordinary no: there is no such recording, or it cannot be changed now.
class LibraryError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The recordings in one folder, which users name, look for, throw away and take back. An id is the
/// name of a recording's directory, there or in the bin; ids from outside that name anything else,
/// or a link, are refused.
///
/// May be used from several threads at once.
class Library {
 public:
  /// Listed at most, the newest.
  static constexpr std::size_t kMaxListed = 1000;
  /// Larger ones are not put into one file [bytes].
  static constexpr std::uint64_t kMaxZipped = 256u << 20;

  explicit Library(std::filesystem::path root) : root_(std::move(root)) {}

  /// Newest first: `[{"id","title","notes","scene","seconds","made","segments","binned"}]`, to the
  /// last frame of its classic view [s], and when it was last recorded into (ISO 8601, UTC). One
  /// that cannot be read has an `error` instead.
  Json List() const;
  /// Differs after recordings came, went or got other titles or notes, in the folder or the bin.
  std::string Stamp() const;
  /// Also of one in the bin.
  /// @throws LibraryError if there is no such recording. So do all below.
  std::filesystem::path DirectoryOf(const std::string& id) const;
  /// Throws as recording::Retitle(), too.
  void Rename(const std::string& id, const std::optional<std::string>& title,
              const std::optional<std::string>& notes) const;
  /// Into the folder `.bin` under the root; nothing is ever deleted. Not while it is recorded.
  /// @returns its id there, `um~1`: what is recorded next under its name is another.
  std::string Bin(const std::string& id) const;
  /// @returns its id from now on: the one it had, with a number if that is taken.
  std::string Unbin(const std::string& id) const;
  /// See library/timeline.h.
  Json TimelineOf(const std::string& id) const;
  /// All its files in one, as they are now.
  /// @throws std::runtime_error if they are more than kMaxZipped, or cannot be read.
  std::string ZipOf(const std::string& id) const;

  const std::filesystem::path& root() const { return root_; }

 private:
  struct Place;
  /// What was listed, and of which state of its files.
  struct Listed {
    std::string stamp;
    Json entry;
  };
  std::vector<Place> Places() const;
  std::filesystem::path bin() const { return root_ / ".bin"; }

  std::filesystem::path root_;
  mutable std::mutex mutex_;                      ///< of what follows
  mutable std::map<std::string, Listed> listed_;  ///< by directory
};

}  // namespace smile::library
