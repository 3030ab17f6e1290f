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

/// Where an object is: position [m] and unit quaternion (w, x, y, z).
struct TracePose {
  bool is_present = true;  ///< false once it is destroyed; the rest then says nothing
  bool is_awake = false;   ///< may move
  Vector3 position = Vector3::Zero();
  Eigen::Vector4d rotation{1, 0, 0, 0};

  /// A present object; see is_awake.
  static TracePose At(const RigidTransform& X_WB, bool is_awake);
  RigidTransform pose_in_world() const {
    return {Quaternion(rotation[0], rotation[1], rotation[2], rotation[3]), position};
  }
  bool operator==(const TracePose&) const = default;
};

/// How far apart two poses are, or what a joint does to them.
struct PoseGap {
  double distance = 0;  ///< [m]
  double angle = 0;     ///< [rad]

  /// To say which of two is the larger: one degree counts as one millimeter, about what it moves
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

/// One moment of a recording, as far as it can be seen.
struct TraceTick {
  std::uint64_t tick = 0;
  std::uint64_t hash = 0;                     ///< Simulation::state_hash()
  std::vector<TracePose> objects;             ///< in scene order
  std::vector<model::ControlState> controls;  ///< by model::ControlIndex
  std::vector<model::HostState> bonds;        ///< by model::HostIndex
  std::vector<double> joints;                 ///< q of the robot [rad or m]; empty without one
  bool is_robot_shown = true;
  robot::FaceExpression face_expression = robot::FaceExpression::kIdle;  ///< idle without a robot
  /// What happened from this moment on, until the next one. Observe() leaves it empty.
  std::vector<sim::Event> events;
};

/// How many objects, controls and host points a moment has: more, once some were added.
struct TraceCounts {
  std::uint32_t objects = 0, controls = 0, bonds = 0;

  bool operator==(const TraceCounts&) const = default;
};
TraceCounts CountsOf(const TraceTick& moment);

/// The present moment of a simulation.
TraceTick Observe(const sim::Simulation& simulation);
/// A moment of a model with fewer objects, for a model that has more behind them: they are absent.
TraceTick WithAbsent(TraceTick moment, const model::Model& model);
/// The moment at which a simulation of the model starts, as far as it can be seen: without a hash,
/// and nothing is awake.
TraceTick StartOf(const model::Model& model);

/// What an object of the scene would have come to lie on at a moment, see model::SupportOf().
std::optional<model::Support> SupportAt(const TraceTick& moment, const std::string& id,
                                        const scene::SceneSpec& scene);

/// A place in a trace, between two of its records: how many bytes are before it.
using TracePlace = std::uint64_t;

}  // namespace smile::recording
