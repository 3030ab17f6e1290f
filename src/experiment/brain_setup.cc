#include "experiment/brain_setup.h"

#include "record/attention.h"
#include "record/recording.h"

namespace smile::experiment {

brain::BrainDriverOptions DriverOptionsFor(const std::filesystem::path& brain,
                                           const std::filesystem::path& demonstration) {
  brain::BrainDriverOptions options{.has_trackers = brain::MayReadTrackers(brain),
                                    .demonstration = demonstration};
  if (!demonstration.empty()) {
    options.attention = record::AttentionOf(record::OpenRecording(demonstration));
  }
  return options;
}

}  // namespace smile::experiment
