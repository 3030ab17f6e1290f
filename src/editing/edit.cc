// Edits change when commands happen, never what the world does: the edited demonstration is
// simulated again afterwards, and physics decides. Each edit of time is a monotone map of offsets
// within a segment, so commands keep their order and pauses remain pauses.

#include "editing/edit.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <stdexcept>
#include <string>

#include "base/overloaded.h"
#include "base/wording.h"
#include "editing/internal_shift.h"
#include "motion/trajectory_shape.h"
#include "sim/command_json.h"
#include "sim/simulation.h"

namespace smile::editing {
namespace {

using SegmentPlace = std::vector<recording::EditableSegment>::iterator;

/// Converts seconds to ticks; throws std::invalid_argument outside 0 to kMaxSeconds, also for NaN.
std::uint64_t TicksOf(double seconds) {
  if (!(seconds >= 0 && seconds <= kMaxSeconds)) {
    throw std::invalid_argument("time is " + NumberText(seconds) + " s, expected 0 to " +
                                NumberText(kMaxSeconds));
  }
  return static_cast<std::uint64_t>(std::llround(seconds * sim::kTicksPerSecond));
}

void CheckNumber(const char* what, int found, int low, int high) {
  if (found >= low && found <= high) return;
  throw std::invalid_argument(std::string(what) + " is " + std::to_string(found) + ", expected " +
                              std::to_string(low) + " to " + std::to_string(high));
}

void CheckFactor(double factor) {
  if (factor >= kMinFactor && factor <= 1 / kMinFactor) return;
  throw std::invalid_argument("factor is " + NumberText(factor) + ", expected " +
                              NumberText(kMinFactor) + " to " + NumberText(1 / kMinFactor));
}

/// Returns the segment with this recorded number; throws std::invalid_argument if it never existed
/// or was dropped.
SegmentPlace Find(int number, recording::Demonstration* demonstration) {
  // Numbers are those of the recording, so a list of edits can be read without following what the
  // earlier ones did.
  CheckNumber("segment", number, 0, demonstration->num_recorded - 1);
  auto& segments = demonstration->segments;
  const auto found =
      std::find_if(segments.begin(), segments.end(),
                   [&](const recording::EditableSegment& s) { return s.number == number; });
  if (found == segments.end()) {
    throw std::invalid_argument("segment " + std::to_string(number) + " is already dropped");
  }
  return found;
}

/// Monotone map from old to new offsets in a segment, in ticks from its begin. All edits of time
/// are such maps.
using TimeMap = std::function<std::uint64_t(std::uint64_t)>;

/// Applies a map to commands, pauses and duration, so that they stay consistent.
void Warp(const TimeMap& map, recording::EditableSegment* segment) {
  for (recording::SegmentCommand& command : segment->commands) command.offset = map(command.offset);
  for (recording::TickSpan& pause : segment->pauses) pause = {map(pause.begin), map(pause.end)};
  // A pause that the map has closed must not count in later edits.
  std::erase_if(segment->pauses,
                [](const recording::TickSpan& pause) { return pause.length() == 0; });
  segment->duration = map(segment->duration);
}

TimeMap Scaled(double factor) {
  return [factor](std::uint64_t offset) {
    return static_cast<std::uint64_t>(std::llround(static_cast<double>(offset) * factor));
  };
}

void Perform(const Drop& drop, recording::Demonstration* demonstration) {
  CheckNumber("segment", drop.first, 0, demonstration->num_recorded - 1);
  CheckNumber("last segment", drop.last, drop.first, demonstration->num_recorded - 1);
  for (int number = drop.first; number <= drop.last; ++number) {
    demonstration->segments.erase(Find(number, demonstration));
  }
}

void Perform(const Move& move, recording::Demonstration* demonstration) {
  if (demonstration->num_recorded == 1) {
    throw std::invalid_argument("no segment can be moved: the recording has no action");
  }
  CheckNumber("segment", move.segment, 1, demonstration->num_recorded - 1);
  const SegmentPlace from = Find(move.segment, demonstration);
  auto& segments = demonstration->segments;
  // Segment 0 is the start without an action; places count from the first action.
  const int first_action = segments.front().number == 0 ? 1 : 0;
  CheckNumber("place", move.place, 1, static_cast<int>(segments.size()) - first_action);
  const SegmentPlace to = segments.begin() + first_action + move.place - 1;
  // Rotation moves one element and keeps the order of all others; the direction decides which
  // neighbor takes its place.
  if (from < to) {
    std::rotate(from, from + 1, to + 1);
  } else {
    std::rotate(to, from, from + 1);
  }
}

void Perform(const Trim& trim, recording::Demonstration* demonstration) {
  recording::EditableSegment& segment = *Find(trim.segment, demonstration);
  const std::uint64_t from = TicksOf(trim.from);
  // A range may reach beyond the end: that keeps all to the end.
  const std::uint64_t to = std::min(TicksOf(trim.to), segment.duration);
  if (from > to) {
    throw std::invalid_argument("the range to keep is from " + NumberText(trim.from) + " to " +
                                NumberText(trim.to) + " s, expected a part of the segment's " +
                                NumberText(sim::SecondsOf(segment.duration)) + " s");
  }
  // The action stays, as the segment exists because of it; other commands outside the range are
  // dropped.
  std::erase_if(segment.commands, [&](const recording::SegmentCommand& command) {
    return !IsAction(command.command) && (command.offset < from || command.offset > to);
  });
  Warp([&](std::uint64_t offset) { return std::clamp(offset, from, to) - from; }, &segment);
}

void Perform(const MaxPause& longest, recording::Demonstration* demonstration) {
  const std::uint64_t kept = TicksOf(longest.seconds);
  for (recording::EditableSegment& segment : demonstration->segments) {
    // A copy, since Warp() changes the pauses while the map still needs the original ones.
    const std::vector<recording::TickSpan> pauses = segment.pauses;
    const auto without_rest_of_pauses = [&](std::uint64_t offset) {
      std::uint64_t removed = 0;
      for (const recording::TickSpan& pause : pauses) {
        // The part of the pause before this offset; `kept` ticks of it stay. Pauses do not overlap,
        // so the removed parts add up.
        const std::uint64_t waited = std::clamp(offset, pause.begin, pause.end) - pause.begin;
        removed += waited - std::min(waited, kept);
      }
      return offset - removed;
    };
    Warp(without_rest_of_pauses, &segment);
  }
}

void Perform(const Retime& retime, recording::Demonstration* demonstration) {
  recording::EditableSegment& segment = *Find(retime.segment, demonstration);
  const std::uint64_t wanted = TicksOf(retime.seconds);
  // A segment without duration has all commands at its begin; there is nothing to scale, and the
  // time is added after them.
  if (segment.duration > 0) {
    Warp(Scaled(static_cast<double>(wanted) / static_cast<double>(segment.duration)), &segment);
  }
  // Scaling may have missed it by rounding.
  segment.duration = wanted;
}

/// Multiplies the speeds of a command by `factor`: of hands where a speed is given, and of the
/// robot.
/// @returns true if that changes the command.
bool SpeedUp(double factor, sim::Command* command) {
  return std::visit(Overloaded{[&](sim::MoveTo& move) {
                                 if (move.speed) *move.speed *= factor;
                                 return move.speed.has_value();
                               },
                               [&](sim::JointVelocities& velocities) {
                                 for (auto& [name, rates] : velocities.arms) {
                                   for (double& rate : rates) rate *= factor;
                                 }
                                 for (auto& [name, rate] : velocities.grippers) rate *= factor;
                                 if (velocities.head) *velocities.head *= factor;
                                 return true;
                               },
                               [&](sim::TurnJoint& turn) {
                                 turn.velocity *= factor;
                                 return true;
                               },
                               [&](sim::MoveGripper& move) {
                                 move.velocity *= factor;
                                 return true;
                               },
                               [&](sim::TakePose& pose) {
                                 // A fraction of full speed, so it cannot grow further. The segment
                                 // may then end before the pose is reached.
                                 pose.speed = std::min(1.0, pose.speed * factor);
                                 return true;
                               },
                               [&](sim::FollowTrajectory& follow) {
                                 // Twice as fast means half of the time.
                                 motion::ScaleTime(1 / factor, &follow.trajectory);
                                 return true;
                               },
                               [](auto&) { return false; }},
                    *command);
}

/// Speeds up a command. Writing and parsing it again applies the limits of the command language.
/// @throws std::invalid_argument if a speed or time leaves the range that the log allows.
void SpeedUp(double factor, double meters_per_unit, recording::SegmentCommand* command) {
  if (!SpeedUp(factor, &command->command)) return;
  try {
    (void)sim::ParseCommand(sim::ToJson(command->command, meters_per_unit), meters_per_unit);
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument("line " + std::to_string(command->line) +
                                " of the log: " + error.what());
  }
}

void Perform(const Speed& speed, recording::Demonstration* demonstration) {
  CheckFactor(speed.factor);
  for (recording::EditableSegment& segment : demonstration->segments) {
    // Times shrink by the same factor as speeds grow, so motions cover the same paths.
    Warp(Scaled(1 / speed.factor), &segment);
    for (recording::SegmentCommand& command : segment.commands) {
      SpeedUp(speed.factor, demonstration->meters_per_unit, &command);
    }
  }
}

void Perform(const Shift& shift, recording::Demonstration* demonstration) {
  CheckNumber("last segment", shift.last, shift.first, demonstration->num_recorded - 1);
  PerformShift(shift, *Find(shift.first, demonstration), demonstration);
}

void Perform(const Stretch& stretch, recording::Demonstration* demonstration) {
  CheckNumber("last segment", stretch.last, stretch.first, demonstration->num_recorded - 1);
  CheckFactor(stretch.factor);
  PerformStretch(stretch, *Find(stretch.first, demonstration), demonstration);
}

}  // namespace

recording::Demonstration Edited(recording::Demonstration demonstration, const Edit& edit) {
  // One check for all kinds of edits, after the fact.
  const std::uint64_t before = demonstration.duration();
  std::visit([&](const auto& what) { Perform(what, &demonstration); }, edit);
  // An edit may shorten a recording that is longer than the limit, but not lengthen it.
  const std::uint64_t after = demonstration.duration();
  if (after > std::max(before, TicksOf(kMaxSeconds))) {
    throw std::invalid_argument("the demonstration would last " +
                                NumberText(sim::SecondsOf(after)) + " s, expected at most " +
                                NumberText(kMaxSeconds));
  }
  return demonstration;
}

}  // namespace smile::editing
