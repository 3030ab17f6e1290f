#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "picture/hand_anatomy.h"
#include "picture/hand_schedule.h"
#include "recording/recording.h"

namespace smile::picture {

/// Speed limit of a hand: without time for the way to its next object, it arrives late and not
/// faster [m/s].
inline constexpr double kFastestHand = 1.4;

/// Plausible motion of a demonstrator's two hands, which were not recorded: a function of the
/// recording alone, so that every view of a tick shows the same.
///
/// A hand that holds an object follows it. Between objects it moves in an arc, or back to rest
/// beyond the table's edge if there is time for both ways.
class HandTrack {
 public:
  /// Throws as HandScheduleOf() does.
  explicit HandTrack(const recording::Recording& recording);

  /// Returns the two hands, left first; for a tick that is not in the trace, those at the one
  /// before.
  const std::array<HandPosture, kHandSides.size()>& At(std::uint64_t tick) const;
  /// Returns the contacts of the hands, for tests.
  const HandSchedule& schedule() const { return schedule_; }

 private:
  struct Sample {
    std::uint64_t tick = 0;
    std::array<HandPosture, kHandSides.size()> hands;
  };

  HandSchedule schedule_;
  std::vector<Sample> samples_;  ///< by tick; never empty
};

}  // namespace smile::picture
