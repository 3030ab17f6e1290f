#include "recording/demonstration.h"

#include <algorithm>
#include <cmath>

#include "base/diagnostic.h"
#include "math/angles.h"
#include "recording/recording_history.h"
#include "recording/trace_reader.h"

namespace smile::recording {
namespace {

/// Limits of motion for objects at rest.
constexpr PoseGap kRest{.distance = 1e-4, .angle = DegreesToRadians(0.1)};
constexpr double kJointRest = 1e-4;  // [rad or m]

/// True if all controls, bonds, objects and joints are within the limits of rest of their state at
/// `then`.
bool IsWhereItWas(const TraceTick& then, const TraceTick& now) {
  if (then.controls != now.controls || then.bonds != now.bonds) return false;
  for (std::size_t i = 0; i < now.objects.size(); ++i) {
    const TracePose &was = then.objects[i], &is = now.objects[i];
    if (was.is_present != is.is_present) return false;
    if (is.is_present && GapBetween(was, is).IsBeyond(kRest)) return false;
  }
  for (std::size_t i = 0; i < now.joints.size(); ++i) {
    if (std::abs(now.joints[i] - then.joints[i]) > kJointRest) return false;
  }
  return true;
}

/// Facts of a trace that an editor needs.
struct Watched {
  TraceTick end;
  std::map<std::size_t, TracePose> grasped;  ///< see Demonstration
  /// For each tick of the trace: the tick since which everything has been at rest, both relative to
  /// the start.
  std::vector<std::uint64_t> at_rest_since;
};

/// Notes where the objects are that hands take at this tick, and goes on to later commands.
void NoteGrasps(const Recording& recording, const TraceTick& now,
                std::vector<LoggedCommand>::const_iterator* next, Watched* watched) {
  for (; *next != recording.commands.end() && (*next)->tick <= now.tick; ++*next) {
    const auto* grasp = std::get_if<sim::Grasp>(&(*next)->command);
    if (grasp == nullptr || (*next)->tick != now.tick) continue;
    const auto object = recording.model->FindObject(grasp->object);
    if (object) watched->grasped[(*next)->line] = now.objects[*object];
  }
}

Watched Watch(const Recording& recording) {
  TraceReader trace(recording);
  Watched watched;
  TraceTick anchor;
  auto next = recording.commands.begin();
  while (const std::optional<TraceTick> now = trace.Next()) {
    const std::uint64_t tick = watched.at_rest_since.size();
    // The anchor is the first moment of the present rest. Comparing to it, and not to the previous
    // tick, detects slow drift.
    const bool rests = tick > 0 && IsWhereItWas(anchor, *now);
    if (!rests) anchor = *now;
    watched.at_rest_since.push_back(rests ? watched.at_rest_since.back() : tick);
    watched.end = *now;
    NoteGrasps(recording, *now, &next, &watched);
  }
  return watched;
}

/// Throws unless the trace has every tick from the start to its end, and the commands since the
/// start lie within these.
void CheckAgainstTrace(const Recording& recording, const Watched& watched) {
  const std::uint64_t start = recording.info.start.tick;
  const auto log_path = (recording.directory / "commands.jsonl").string();
  if (watched.at_rest_since.empty() ||
      watched.end.tick != start + watched.at_rest_since.size() - 1) {
    throw InputError({(recording.directory / "trace.bin").string(), 0, "",
                      "does not begin at tick " + std::to_string(start) + ", as demo.json says"});
  }
  for (const LoggedCommand& logged : recording.commands) {
    if (logged.line <= recording.info.start.line) continue;
    if (logged.tick >= start && logged.tick <= watched.end.tick) continue;
    throw InputError({log_path, static_cast<int>(logged.line), "",
                      "\"tick\" is " + std::to_string(logged.tick) + ", expected " +
                          std::to_string(start) + " to " + std::to_string(watched.end.tick) +
                          ", the ticks in trace.bin"});
  }
}

/// Returns the segments with their commands, still without pauses.
std::vector<EditableSegment> EditableSegmentsOf(const Recording& recording,
                                                std::uint64_t last_tick) {
  std::vector<EditableSegment> editable;
  auto logged = recording.commands.begin();
  for (const Segment& segment : OnPath(CutAtActions(recording, last_tick))) {
    editable.push_back({.number = static_cast<int>(editable.size())});
    editable.back().duration = segment.end.tick - segment.begin.tick;
    // Both lists are in order of lines, so one pass assigns each command to the segment that
    // contains its line.
    for (; logged != recording.commands.end() && logged->line <= segment.end.line; ++logged) {
      if (logged->line <= segment.begin.line) continue;
      editable.back().commands.push_back({.line = logged->line,
                                          .offset = logged->tick - segment.begin.tick,
                                          .command = logged->command});
    }
  }
  return editable;
}

/// Finds the pauses of a segment: times at rest before its next command or its end. `begin` is the
/// segment's first tick, relative to the start. If objects come to rest and start to move again
/// without a command, that is physics at work and not a pause.
void FindPauses(std::uint64_t begin, const Watched& watched, EditableSegment* segment) {
  std::uint64_t last = 0;
  const auto add_before = [&](std::uint64_t offset) {
    // Only the rest that lasts until the command counts, and only its part after the previous
    // command.
    const std::uint64_t rest = watched.at_rest_since[begin + offset];
    const std::uint64_t from = std::max(last, rest > begin ? rest - begin : 0);
    if (from < offset) segment->pauses.push_back({from, offset});
    last = offset;
  };
  for (const SegmentCommand& command : segment->commands) add_before(command.offset);
  add_before(segment->duration);
}

}  // namespace

std::uint64_t Demonstration::duration() const {
  std::uint64_t sum = 0;
  for (const EditableSegment& segment : segments) sum += segment.duration;
  return sum;
}

std::vector<LoggedCommand> Demonstration::Schedule() const {
  // Commands before the start are fixed; those of segments move with the segments before them.
  std::vector<LoggedCommand> schedule = past;
  std::uint64_t begin = start.tick;
  for (const EditableSegment& segment : segments) {
    for (const SegmentCommand& command : segment.commands) {
      schedule.push_back({command.line, begin + command.offset, command.command});
    }
    begin += segment.duration;
  }
  return schedule;
}

Demonstration DemonstrationOf(const Recording& recording) {
  if (recording.info.origin == Origin::kImported) {
    throw InputError({recording.directory.string(), 0, "",
                      "was imported from a classic recording and has no commands to edit"});
  }
  const Watched watched = Watch(recording);
  CheckAgainstTrace(recording, watched);
  Demonstration demonstration{.start = recording.info.start,
                              .recorded_end = watched.end,
                              .grasped = watched.grasped,
                              .meters_per_unit = recording.scene().meters_per_unit};
  for (const LoggedCommand& logged : recording.commands) {
    if (logged.line <= demonstration.start.line) demonstration.past.push_back(logged);
  }
  demonstration.segments = EditableSegmentsOf(recording, watched.end.tick);
  demonstration.num_recorded = static_cast<int>(demonstration.segments.size());
  std::uint64_t begin = 0;
  for (EditableSegment& segment : demonstration.segments) {
    FindPauses(begin, watched, &segment);
    begin += segment.duration;
  }
  return demonstration;
}

}  // namespace smile::recording
