#pragma once

#include "library/view.h"
#include "page/server.h"

namespace smile::studio {

/// What to tell pages about where things are: the frames that moved since it was asked last; once a
/// second, and of another scene, all of them.
class PoseStream {
 public:
  /// To be called 60 times a second. Without frames there is nothing to tell.
  page::Poses Next(const library::View& view);
  /// The next is of all frames: somebody new has come.
  void TellAll() { told_.clear(); }

 private:
  scene::FramePoses told_;
  std::uint32_t scene_ = 0;
  int since_all_ = 0;
};

}  // namespace smile::studio
