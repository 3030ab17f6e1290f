#include "motion/internal_probe_store.h"

#include <algorithm>

namespace smile::motion {
namespace {

/// As many as a plan alternates between: both hands with nothing, and with a thing in each of the
/// holds that are tried.
constexpr std::size_t kMostKept = 64;

}  // namespace

std::unique_ptr<ArticulationProbe> ProbeStore::Take(const Setting& setting) {
  const std::lock_guard lock(mutex_);
  const auto found = std::ranges::find(kept_, setting, [](const auto& it) { return it.first; });
  if (found == kept_.end()) return nullptr;
  std::unique_ptr<ArticulationProbe> probe = std::move(found->second);
  kept_.erase(found);
  return probe;
}

void ProbeStore::GiveBack(const Setting& setting, std::unique_ptr<ArticulationProbe> probe) {
  const std::lock_guard lock(mutex_);
  kept_.emplace_front(setting, std::move(probe));
  if (kept_.size() > kMostKept) kept_.pop_back();
}

}  // namespace smile::motion
