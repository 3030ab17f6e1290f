#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "page/server.h"

namespace smile::page {

/// Where all frames are, and since when: whoever missed some moments is told of each frame that
/// moved since the last one they know, and of no other.
class PoseBoard {
 public:
  /// Counts moments at which something changed; 0 before the first.
  using Version = std::uint64_t;

  /// Before the first key, and when the scene is another, only keys are taken.
  void Show(const Poses& poses);
  Version version() const { return version_; }
  std::uint32_t scene() const { return scene_; }
  std::uint32_t tick() const { return tick_; }

  struct Change {
    bool is_key = false;  ///< all frames are in it
    std::uint16_t count = 0;
    std::shared_ptr<const std::string> bytes;  ///< as docs/studio-protocol.md has them
  };
  /// What is new to those who know version `known`.
  Change Since(Version known);

 private:
  std::uint32_t scene_ = 0, tick_ = 0;
  std::vector<float> values_;     ///< seven a frame
  std::vector<Version> changed_;  ///< when each frame moved last
  Version version_ = 0;
  Version key_ = 0;  ///< who knows less is told everything
  Version cached_for_ = 0;
  Change cached_;  ///< nearly all clients know the same
};

}  // namespace smile::page
