#include "experiment/brain_setup.h"

#include "experiment/demonstration_frames.h"
#include "recording/attention.h"
#include "recording/recording.h"

namespace smile::experiment {

brain::BrainDriverOptions DriverOptionsFor(const std::filesystem::path& brain,
                                           const std::filesystem::path& demonstration,
                                           sim::Eye* eye) {
  // Frames are not read before the brain asks for them, see FramesOf(); attention goes to the brain
  // with its first message.
  brain::BrainDriverOptions options{
      .eye = eye, .may_read = brain::WhatMayBeRead(brain), .demonstration = demonstration};
  if (!demonstration.empty()) {
    options.attention = recording::AttentionOf(recording::OpenRecording(demonstration));
    options.frames = FramesOf(demonstration, eye);
  }
  return options;
}

Json ClaimJson(const std::optional<brain::Claim>& claim) {
  if (!claim) return nullptr;
  return {{"done", claim->is_done}, {"reason", claim->reason}};
}

}  // namespace smile::experiment
