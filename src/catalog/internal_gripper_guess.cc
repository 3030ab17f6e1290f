#include "catalog/internal_gripper_guess.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <set>

#include "base/wording.h"
#include "robot/kinematics.h"
#include "scene/bounds.h"

namespace smile::catalog::internal {
namespace {

/// Least cosine of directions that count as equal, 14 degrees, and as about equal, 37 degrees.
constexpr double kSame = 0.968, kAlong = 0.8;
/// Fraction of a finger's length from its tip that touches things.
constexpr double kTip = 0.25;
/// Smallest distance of closed fingers that is told from none [m].
constexpr double kLeastGap = 0.001;
/// Radius and capacity of a suction cup that nothing describes [m, kg].
constexpr double kCupRadius = 0.02, kCupCapacity = 1;

/// Words in names of tool frames, the most telling first.
constexpr std::array<const char*, 8> kToolNames{"tcp", "tool",    "grasp",  "gripper_frame",
                                                "eef", "end_eff", "flange", "ee_link"};

Json ToJson(const Vector3& v) {
  Json list = Json::array();
  // A micrometer, or a microradian, is finer than any of this is known.
  for (double x : v) list.push_back(std::round(x * 1e6) / 1e6 + 0.0);
  return list;
}

/// Returns the angles of a rotation about the fixed axes x, y and z, as in a URDF.
Vector3 RollPitchYaw(const Matrix3& R) {
  const double pitch = std::atan2(-R(2, 0), std::hypot(R(0, 0), R(1, 0)));
  if (std::abs(R(2, 0)) > 1 - 1e-12) return {std::atan2(-R(1, 2), R(1, 1)), pitch, 0};
  return {std::atan2(R(2, 1), R(2, 2)), pitch, std::atan2(R(1, 0), R(0, 0))};
}

Json FrameOn(const std::string& link, const RigidTransform& X_LF) {
  return {{"on", link},
          {"xyz", ToJson(X_LF.translation())},
          {"rpy", ToJson(RollPitchYaw(X_LF.rotation()))}};
}

class ToolGuesser {
 public:
  ToolGuesser(const robot::RobotModel& model, const ArmChain& arm)
      : model_(model), arm_(arm), named_(NamedTool()) {
    std::ranges::copy_if(arm.beyond, std::back_inserter(motors_),
                         [&](int joint) { return !model.links[joint].mimic; });
  }

  ToolGuess Guess() {
    const std::optional<int> drive = DriveOfJaws();
    const bool works = IsPairOfFingers() ? UseFingers() : drive && UseJaws(*drive);
    if (works) return std::move(guess_);
    if (!arm_.beyond.empty()) {
      guess_.notes.push_back(
          "the " + std::to_string(motors_.size()) +
          " joints beyond its palm are no gripper that is known; `turn` moves each of them");
    }
    UseNoGripper();
    return std::move(guess_);
  }

 private:
  // ---- frames

  /// Returns the best frame with the name of a tool on the palm.
  std::optional<int> NamedTool() const {
    for (const char* word : kToolNames) {
      for (std::size_t i = 0; i < model_.frames.size(); ++i) {
        const robot::Frame& frame = model_.frames[i];
        if (frame.link == arm_.palm && HasWord(frame.name, {word})) return static_cast<int>(i);
      }
    }
    return std::nullopt;
  }
  const std::string& palm_name() const { return model_.links[arm_.palm].name; }

  /// Returns the poses of all links in the palm's frame P, with the drive at `q_drive`.
  std::vector<RigidTransform> PosesInPalm(int drive = -1, double q_drive = 0) const {
    std::vector<double> q = model_.q_start;
    if (drive >= 0) q[drive] = q_drive;
    scene::FollowLeaders(model_.links, q);
    std::vector<RigidTransform> X_PL = robot::LinkPoses(model_, {}, q);
    const RigidTransform X_PBase = X_PL[arm_.palm].inverse();
    for (RigidTransform& X : X_PL) X = X_PBase * X;
    return X_PL;
  }
  /// Returns the box around a link in a frame A.
  scene::Bounds BoundsIn(int link, const RigidTransform& X_AL) const {
    return scene::BoundsOf(model_.links[link].solids, X_AL);
  }

  /// Uses the named tool frame if its axes suit the gripper, or makes another one.
  /// @param X_PG  frame that the gripper suggests.
  void SetTool(const RigidTransform& X_PG) {
    if (named_) {
      const robot::Frame& frame = model_.frames[*named_];
      const Matrix3 R = frame.X_LF.rotation().transpose() * X_PG.rotation();
      if (R(2, 2) > kSame && std::abs(R(1, 1)) > kSame) {
        guess_.tool = frame.name;
        X_PG_ = frame.X_LF;
        return;
      }
    }
    guess_.tool = arm_.name + "_tool";
    X_PG_ = X_PG;
    guess_.frames[guess_.tool] = FrameOn(palm_name(), X_PG);
    guess_.notes.push_back("made the tool frame " + Quoted(guess_.tool) + " from its shapes");
  }

  /// Returns the frame G with these axes and its origin near the tip of what closes.
  /// @param along, across  directions of z and y in the palm's frame P; orthogonal.
  /// @param fingers        links.
  RigidTransform FrameAt(const Vector3& along, const Vector3& across,
                         const std::vector<int>& fingers,
                         const std::vector<RigidTransform>& X_PL) const {
    Matrix3 R_PG;
    R_PG << across.cross(along), across, along;
    const RigidTransform X_PA(R_PG, Vector3::Zero());
    scene::Bounds bounds;
    for (int finger : fingers) bounds.Add(BoundsIn(finger, X_PA.inverse() * X_PL[finger]));
    if (bounds.is_empty()) return X_PA;
    // A little inside of the tips, in the middle of what closes.
    const double z = std::lerp(bounds.high.z(), bounds.low.z(), kTip / 2);
    return X_PA * RigidTransform(Vector3(bounds.center().x(), bounds.center().y(), z));
  }

  /// Returns the direction out of the gripper in the palm's frame, orthogonal to `across`: from the
  /// palm's joint to the middle of the fingers, or that of the named tool if it is about the same.
  Vector3 AlongFor(const Vector3& across, const std::vector<int>& fingers,
                   const std::vector<RigidTransform>& X_PL) const {
    scene::Bounds bounds;
    for (int finger : fingers) {
      const scene::Bounds shapes = BoundsIn(finger, X_PL[finger]);
      const Vector3& origin = X_PL[finger].translation();
      bounds.Add(shapes.is_empty() ? scene::Bounds{origin, origin} : shapes);
    }
    const Vector3 middle = Across(bounds.center(), across);
    if (named_) {
      const Vector3 z = Across(model_.frames[*named_].X_LF.rotation().col(2), across);
      if (z.norm() > kSame && z.dot(middle) > kAlong * middle.norm()) return z.normalized();
    }
    if (middle.norm() < 1e-3) return across.unitOrthogonal();
    // Along an axis of the palm if it is nearly one, since shapes are not symmetric.
    Vector3::Index axis = 0;
    const double most = middle.normalized().cwiseAbs().maxCoeff(&axis);
    Vector3 snapped = Vector3::Zero();
    snapped[axis] = middle[axis] < 0 ? -1 : 1;
    const bool snaps = most > kAlong && std::abs(snapped.dot(across)) < 1e-6;
    return snaps ? snapped : Vector3(middle.normalized());
  }
  /// Returns the part of a vector that is orthogonal to a direction.
  static Vector3 Across(const Vector3& v, const Vector3& direction) {
    return v - v.dot(direction) * direction;
  }

  // ---- two fingers

  /// Returns the direction in which a joint beyond the palm slides or turns, in the palm's frame.
  Vector3 AxisOf(int joint, const std::vector<RigidTransform>& X_PL) const {
    return X_PL[joint].rotation() * model_.links[joint].axis;
  }

  /// True for two joints that slide from 0, in opposite directions.
  bool IsPairOfFingers() const {
    if (arm_.beyond.size() != 2) return false;
    for (int joint : arm_.beyond) {
      const scene::LinkSpec& link = model_.links[joint];
      const bool slides_from_0 =
          link.joint_type == scene::JointType::kPrismatic && (link.lower == 0 || link.upper == 0);
      if (!slides_from_0 || link.parent != arm_.palm) return false;
      if (link.mimic && (std::abs(link.mimic->multiplier) != 1 || link.mimic->offset != 0)) {
        return false;
      }
    }
    return OpeningDirection(0).dot(OpeningDirection(1)) < -kSame;
  }
  /// Returns the direction in which a finger opens.
  Vector3 OpeningDirection(std::size_t finger) const {
    const int joint = arm_.beyond[finger];
    const Vector3 axis = AxisOf(joint, PosesInPalm());
    return model_.links[joint].upper == 0 ? Vector3(-axis) : axis;
  }

  bool UseFingers() {
    const std::vector<RigidTransform> X_PL = PosesInPalm();
    Vector3 across = OpeningDirection(0);
    std::array<int, 2> left_right{arm_.beyond[0], arm_.beyond[1]};
    const Vector3 along = AlongFor(across, arm_.beyond, X_PL);
    SetTool(FrameAt(along, across, arm_.beyond, X_PL));
    // The left one opens along y of the tool.
    if (X_PG_.rotation().col(1).dot(across) < 0) std::swap(left_right[0], left_right[1]);
    Json fingers = Json::array();
    for (int joint : left_right) fingers.push_back(model_.links[joint].joint_name);
    guess_.gripper["fingers"] = fingers;
    const double gap = ClosedGap(left_right, X_PL);
    // Less is the roundness of pads, or an overlap of shapes that are rounded up.
    if (gap > kLeastGap) guess_.gripper["closed_opening"] = std::round(gap * 1e4) / 1e4;
    guess_.notes.push_back("gripper: two fingers that slide apart, " +
                           model_.links[left_right[0]].joint_name + " and " +
                           model_.links[left_right[1]].joint_name);
    return true;
  }
  /// Returns the distance of the inner faces of two closed fingers, a little inside of their tips.
  double ClosedGap(const std::array<int, 2>& left_right,
                   const std::vector<RigidTransform>& X_PL) const {
    const RigidTransform X_GP = X_PG_.inverse();
    const scene::Bounds tip = TipOf(left_right[0], X_GP * X_PL[left_right[0]]);
    if (tip.is_empty()) return 0;
    const double z = std::lerp(tip.high.z(), tip.low.z(), kTip / 2);
    const double right = FaceOf({left_right[1], {}}, -1, z, X_PL, 0);
    return FaceOf({left_right[0], {}}, 1, z, X_PL, right) - right;
  }

  // ---- jaws

  /// Returns the joint beyond the palm that can move jaws: the only one with a motor, or the only
  /// one that others mimic. Besides that one, some grippers have a joint for a part of their
  /// linkage that is only to be seen.
  std::optional<int> DriveOfJaws() const {
    if (motors_.size() == 1) return motors_.front();
    std::set<int> leaders;
    for (int joint : arm_.beyond) {
      if (const auto& mimic = model_.links[joint].mimic) leaders.insert(mimic->leader);
    }
    if (leaders.size() != 1 || std::ranges::count(motors_, *leaders.begin()) == 0) {
      return std::nullopt;
    }
    return *leaders.begin();
  }

  /// A side of the gripper: a link, and its box in the tool's frame.
  struct Side {
    int link = -1;
    scene::Bounds bounds;
  };

  bool UseJaws(int drive) {
    const scene::LinkSpec& joint = model_.links[drive];
    const std::vector<RigidTransform> X_PL = PosesInPalm(drive, joint.lower);
    const Vector3 axis = AxisOf(drive, X_PL);
    const bool slides = joint.joint_type == scene::JointType::kPrismatic;
    const Vector3 along = AlongFor(axis, arm_.beyond, X_PL);
    const Vector3 across = slides ? axis : Vector3(along.cross(axis));
    // Until the pads are known: at the wrist's axis, or the named tool.
    X_PG_ = FrameAt(along, across, {}, X_PL);
    if (named_) X_PG_ = RigidTransform(X_PG_.rotation(), model_.frames[*named_].X_LF.translation());
    const auto [closed, open] = ClosedAndOpen(drive);
    const std::vector<RigidTransform> X_PL_closed = PosesInPalm(drive, closed);
    SetTool(X_PG_);
    const std::optional<Side> moving_left = SideAt(drive, open, closed, 1);
    const std::optional<Side> moving_right = SideAt(drive, open, closed, -1);
    if (!moving_left && !moving_right) return GiveUp();
    const Side left = moving_left.value_or(Side{arm_.palm, {}});
    const Side right = moving_right.value_or(Side{arm_.palm, {}});
    // The pads: where the inner faces meet when closed, a little inside of the tips.
    const scene::Bounds& tips = moving_left ? left.bounds : right.bounds;
    const double z = std::lerp(tips.high.z(), tips.low.z(), kTip / 2);
    double y_left = 0, y_right = 0;
    if (moving_left) y_left = FaceOf(left, 1, z, X_PL_closed, 0);
    y_right = FaceOf(right, -1, z, X_PL_closed, y_left);
    if (!moving_left) y_left = FaceOf(left, 1, z, X_PL_closed, y_right);
    AddPad("left", left, y_left, z, X_PL_closed);
    AddPad("right", right, y_right, z, X_PL_closed);
    if (guess_.frames.contains(guess_.tool)) {
      const Vector3 p_GT(tips.center().x(), (y_left + y_right) / 2, z);
      guess_.frames[guess_.tool] = FrameOn(palm_name(), X_PG_ * RigidTransform(p_GT));
    }
    guess_.gripper["jaws"] = {{"drive", joint.joint_name},
                              {"left", model_.links[left.link].name},
                              {"right", model_.links[right.link].name}};
    guess_.gripper["pads"] = {arm_.name + "_left_pad", arm_.name + "_right_pad"};
    guess_.notes.push_back("gripper: jaws " + model_.links[left.link].name + " and " +
                           model_.links[right.link].name + ", moved by " + joint.joint_name +
                           "; the places where they meet are those of their shapes");
    for (int other : motors_) {
      if (other == drive) continue;
      guess_.notes.push_back("joint " + Quoted(model_.links[other].joint_name) +
                             " moves no jaw; `turn` moves it");
    }
    return true;
  }
  /// Forgets what was made for a gripper.
  bool GiveUp() {
    guess_ = {};
    return false;
  }

  /// Returns the ends of the drive's range at which the gripper is closed and open: where the links
  /// beyond the palm are nearer to the middle of the tool, and farther from it.
  std::pair<double, double> ClosedAndOpen(int drive) const {
    const scene::LinkSpec& joint = model_.links[drive];
    const auto width_at = [&](double q) {
      const std::vector<RigidTransform> X_PL = PosesInPalm(drive, q);
      double width = 0;
      for (int link : arm_.beyond) {
        const scene::Bounds bounds = TipOf(link, X_PG_.inverse() * X_PL[link]);
        if (!bounds.is_empty()) width += std::abs(bounds.center().y());
      }
      return width;
    };
    return width_at(joint.lower) <= width_at(joint.upper) ? std::pair(joint.lower, joint.upper)
                                                          : std::pair(joint.upper, joint.lower);
  }

  /// Returns the box around the pieces of a link that are nearest to its tip.
  scene::Bounds TipOf(int link, const RigidTransform& X_GL) const {
    const scene::Bounds whole = BoundsIn(link, X_GL);
    scene::Bounds tip;
    for (const scene::Solid& solid : model_.links[link].solids) {
      const scene::Bounds piece = scene::BoundsOf(solid.shape, X_GL * solid.X_BS);
      if (piece.high.z() >= whole.high.z() - kTip * whole.size().z()) tip.Add(piece);
    }
    return tip;
  }

  /// Returns the link that moves outwards to one side when the gripper opens, and reaches farthest
  /// along z.
  /// @param sign  1 for +y, the left side.
  std::optional<Side> SideAt(int drive, double open, double closed, int sign) const {
    // A little way only: a jaw that turns by a right angle moves back across again.
    const auto X_PL_open = PosesInPalm(drive, std::lerp(closed, open, 0.2));
    const auto X_PL_closed = PosesInPalm(drive, closed);
    std::optional<Side> best;
    for (int link : arm_.beyond) {
      const scene::Bounds at_open = BoundsIn(link, X_PG_.inverse() * X_PL_open[link]);
      const scene::Bounds before = BoundsIn(link, X_PG_.inverse() * X_PL_closed[link]);
      const scene::Bounds at_closed = TipOf(link, X_PG_.inverse() * X_PL_closed[link]);
      if (at_open.is_empty()) continue;
      const double way = sign * (at_open.center().y() - before.center().y());
      if (way < 1e-4) continue;
      if (!best || at_closed.high.z() > best->bounds.high.z()) best = Side{link, at_closed};
    }
    return best;
  }
  /// Returns y of the face of a side towards the other one, at a height z of the tool.
  /// @param y_other  of the other side's face, for a fixed jaw, which lies beyond it.
  double FaceOf(const Side& side, int sign, double z, const std::vector<RigidTransform>& X_PL,
                double y_other) const {
    std::optional<double> face;
    for (const scene::Solid& solid : model_.links[side.link].solids) {
      const scene::Bounds piece =
          scene::BoundsOf(solid.shape, X_PG_.inverse() * X_PL[side.link] * solid.X_BS);
      if (piece.low.z() > z || piece.high.z() < z) continue;
      const double y = sign > 0 ? piece.low.y() : piece.high.y();
      const bool is_beyond = sign * (piece.center().y() - y_other) >= 0;
      if (side.link == arm_.palm && !is_beyond) continue;
      if (!face || sign * (y - *face) < 0) face = y;
    }
    return face.value_or(y_other);
  }

  void AddPad(const std::string& name, const Side& side, double y, double z,
              const std::vector<RigidTransform>& X_PL) {
    const RigidTransform X_LG = X_PL[side.link].inverse() * X_PG_;
    guess_.frames[arm_.name + "_" + name + "_pad"] =
        FrameOn(model_.links[side.link].name, RigidTransform(X_LG * Vector3(0, y, z)));
  }

  // ---- no gripper, or a suction cup

  void UseNoGripper() {
    const std::vector<RigidTransform> X_PL = PosesInPalm();
    if (named_) {
      guess_.tool = model_.frames[*named_].name;
    } else {
      const Vector3 z = Vector3::UnitZ();
      SetTool(FrameAt(z, Vector3::UnitY(), {arm_.palm}, X_PL));
    }
    for (const robot::Frame& frame : model_.frames) {
      if (frame.link != arm_.palm || !HasWord(frame.name, {"suction", "vacuum"})) continue;
      guess_.tool = frame.name;
      guess_.gripper["suction"] = {{"radius", kCupRadius}, {"capacity", kCupCapacity}};
      guess_.notes.push_back("gripper: a suction cup at " + frame.name + ", of " +
                             NumberText(kCupRadius) + " m radius for " + NumberText(kCupCapacity) +
                             " kg: correct these in the side file");
      return;
    }
    guess_.notes.push_back("no gripper");
  }

  const robot::RobotModel& model_;
  const ArmChain& arm_;
  std::optional<int> named_;
  std::vector<int> motors_;  // joints beyond the palm that have one
  RigidTransform X_PG_;      // the tool, in the palm's frame
  ToolGuess guess_;
};

}  // namespace

ToolGuess GuessTool(const robot::RobotModel& model, const ArmChain& arm) {
  return ToolGuesser(model, arm).Guess();
}

}  // namespace smile::catalog::internal
