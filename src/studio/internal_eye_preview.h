#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "image/image.h"
#include "sim/eye.h"
#include "studio/internal_session_state.h"
#include "studio/live_world.h"

namespace smile::studio {

/// What people see through the robot's eye: the pictures that are recorded, and between them up to
/// four a second when something else is to be seen.
class EyePreview {
 public:
  struct Picture {
    Image image;
    bool is_recorded = false;
  };

  /// @param eye  nullptr for no pictures; must outlive this.
  explicit EyePreview(sim::Eye* eye) : eye_(eye) {}

  /// To be called after each tick.
  /// @returns why the eye cannot draw, once.
  std::optional<std::string> Look(LiveWorld* world, const SessionState& shown);
  /// Somebody waits for a picture, whatever was seen before.
  void Forget() const { seen_.reset(); }
  /// The last picture since this was last asked.
  std::optional<Picture> Take() { return std::exchange(picture_, std::nullopt); }

 private:
  sim::Eye* eye_;
  bool is_broken_ = false;  ///< it cannot draw, which was reported
  std::uint64_t num_calls_ = 0;
  std::optional<Picture> picture_;
  mutable std::optional<sim::ViewSample>
      seen_;  ///< at last; nullopt when somebody waits for a picture
};

}  // namespace smile::studio
