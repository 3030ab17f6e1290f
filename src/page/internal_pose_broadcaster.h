#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "page/server.h"

namespace smile::page {

/// Pose broadcaster: stores the pose of each frame and when it last changed. A client that missed
/// some messages receives exactly the frames that moved since the last one it received.
class PoseBroadcaster {
 public:
  /// Counts changes; 0 before the first.
  using Version = std::uint64_t;

  /// Stores new poses. Only keys are accepted before the first key and when the scene changes.
  void Update(const Poses& poses);
  Version version() const { return version_; }
  std::uint32_t scene() const { return scene_; }
  std::uint32_t tick() const { return tick_; }

  struct Change {
    bool is_key = false;  ///< contains all frames
    std::uint16_t count = 0;
    std::shared_ptr<const std::string> bytes;  ///< see docs/studio-protocol.md
  };
  /// Returns the changes since version `known`.
  Change Since(Version known);

 private:
  std::uint32_t scene_ = 0, tick_ = 0;
  std::vector<float> values_;     ///< seven a frame
  std::vector<Version> changed_;  ///< version of the last change of each frame
  Version version_ = 0;
  Version key_ = 0;  ///< older versions need all frames
  Version cached_for_ = 0;
  Change cached_;  ///< nearly all clients know the same version
};

}  // namespace smile::page
