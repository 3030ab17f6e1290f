#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "image/image.h"
#include "sim/eye.h"
#include "studio/internal_session_state.h"
#include "studio/live_world.h"

namespace smile::studio {

/// Preview of the robot's eye for people: the recorded pictures, and between them up to four a
/// second if the view has changed.
class EyePreview {
 public:
  struct Picture {
    Image image;
    bool is_recorded = false;
  };

  /// @param eye  nullptr for no pictures; must outlive this.
  explicit EyePreview(sim::Eye* eye) : eye_(eye) {}

  /// To be called after each tick.
  /// @returns the reason why the eye cannot draw, once.
  std::optional<std::string> Update(LiveWorld* world, const SessionState& shown);
  /// Requests a new picture even if the view has not changed.
  void Reset() const { seen_.reset(); }
  /// Returns the last picture since the last call.
  std::optional<Picture> Take() { return std::exchange(picture_, std::nullopt); }

 private:
  sim::Eye* eye_;
  bool is_broken_ = false;  ///< it cannot draw; reported already
  std::uint64_t num_calls_ = 0;
  std::optional<Picture> picture_;
  mutable std::optional<sim::ViewSample>
      seen_;  ///< view of the last picture; nullopt requests a new one
};

}  // namespace smile::studio
