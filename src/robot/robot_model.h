#pragma once

#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "robot/face_expression.h"
#include "scene/articulation_spec.h"
#include "scene/visual_model.h"

namespace smile::robot {

/// A named frame F that moves with a link L. Each link of the description has one of its own name,
/// including links that were merged into their parent.
struct Frame {
  std::string name;
  int link = -1;  ///< index into RobotModel::links; -1 = the base
  RigidTransform X_LF;

  bool operator==(const Frame&) const = default;
};

/// A drawn piece, fixed to a link L.
struct LinkVisual {
  int link = -1;  ///< index into RobotModel::links; -1 = the base
  scene::VisualShape shape;
  Color color;
  RigidTransform X_LV;
  std::optional<FaceExpression>
      face_expression;  ///< a piece of the face: to be seen only with this face expression

  bool operator==(const LinkVisual&) const = default;
};

/// Two fingers that slide apart along +y and -y of the tool frame. Their joint positions are 0 when
/// the gripper is closed; the opening is the sum of both [m] plus `closed_opening`.
struct Gripper {
  int left_finger = -1;       ///< joint index; slides along +y
  int right_finger = -1;      ///< joint index; slides along -y
  double closed_opening = 0;  ///< opening of the closed gripper [m]

  bool operator==(const Gripper&) const = default;
};

/// Arm of a robot, from the shoulder to the tool.
struct Arm {
  std::string name;         ///< `left`, `right`
  std::vector<int> joints;  ///< joint indices from the shoulder to the wrist
  int tool = -1;            ///< frame index of the tool G; z is the approach direction
  std::optional<Gripper> gripper;
  /// Mass in the gripper that weighs nothing; the arm feels the rest [kg].
  double payload = std::numeric_limits<double>::infinity();

  bool operator==(const Arm&) const = default;
};

/// Head of a robot, which pans and carries the eye.
struct Head {
  int joint = -1;   ///< joint index of the pan; positive rotates to the robot's left
  int camera = -1;  ///< frame index of the robot's eye: x right, y down, z forward

  bool operator==(const Head&) const = default;
};

/// Named configuration, one value per joint [rad or m].
struct NamedPose {
  std::string name;
  std::vector<double> q;

  bool operator==(const NamedPose&) const = default;
};

/// Robot model: plain values, independent of its place.
///
/// Joint i carries link i, so one index serves both; a configuration q has one value per joint.
struct RobotModel {
  std::string name;
  std::vector<scene::LinkSpec> links;     ///< moving links, parents before children
  std::vector<scene::Solid> base_solids;  ///< collision solids of the base; X_BS is X_BaseS
  std::vector<LinkVisual> visuals;        ///< of the base and the links
  std::vector<Frame> frames;              ///< unique names
  std::vector<Arm> arms;                  ///< left first
  std::optional<Head> head;
  /// Pairs of links that touch by construction; -1 is the base.
  std::vector<std::pair<int, int>> never_collide;
  std::vector<NamedPose> poses;
  std::vector<double> q_start;  ///< one value per joint, within limits

  int num_joints() const { return static_cast<int>(links.size()); }
  bool operator==(const RobotModel&) const = default;
};

/// Look up by name, for the boundary where names come in; return nullopt or nullptr if there is no
/// such item.
[[nodiscard]] std::optional<int> FindJoint(const RobotModel& model, std::string_view name);
[[nodiscard]] std::optional<int> FindFrame(const RobotModel& model, std::string_view name);
[[nodiscard]] const Arm* FindArm(const RobotModel& model, std::string_view name);
[[nodiscard]] const NamedPose* FindPose(const RobotModel& model, std::string_view name);

/// Returns true if `q` has one value per joint, each within its limits widened by `tolerance` [rad,
/// m].
bool IsWithinLimits(const RobotModel& model, std::span<const double> q, double tolerance = 0);

/// Returns the part of a robot that physics needs, with the base at `X_WBase`.
scene::ArticulationSpec MakeArticulationSpec(const RobotModel& model,
                                             const RigidTransform& X_WBase);

}  // namespace smile::robot
