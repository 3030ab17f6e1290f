#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "math/angles.h"
#include "recording/demonstration.h"
#include "replay/replay.h"
#include "sim/eye.h"

namespace smile::editing {

/// Command that is refused in the edited demonstration and therefore skipped.
struct SkippedCommand {
  std::size_t line = 0;  ///< of the log it was recorded in
  sim::Refusal reason;

  bool operator==(const SkippedCommand&) const = default;
};

/// An object that ends elsewhere.
struct Displaced {
  std::string id;
  recording::PoseGap gap;
};

/// A control or a host point that ends in another state.
struct ChangedState {
  std::string id;
  std::string before, after;

  bool operator==(const ChangedState&) const = default;
};

/// What an edit came to: how what happens now ends, against what was recorded. All in scene order.
struct EditReport {
  std::uint64_t ticks_before = 0, ticks_after = 0;
  std::vector<SkippedCommand> skipped;
  std::vector<Displaced> displaced;       ///< by more than kSamePlace
  std::vector<std::string> gone;          ///< ids of objects that were there in the end
  std::vector<std::string> there_again;   ///< ids of objects that were destroyed
  std::vector<ChangedState> controls;     ///< states as recordings have them
  std::vector<ChangedState> host_points;  ///< states are tightnesses
  std::vector<std::string> joints;        ///< of the robot, which end elsewhere; see kSameAngle

  bool ends_the_same() const {
    return displaced.empty() && gone.empty() && there_again.empty() && controls.empty() &&
           host_points.empty() && joints.empty();
  }
};

/// What is no farther away ends where it did.
inline constexpr recording::PoseGap kSamePlace{.distance = 0.0005, .angle = DegreesToRadians(0.5)};
/// The same of a robot's joint; a finger's as a length [rad or m].
inline constexpr double kSameAngle = DegreesToRadians(0.5);

/// Where the result of an edit goes.
struct EditOutput {
  std::filesystem::path directory;  ///< new
  sim::Eye* eye = nullptr;          ///< takes the pictures; nullptr for text only
};

/// Simulates an edited demonstration; commands that are refused are skipped.
/// @param recording  that it was cut from. Title, notes and how it is shown are kept.
/// @param output     makes a recording; nullopt only tells what would be.
/// @param progress   when it answers false, all ends there.
/// @throws InputError if the directory exists, or the past of the recording cannot be run again.
EditReport ReSimulate(const recording::Recording& recording, const recording::Demonstration& edited,
                      const std::optional<EditOutput>& output,
                      const recording::Progress& progress = {});

/// The same into a new recording, whole or not at all: half of it would look like a whole one.
/// @throws std::runtime_error if `progress` answers false.
EditReport MakeEdited(const recording::Recording& recording, const recording::Demonstration& edited,
                      const EditOutput& output, const recording::Progress& progress = {});

}  // namespace smile::editing
