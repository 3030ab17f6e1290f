#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "model/model.h"
#include "picture/hand_anatomy.h"
#include "picture/surface_probe.h"
#include "recording/recording.h"

namespace smile::picture {

/// Interval of time in which a hand is in contact with an object.
struct ContactInterval {
  enum class Kind {
    kHold,   ///< holds it
    kTouch,  ///< touches it for a moment with the index finger: points, triggers
    kTurn,   ///< fastens or loosens it, for a moment
  };

  Kind kind = Kind::kHold;
  std::uint64_t first = 0, last = 0;  ///< ticks, both included
  model::ObjectIndex object{0};
  model::FrameIndex frame{0};      ///< the object's
  Vector3 p_BQ = Vector3::Zero();  ///< contact point, in the object's body B [m]
  scene::VisualState begin;        ///< at its begin
};

/// Contact intervals of each of the two hands, in chronological order, not overlapping.
struct HandSchedule {
  std::array<std::vector<ContactInterval>, kHandSides.size()> of;
};

/// Assigns the actions of a recording's demonstrator to two hands, from its trace and its log:
/// `both` means the two, `any` the one that is free meanwhile, and if both are, the one on whose
/// side of the table the object is.
///
/// Some demonstrations name hands from the person's point of view, others from the robot's. Either
/// way the hand at +x is the person's left; `left` is assigned to the one with which the arms cross
/// less.
/// @throws InputError if the trace cannot be read, or its format is too old to contain the actions
///         of hands.
HandSchedule HandScheduleOf(const recording::Recording& recording, const SurfaceProbe& probe);

}  // namespace smile::picture
