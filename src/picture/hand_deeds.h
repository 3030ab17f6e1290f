#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "model/model.h"
#include "picture/hand_anatomy.h"
#include "picture/touch.h"
#include "recording/recording.h"

namespace smile::picture {

/// From when to when a hand is at an object, and where.
struct HandDeed {
  enum class Kind {
    kHold,   ///< takes hold of it
    kTouch,  ///< touches it for a moment with the index finger: points, triggers
    kTurn,   ///< fastens or loosens it, for a moment
  };

  Kind kind = Kind::kHold;
  std::uint64_t first = 0, last = 0;  ///< ticks, both included
  model::ObjectIndex object{0};
  model::FrameIndex frame{0};      ///< the object's
  Vector3 p_BQ = Vector3::Zero();  ///< the place, in the object's body B [m]
  scene::VisualState begin;        ///< how everything is when it begins
};

/// What each of the two hands does, in order of time; never two things at once.
struct HandDeeds {
  std::array<std::vector<HandDeed>, kSides.size()> of;
};

/// What the demonstrator of a recording did, by its trace and its log, with two hands: `both` are
/// the two, `any` is the one that does nothing else meanwhile, and of two that are free the one on
/// whose side of the table the object is.
///
/// Some demonstrations call hands as the person would who has them, others as they are seen from
/// the robot's side of the table. Either way the hand at +x is the person's left; `left` is meant
/// to be the one with which the arms cross less.
/// @throws InputError if the trace cannot be read, or is of the old format that does not tell what
///         hands did.
HandDeeds DeedsIn(const recording::Recording& recording, const Touch& touch);

}  // namespace smile::picture
