#include "record/replay.h"

#include <cstdio>

#include "base/diagnostic.h"
#include "base/wording.h"

#include "math/angles.h"
#include "record/log_player.h"
#include "record/trace_reader.h"
#include "scene/units.h"

namespace smile::record {
namespace {

/// The quantity of a difference that only the hash sees.
constexpr const char* kHidden = "state_hash";

std::string Written(const Vector3& v) {
  return "(" + NumberText(v.x()) + ", " + NumberText(v.y()) + ", " + NumberText(v.z()) + ")";
}
std::string Written(const world::ControlState& control) {
  std::string text =
      std::to_string(control.state) + " in position " + std::to_string(control.position);
  if (control.override_state >= 0) text += ", shows " + std::to_string(control.override_state);
  return text;
}
std::string Written(const TraceBond& bond) {
  return std::to_string(bond.tightness) + (bond.is_locked ? ", locked" : "") +
         (bond.guest >= 0 ? ", of guest point " + std::to_string(bond.guest) : "");
}
std::string WrittenHash(std::uint64_t hash) {
  char text[32];
  std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(hash));
  return text;
}

/// What differs first: an object, a joint, what is shown, else something that cannot be seen (yet).
std::optional<Difference> Compare(const TraceTick& recorded, const TraceTick& replayed,
                                  const sim::Simulation& simulation) {
  const double unit = simulation.scene().meters_per_unit;
  for (std::size_t i = 0; i < replayed.objects.size(); ++i) {
    const TracePose& a = recorded.objects[i];
    const TracePose& b = replayed.objects[i];
    const std::string& id = simulation.tabletop().objects()[i].id();
    if (a.is_present != b.is_present) {
      return Difference{recorded.tick, id, "present", a.is_present ? "true" : "false",
                        b.is_present ? "true" : "false"};
    }
    if (a.position != b.position) {
      return Difference{recorded.tick, id, "position",
                        Written(scene::ToFileUnits(a.position, unit)),
                        Written(scene::ToFileUnits(b.position, unit))};
    }
    if (a.rotation != b.rotation) {
      return Difference{recorded.tick, id, "rotation",
                        Written(FixedAxesAngles(a.pose_in_world().rotation())),
                        Written(FixedAxesAngles(b.pose_in_world().rotation()))};
    }
  }
  for (std::size_t i = 0; i < replayed.controls.size(); ++i) {
    if (recorded.controls[i] == replayed.controls[i]) continue;
    return Difference{recorded.tick, simulation.tabletop().controls().all()[i].id(), "state",
                      Written(recorded.controls[i]), Written(replayed.controls[i])};
  }
  for (std::size_t i = 0; i < replayed.bonds.size(); ++i) {
    if (recorded.bonds[i] == replayed.bonds[i]) continue;
    return Difference{recorded.tick, simulation.tabletop().bonds().hosts()[i].point->id,
                      "tightness", Written(recorded.bonds[i]), Written(replayed.bonds[i])};
  }
  for (std::size_t i = 0; i < replayed.joints.size(); ++i) {
    if (recorded.joints[i] == replayed.joints[i]) continue;
    return Difference{recorded.tick, simulation.robot()->model().links[i].joint_name, "angle",
                      NumberText(recorded.joints[i]), NumberText(replayed.joints[i])};
  }
  if (recorded.is_robot_shown != replayed.is_robot_shown) {
    return Difference{recorded.tick, "robot", "shown", recorded.is_robot_shown ? "true" : "false",
                      replayed.is_robot_shown ? "true" : "false"};
  }
  if (recorded.hash == replayed.hash) return std::nullopt;
  return Difference{recorded.tick, "simulation", kHidden, WrittenHash(recorded.hash),
                    WrittenHash(replayed.hash)};
}

}  // namespace

ReplayReport Replay(const Recording& recording, const Progress& progress) {
  if (recording.info.origin == Origin::kImported) {
    throw InputError({recording.directory.string(), 0, "",
                      "was imported from a classic recording; it has no commands to run again"});
  }
  TraceReader trace(recording);
  sim::Simulation simulation(recording.scene, recording.robot);
  LogPlayer player(recording.commands, recording.info.start);
  ReplayReport report;
  const auto refused = [&](const LogPlayer::Failure& failure) {
    if (report.first_difference) return;
    report.first_difference =
        Difference{failure.command.tick, "simulation", "command", "carried out", failure.refusal};
  };
  if (const auto failure = player.RunToStart(&simulation)) {
    refused(*failure);
    return report;
  }
  for (bool has_begun = false; const std::optional<TraceTick> recorded = trace.Next();
       has_begun = true) {
    // The first record is the start, before any tick.
    if (has_begun) simulation.Tick();
    const TraceTick replayed = Observe(simulation);
    report.ticks = recorded->tick - recording.info.start.tick;
    report.hash = replayed.hash;
    if (const auto difference = Compare(*recorded, replayed, simulation)) {
      // What a hand wants differs before anything moves differently: look on until it shows, so
      // that the report can name an object.
      const bool is_visible = difference->quantity != kHidden;
      if (is_visible || !report.first_difference) report.first_difference = difference;
      if (is_visible) return report;
    }
    if (const auto failure = player.ApplyDue(&simulation)) {
      refused(*failure);
      return report;
    }
    if (progress && !progress(recorded->tick)) return report;
  }
  report.is_cut = trace.is_cut();
  if (player.next() != nullptr && !report.is_cut && !report.first_difference) {
    report.first_difference = Difference{player.next()->tick, "simulation", "command",
                                         "carried out", "the trace ends before"};
  }
  return report;
}

}  // namespace smile::record
