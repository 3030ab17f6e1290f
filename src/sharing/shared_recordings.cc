#include "sharing/shared_recordings.h"

#include <algorithm>
#include <stdexcept>

#include "base/file_state.h"

namespace smile::sharing {
namespace {

/// Returns a text that changes whenever what is shared of a recording changes.
std::string KeyOf(const std::filesystem::path& directory) {
  std::string key = directory.string();
  for (const char* file : {"demo.json", "trace.bin", "frames.csv", "commands.jsonl"}) {
    key += "|" + StampOf(directory / file);
  }
  return key;
}

}  // namespace

std::shared_ptr<const SharedRecording> SharedRecordings::Find(const std::string& key) {
  const std::lock_guard lock(mutex_);
  const auto found = std::ranges::find(kept_, key, &Kept::first);
  if (found == kept_.end()) return nullptr;
  std::rotate(found, found + 1, kept_.end());
  return kept_.back().second;
}

void SharedRecordings::Keep(Kept made) {
  const std::lock_guard lock(mutex_);
  kept_.push_back(std::move(made));
  if (kept_.size() > kMaxKept) kept_.pop_front();
}

std::shared_ptr<const SharedRecording> SharedRecordings::Get(
    const std::filesystem::path& directory) {
  const std::string key = KeyOf(directory);
  if (auto kept = Find(key)) return kept;
  {
    const std::lock_guard lock(mutex_);
    // Each waiting caller occupies a thread of the web server.
    if (num_waiting_ > kMaxWaiting) throw std::runtime_error("too many wait for a recording");
    ++num_waiting_;
  }
  std::unique_lock making(making_);
  const auto leave = [this](void*) {
    const std::lock_guard lock(mutex_);
    --num_waiting_;
  };
  const std::unique_ptr<void, decltype(leave)> waiting(this, leave);
  if (auto kept = Find(key)) return kept;
  auto made = std::make_shared<const SharedRecording>(directory);
  Keep({key, made});
  return made;
}

}  // namespace smile::sharing
