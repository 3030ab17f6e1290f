#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "math/angles.h"
#include "recording/conflicts.h"
#include "recording/demonstration.h"
#include "recording/progress.h"
#include "replay/log_player.h"
#include "sim/eye.h"

namespace smile::editing {

/// Command that is refused in the edited demonstration and therefore skipped.
struct SkippedCommand {
  std::size_t line = 0;  ///< of the recorded log, or of the other one's
  sim::Refusal reason;
  bool is_of_overlay = false;  ///< of the other demonstration, see Overlaid()

  bool operator==(const SkippedCommand&) const = default;
};

/// Object that ends in another place.
struct Displaced {
  std::string id;
  recording::PoseGap gap;
};

/// Control or host point that ends in another state.
struct ChangedState {
  std::string id;
  std::string before, after;

  bool operator==(const ChangedState&) const = default;
};

/// Effect of an edit: differences between the ends of the edited and the recorded demonstration.
/// All in scene order.
struct EditReport {
  std::uint64_t ticks_before = 0, ticks_after = 0;
  std::vector<SkippedCommand> skipped;
  std::vector<Displaced> displaced;       ///< by more than kSamePlace
  std::vector<std::string> gone;          ///< ids of objects that existed only at the recorded end
  std::vector<std::string> there_again;   ///< ids of objects that exist only at the new end
  std::vector<ChangedState> controls;     ///< states as recorded
  std::vector<ChangedState> host_points;  ///< states are stages of tightness
  std::vector<std::string> joints;        ///< of the robot, which end elsewhere; see kSameAngle
  /// Refused commands, and hands that did not find what they found when they were recorded; by
  /// time.
  std::vector<recording::Conflict> conflicts;

  bool ends_the_same() const {
    return displaced.empty() && gone.empty() && there_again.empty() && controls.empty() &&
           host_points.empty() && joints.empty();
  }
};

/// Smallest difference in pose that counts as displaced.
inline constexpr recording::PoseGap kSamePlace{.distance = 0.0005, .angle = DegreesToRadians(0.5)};
/// Smallest difference of a robot's joint; fingers are compared as lengths [rad or m].
inline constexpr double kSameAngle = DegreesToRadians(0.5);

/// Output of an edit.
struct EditOutput {
  std::filesystem::path directory;  ///< new
  sim::Eye* eye = nullptr;          ///< takes the pictures; nullptr for text only
};

/// Runs a new simulation to the start of the demonstration. A refused command is an error, since
/// the past is not edited.
/// @throws InputError
void RunToStart(const recording::Recording& recording, replay::LogPlayer* player,
                sim::Simulation* simulation);

/// Called before and after each command is applied, or refused; empty ones are not.
struct CommandObserver {
  std::function<void(const recording::LoggedCommand& command)> before;
  std::function<void(const recording::LoggedCommand& command,
                     const std::optional<sim::Refusal>& refusal)>
      after;
};

/// Runs for a number of ticks and executes the commands that are due, those of the last tick
/// included.
/// @param progress  returning false ends it early.
/// @returns the commands that were refused.
std::vector<SkippedCommand> RunFor(std::uint64_t ticks, replay::LogPlayer* player,
                                   sim::Simulation* simulation,
                                   const recording::Progress& progress = {},
                                   const CommandObserver& observer = {});

/// Simulates an edited demonstration; commands that are refused are skipped. A recording that is
/// made contains the conflicts.
/// @param recording  source of the demonstration. Title, notes and display options are kept.
/// @param output  makes a recording; nullopt only reports.
/// @param progress  returning false ends the simulation early.
/// @throws InputError if the directory exists, or the past of the recording cannot be run again.
EditReport ReSimulate(const recording::Recording& recording, const recording::Demonstration& edited,
                      const std::optional<EditOutput>& output,
                      const recording::Progress& progress = {});

/// Simulates into a new recording; on failure nothing remains, since a partial one would look
/// complete.
/// @throws std::runtime_error if `progress` returns false.
EditReport MakeEdited(const recording::Recording& recording, const recording::Demonstration& edited,
                      const EditOutput& output, const recording::Progress& progress = {});

}  // namespace smile::editing
