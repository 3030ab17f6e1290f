#pragma once

#include <array>

#include "base/bytes.h"
#include "mechanics/joint.h"

namespace smile::mechanics {

/// State of a slider's rail between steps. With damping 1 the slider is held at an offset; a limit
/// that was pressed in the last step holds in both directions.
struct RailState {
  bool is_held = false;
  double held_offset = 0;            ///< [m]
  std::array<bool, 2> is_pressed{};  ///< lower and upper limit, in the last step

  /// Call before each step: holds a slider with damping 1 at its offset, unless a hand moves it.
  /// @param offset  at present [m].
  void HoldUnless(bool is_carried, double offset, const SliderJointSpec& rail);
  /// Reports the impulse inwards of a limit after a step [N s].
  /// @param is_upper  of which limit.
  /// @param bounces  true if the slider rebounds from it.
  void NoteImpulse(bool is_upper, double inwards, bool bounces);

  void Save(ByteWriter* out) const;
  void Restore(ByteReader* in);
};

}  // namespace smile::mechanics
