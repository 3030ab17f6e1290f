#include "experiment/brain_setup.h"

#include "recording/attention.h"
#include "recording/recording.h"

namespace smile::experiment {

brain::BrainDriverOptions DriverOptionsFor(const std::filesystem::path& brain,
                                           const std::filesystem::path& demonstration) {
  brain::BrainDriverOptions options{.has_trackers = brain::MayReadTrackers(brain),
                                    .demonstration = demonstration};
  if (!demonstration.empty()) {
    options.attention = recording::AttentionOf(recording::OpenRecording(demonstration));
  }
  return options;
}

}  // namespace smile::experiment
