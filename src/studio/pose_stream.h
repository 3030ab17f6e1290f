#pragma once

#include "library/displayed_state.h"
#include "page/server.h"

namespace smile::studio {

/// Pose stream: selects the frames that moved since the last call; all frames once a second and
/// when the scene changes.
class PoseStream {
 public:
  /// Returns the poses to send; called 60 times a second. Without frames nothing has to be sent.
  page::Poses Next(const library::DisplayedState& view);

 private:
  scene::FramePoses sent_;
  std::uint32_t scene_ = 0;
  int since_all_ = 0;
};

}  // namespace smile::studio
