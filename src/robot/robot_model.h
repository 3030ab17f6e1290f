#pragma once

#include <cstddef>
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

/// Greatest numbers of arms of a robot, and of joints of an arm or a head; length of an arm's name
/// [bytes].
inline constexpr std::size_t kMaxArms = 16, kMaxArmJoints = 16, kMaxArmName = 40;

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

enum class GripperKind {
  /// Two fingers, each with a motor, slide apart along +y and -y of the tool frame. Their joint
  /// positions are 0 when the gripper is closed.
  kFingers,
  /// One joint, the drive, moves two jaws: one slides or turns towards a fixed one, or joints that
  /// mimic the drive move both, as in a linkage of four bars.
  kJaws,
  /// A suction cup at the origin of the tool holds a body that it touches.
  kSuction,
};

/// Gripper of an arm. Its opening is the free width between its two sides [m]; that of a suction
/// cup is always 0.
struct Gripper {
  GripperKind kind = GripperKind::kFingers;
  /// The two sides that close on a body, as indices of links. Of kFingers also joint indices: the
  /// left one slides along +y. Of kJaws, one may be the link that carries the jaws. -1 for
  /// kSuction.
  int left_finger = -1, right_finger = -1;
  double closed_opening = 0;  ///< of kFingers: added to the sum of both joint positions [m]

  int drive = -1;  ///< of kJaws: joint index
  /// Of kJaws: openings at positions of the drive that divide its range evenly, from its lower to
  /// its upper limit; strictly rising or falling [m].
  std::vector<double> openings;
  /// Of kJaws: places of the middle between the jaws along y of the tool, at the same positions
  /// [m].
  std::vector<double> middles;

  double cup_radius = 0;  ///< of kSuction [m]
  /// Of kSuction: greatest mass that the cup holds, with all that is attached to it [kg].
  double cup_capacity = 0;

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

/// Head of a robot, which carries the eye.
struct Head {
  /// Joint indices from the neck to the eye. The first one, if any, is the pan that commands of the
  /// head move; positive rotates to the robot's left.
  std::vector<int> joints;
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

/// Range of a gripper's openings [m], and the speed that it reaches at each of them [m/s].
struct OpeningRange {
  double closed = 0, open = 0;
  double max_speed = 0;
};
OpeningRange OpeningRangeOf(const RobotModel& model, const Gripper& gripper);

/// Returns the opening of a gripper at a configuration `q` [m].
double OpeningOf(const RobotModel& model, const Gripper& gripper, std::span<const double> q);
/// Returns the place of the middle between both sides of a gripper at an opening, along y of the
/// tool [m]: 0 unless its jaws move differently, as where one of them is fixed.
double MiddleAt(const RobotModel& model, const Gripper& gripper, double opening);
/// Returns the position of the drive of a gripper of jaws at an opening [m], clamped to its range.
double DrivePositionAt(const RobotModel& model, const Gripper& gripper, double opening);
/// Puts the joints of a gripper where it has an opening [m], clamped to its range; of a suction
/// cup, none.
/// @param q  one value per joint of the robot.
void SetOpening(const RobotModel& model, const Gripper& gripper, double opening,
                std::span<double> q);
/// Returns the velocity of the drive of a gripper of jaws per velocity of its opening, at a
/// configuration `q` [rad/m or m/m].
double DriveRateAt(const RobotModel& model, const Gripper& gripper, std::span<const double> q);

/// Returns the joint that stands for a gripper among those that commands move: the left finger, or
/// the drive; -1 for a suction cup.
int LeadingJointOf(const Gripper& gripper);
/// Returns the joints that a gripper moves, also those that mimic its drive.
std::vector<int> JointsOf(const RobotModel& model, const Gripper& gripper);

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
