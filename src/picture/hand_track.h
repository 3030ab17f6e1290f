#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "picture/hand_anatomy.h"
#include "picture/hand_schedule.h"
#include "recording/recording.h"

namespace smile::picture {

/// A hand that has no time for the way to its next object arrives late rather than faster [m/s].
inline constexpr double kFastestHand = 1.4;

/// How the two hands of a demonstrator moved whom nobody saw: a function of the recording alone, so
/// that every view of a moment shows the same.
///
/// A hand that holds something follows it. From one object to the next it goes in an arc, or back
/// to where it rests beyond the table's edge when there is time for both ways.
class HandTrack {
 public:
  /// Throws as HandScheduleOf() does.
  explicit HandTrack(const recording::Recording& recording);

  /// The two hands, left first; of a tick that the trace does not tell, as at the one before.
  const std::array<HandPosture, kSides.size()>& At(std::uint64_t tick) const;
  /// Returns the contacts of the hands, for tests.
  const HandSchedule& schedule() const { return schedule_; }

 private:
  struct Sample {
    std::uint64_t tick = 0;
    std::array<HandPosture, kSides.size()> hands;
  };

  HandSchedule schedule_;
  std::vector<Sample> samples_;  ///< by tick; never empty
};

}  // namespace smile::picture
