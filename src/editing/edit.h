#pragma once

#include <variant>

#include "recording/demonstration.h"

namespace smile::editing {

// What can be done to a demonstration after the fact. Segments are called by the numbers they have
// in the recording, whatever was dropped or moved before.

/// Leaves out segments.
struct Drop {
  int first = 0, last = 0;

  bool operator==(const Drop&) const = default;
};

/// Puts a segment elsewhere: it becomes the action with this number. Segment 0 stays where it is.
struct Move {
  int segment = 0;
  int place = 1;  ///< 1 is the first

  bool operator==(const Move&) const = default;
};

/// Keeps only a part of a segment, and its action.
struct Trim {
  int segment = 0;
  double from = 0, to = 0;  ///< [s] from its begin

  bool operator==(const Trim&) const = default;
};

/// Shortens every longer pause, before a command and at the end, to this.
struct MaxPause {
  double seconds = 0;

  bool operator==(const MaxPause&) const = default;
};

/// Makes a segment last this long; its commands spread in proportion.
struct Retime {
  int segment = 0;
  double seconds = 0;

  bool operator==(const Retime&) const = default;
};

/// Makes everything so many times as fast, also the hands where a speed is given, and a robot that
/// follows a trajectory; to a pose at most at full speed.
struct Speed {
  double factor = 1;

  bool operator==(const Speed&) const = default;
};

using Edit = std::variant<Drop, Move, Trim, MaxPause, Retime, Speed>;

/// An edited demonstration lasts at most this long, or as long as it did [s].
inline constexpr double kMaxSeconds = 86400;
/// A factor of Speed is between this and its inverse.
inline constexpr double kMinFactor = 0.01;

/// The demonstration after an edit.
/// @throws std::invalid_argument saying what was found and what was expected.
recording::Demonstration Edited(recording::Demonstration demonstration, const Edit& edit);

}  // namespace smile::editing
