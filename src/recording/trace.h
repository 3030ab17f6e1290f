#pragma once

#include <cstdint>
#include <vector>

#include "math/angles.h"
#include "math/rigid_transform.h"
#include "model/model.h"
#include "model/relations.h"
#include "sim/event.h"
#include "sim/simulation.h"

namespace smile::recording {

/// Pose of an object in the world: position [m] and unit quaternion (w, x, y, z).
struct TracePose {
  bool is_present = true;  ///< false once it is destroyed; the other members are meaningless then
  bool is_awake = false;   ///< may move; false while it sleeps
  Vector3 position = Vector3::Zero();
  Eigen::Vector4d rotation{1, 0, 0, 0};

  /// Returns the entry of a present object.
  static TracePose At(const RigidTransform& X_WB, bool is_awake);
  RigidTransform pose_in_world() const {
    return {Quaternion(rotation[0], rotation[1], rotation[2], rotation[3]), position};
  }
  bool operator==(const TracePose&) const = default;
};

/// Distance and angle between two poses.
struct PoseGap {
  double distance = 0;  ///< [m]
  double angle = 0;     ///< [rad]

  /// Size for comparing two gaps: one degree counts as one millimeter, about the displacement of
  /// the corner of a block.
  double size() const { return millimeters() + degrees(); }
  double millimeters() const { return 1000 * distance; }
  double degrees() const { return RadiansToDegrees(angle); }

  bool IsBeyond(const PoseGap& limits) const {
    return distance > limits.distance || angle > limits.angle;
  }
  bool operator==(const PoseGap&) const = default;
};
PoseGap GapBetween(const TracePose& from, const TracePose& to);

/// Observable state at one tick of a recording.
struct TraceTick {
  std::uint64_t tick = 0;
  std::uint64_t hash = 0;                     ///< Simulation::state_hash()
  std::vector<TracePose> objects;             ///< in scene order
  std::vector<model::ControlState> controls;  ///< by model::ControlIndex
  std::vector<model::HostState> bonds;        ///< by model::HostIndex
  std::vector<double> joints;                 ///< q of the robot [rad or m]; empty without one
  bool is_robot_shown = true;
  robot::FaceExpression face_expression = robot::FaceExpression::kIdle;  ///< idle without a robot
  /// Events from this tick until the next one. Observe() leaves them empty.
  std::vector<sim::Event> events;
};

/// Numbers of objects, controls and host points at a tick; they grow when objects are added.
struct TraceCounts {
  std::uint32_t objects = 0, controls = 0, bonds = 0;

  bool operator==(const TraceCounts&) const = default;
};
TraceCounts CountsOf(const TraceTick& moment);

/// Returns the current tick of a simulation.
TraceTick Observe(const sim::Simulation& simulation);
/// Extends a tick to a model with further objects at the end of its lists; these are absent.
TraceTick WithAbsent(TraceTick moment, const model::Model& model);
/// Returns the first tick of a simulation of the model: without a hash, and nothing is awake.
TraceTick StartOf(const model::Model& model);

/// Returns the support of an object of the scene at a tick, see model::SupportOf().
std::optional<model::Support> SupportAt(const TraceTick& moment, const std::string& id,
                                        const scene::SceneSpec& scene);

/// Position in a trace between two records: the number of bytes before it.
using TracePlace = std::uint64_t;

}  // namespace smile::recording
