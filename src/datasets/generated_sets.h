#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <mutex>
#include <string>
#include <vector>

#include "base/json.h"
#include "experiment/attempts.h"

namespace smile::datasets {

/// Generated sets: the folders of `smile generate` in the folder `generated` of a library. The
/// folders are the truth; what was read is kept while it is there.
///
/// Thread-safe.
class GeneratedSets {
 public:
  static constexpr std::size_t kMaxSets = 200;       ///< listed, the newest
  static constexpr std::size_t kMaxAttempts = 5000;  ///< described of a set

  /// @param library  folder of the recordings.
  explicit GeneratedSets(std::filesystem::path library);

  /// Returns the folder of a set, which need not exist.
  /// @throws page::RequestError if the name is none, or `generated` is a recording.
  std::filesystem::path FolderFor(const std::string& name) const;
  /// Returns the folder of a set.
  /// @throws page::RequestError if there is no such set.
  std::filesystem::path FolderOf(const std::string& name) const;
  /// Returns the file with the request that made a set, if a page did.
  std::filesystem::path RequestFileOf(const std::string& name) const;

  /// Gives a set, which nothing may be using, another name.
  /// @throws page::RequestError if that is taken.
  void Rename(const std::string& name, const std::string& new_name);
  /// Moves a set, which nothing may be using, into the folder `.bin` beside it; nothing is deleted.
  /// @returns its name there: the same, with a number if that is taken.
  std::string Bin(const std::string& name);
  /// Moves a set out of the bin.
  /// @returns its new name: the same, with a number if that is taken.
  std::string Unbin(const std::string& name);

  /// Returns the sets, newest first, as Describe() does, then those in the bin.
  Json List();
  /// Returns `{"name","scene","level","brain","wanted","episodes","attempts","yield","interval",
  /// "causes","is_complete","can_continue","binned","picture"}`.
  Json Describe(const std::string& name);
  /// Returns the attempts, by seed: `[{"recording","seed","episode","try","outcome","cause",
  /// "score","seconds","scene","level"}]`.
  Json AttemptsOf(const std::string& name);
  /// Returns how far a generation is: `{"done","total","attempts","causes"}`.
  Json ProgressOf(const std::string& name, std::size_t wanted);

 private:
  struct Known {
    std::string stamp;  ///< of the file it was read from
    experiment::EndedAttempt ended;
  };
  using Attempts = std::map<std::filesystem::path, Known>;

  std::filesystem::path bin() const { return root_ / ".bin"; }
  Json DescribeFolder(const std::filesystem::path& folder);
  /// Moves a set with the files beside it.
  void Move(const std::filesystem::path& from, const std::filesystem::path& to);
  /// Reads the attempts that have come since, and forgets those that are gone.
  std::vector<experiment::EndedAttempt> Read(const std::filesystem::path& folder);

  std::filesystem::path library_, root_;
  std::mutex mutex_;                                 ///< of the next member
  std::map<std::filesystem::path, Attempts> known_;  ///< by folder of the set
};

}  // namespace smile::datasets
