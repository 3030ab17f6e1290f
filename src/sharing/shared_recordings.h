#pragma once

#include <deque>
#include <filesystem>
#include <memory>
#include <mutex>
#include <string>
#include <utility>

#include "sharing/shared_recording.h"

namespace smile::sharing {

/// Shared recordings: makes them one at a time, and keeps those that were used last, as long as
/// their files stay the same. Thread-safe.
class SharedRecordings {
 public:
  static constexpr std::size_t kMaxKept = 16;
  static constexpr int kMaxWaiting = 2;  ///< callers that wait while one is made

  /// Returns the recording of a directory; waits until it is made.
  /// @throws InputError as SharedRecording() does; std::runtime_error if too many others wait.
  std::shared_ptr<const SharedRecording> Get(const std::filesystem::path& directory);

 private:
  using Kept = std::pair<std::string, std::shared_ptr<const SharedRecording>>;
  /// Returns nullptr if it is not kept.
  std::shared_ptr<const SharedRecording> Find(const std::string& key);
  void Keep(Kept made);

  std::mutex making_;  ///< held while a recording is made; taken before mutex_
  std::mutex mutex_;   ///< guards all members below
  int num_waiting_ = 0;
  std::deque<Kept>
      kept_;  ///< by directory and state of its files, the one that was used last at the end
};

}  // namespace smile::sharing
