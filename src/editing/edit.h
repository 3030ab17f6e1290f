#pragma once

#include <variant>

#include "recording/demonstration.h"

namespace smile::editing {

// Edits of a recorded demonstration. Segments are identified by their numbers in the recording,
// whatever was dropped or moved before.

/// Drops segments.
struct Drop {
  int first = 0, last = 0;

  bool operator==(const Drop&) const = default;
};

/// Moves a segment: it becomes the action with this number. Segment 0 cannot be moved.
struct Move {
  int segment = 0;
  int place = 1;  ///< 1 is the first

  bool operator==(const Move&) const = default;
};

/// Trims a segment to a range of time; its action stays.
struct Trim {
  int segment = 0;
  double from = 0, to = 0;  ///< [s] from its begin

  bool operator==(const Trim&) const = default;
};

/// Limits the length of pauses, before commands and at the ends of segments.
struct MaxPause {
  double seconds = 0;

  bool operator==(const MaxPause&) const = default;
};

/// Sets the duration of a segment; its commands are spread in proportion.
struct Retime {
  int segment = 0;
  double seconds = 0;

  bool operator==(const Retime&) const = default;
};

/// Multiplies the speed of everything by a factor, including hands where a speed is given, and a
/// robot that follows a trajectory; motions to a pose are limited to full speed.
struct Speed {
  double factor = 1;

  bool operator==(const Speed&) const = default;
};

/// Shifts in time what one hand does in segments, while all else stays as it is: up to the commands
/// of that hand before and after it. The result has no pauses.
struct Shift {
  int first = 0, last = 0;  ///< begins with an action of the hand
  double seconds = 0;       ///< later; negative for earlier

  bool operator==(const Shift&) const = default;
};

/// Stretches in time what one hand does in segments, while all else stays as it is: at most up to
/// the next command of that hand. The result has no pauses.
struct Stretch {
  int first = 0, last = 0;  ///< begins with an action of the hand
  double factor = 1;        ///< of its duration

  bool operator==(const Stretch&) const = default;
};

using Edit = std::variant<Drop, Move, Trim, MaxPause, Retime, Speed, Shift, Stretch>;

/// Longest duration of an edited demonstration, unless it was longer before [s].
inline constexpr double kMaxSeconds = 86400;
/// Least factor of Speed and Stretch; the greatest is its inverse.
inline constexpr double kMinFactor = 0.01;

/// Returns the demonstration after an edit.
/// @throws std::invalid_argument saying what was found and what was expected.
recording::Demonstration Edited(recording::Demonstration demonstration, const Edit& edit);

}  // namespace smile::editing
