#include "experiment/robot_region.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <list>
#include <memory>
#include <mutex>
#include <numbers>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "base/wording.h"
#include "experiment/content_hash.h"
#include "experiment/internal_starting_pose.h"
#include "motion/arm_moves.h"
#include "motion/articulation_probe.h"
#include "motion/inverse_kinematics.h"
#include "robot/kinematics.h"

namespace smile::experiment {
namespace {

/// Heights of the tool above the table at which an object is grasped and lifted, by the height of
/// the object.
constexpr double kGraspHeight = 0.5, kLiftHeight = 1.5;
/// Room beside an object for each finger [m].
constexpr double kFingerRoom = 0.02;
/// Turns about the vertical at which a cube is grasped [rad].
constexpr std::array kTurns{0.0, std::numbers::pi / 4};
/// Iterations for one place: the search starts at the solution of a neighboring one.
constexpr int kIterations = 300;
constexpr std::size_t kMaxKept = 8;

/// Returns the distance that an arm's tool can have at most from the origin of its first joint [m].
double LengthOf(const robot::RobotModel& model, const robot::Arm& arm) {
  const robot::Frame& tool = model.frames[static_cast<std::size_t>(arm.tool)];
  double length = tool.X_LF.translation().norm();
  for (int link = tool.link; link != arm.joints.front();) {
    const scene::LinkSpec& spec = model.links[static_cast<std::size_t>(link)];
    length += spec.X_PJ.translation().norm();
    if (spec.joint_type == scene::JointType::kPrismatic) {
      length += std::max(std::abs(spec.lower), std::abs(spec.upper));
    }
    link = spec.parent;
  }
  return length;
}

/// Search for grasps of one arm above places of a table whose near edge is at y = 0.
class ArmSearch {
 public:
  ArmSearch(const robot::RobotModel& model, const robot::Arm& arm, const RigidTransform& X_WBase,
            double object_height)
      : model_(model),
        arm_(arm),
        kinematics_(model, arm, X_WBase),
        probe_(robot::MakeArticulationSpec(model, X_WBase)),
        length_(LengthOf(model, arm)),
        object_height_(object_height) {
    if (arm.gripper) {
      // As wide open as for the object and a finger on each side.
      const double opening = object_height + 2 * kFingerRoom;
      middle_ = robot::MiddleAt(model, *arm.gripper, opening);
    }
    for (const int joint : arm.joints) start_.push_back(model.q_start[joint]);
    q_ = start_;
    const scene::LinkSpec& first = model.links[static_cast<std::size_t>(arm.joints.front())];
    if (first.parent < 0 && first.joint_type != scene::JointType::kPrismatic) {
      shoulder_ = X_WBase * first.X_PJ.translation();
    }
  }

  /// Returns true if the arm can grasp a cube at a place, however it is turned, and lift it
  /// straight up. An arm of fewer than five joints cannot choose how it turns its tool.
  bool Reaches(const layout::Vector2& place) {
    const Vector3 p_WQ(place.x(), place.y(), 0);
    if (shoulder_ && (p_WQ - *shoulder_).norm() > length_) return false;
    if (kinematics_.num_joints() < 5) return Lifts(p_WQ, 0, /*any_turn=*/true);
    return std::ranges::all_of(kTurns, [&](double turn) {
      // A cube may be grasped at each quarter turn, and looks the same.
      return std::ranges::any_of(std::array{0, 1, 2, 3}, [&](int quarter) {
        return Lifts(p_WQ, turn + quarter * std::numbers::pi / 2, /*any_turn=*/false);
      });
    });
  }

 private:
  bool Lifts(const Vector3& p_WQ, double turn, bool any_turn) {
    const Matrix3 down = Quaternion(0, 1, 0, 0).toRotationMatrix();
    const Matrix3 R_WG = Eigen::AngleAxisd(turn, Vector3::UnitZ()) * down;
    const auto at = [&](double height) {
      return RigidTransform(R_WG,
                            p_WQ + Vector3(0, 0, height * object_height_) - middle_ * R_WG.col(1));
    };
    const auto q = motion::SolveInverseKinematics(kinematics_, at(kGraspHeight), q_,
                                                  {.position_tolerance = 1e-4,
                                                   .angle_tolerance = 1e-3,
                                                   .any_turn = any_turn,
                                                   .max_iterations = kIterations});
    q_ = q.value_or(start_);
    if (!q || DoesTouchItself(*q)) return false;
    const auto lift =
        motion::MoveAlongLine(kinematics_, *q, at(kLiftHeight), {.any_turn = any_turn});
    return std::holds_alternative<motion::JointTrajectory>(lift);
  }
  bool DoesTouchItself(const std::vector<double>& q) {
    std::vector<double> all = model_.q_start;
    for (std::size_t i = 0; i < q.size(); ++i) all[arm_.joints[i]] = q[i];
    return probe_.FirstOverlap(all).has_value();
  }

  const robot::RobotModel& model_;
  const robot::Arm& arm_;
  motion::ArmKinematics kinematics_;
  motion::ArticulationProbe probe_;
  double length_, object_height_;
  double middle_ = 0;                ///< between the sides of the gripper, along y of the tool [m]
  std::optional<Vector3> shoulder_;  ///< nullopt if it moves
  std::vector<double> start_, q_;
};

layout::ReachMap MapOf(const model::RobotPlacement& robot, const RigidTransform& X_WBase,
                       double object_height) {
  layout::ReachMap map;
  const std::size_t num_columns = static_cast<std::size_t>(map.num_columns());
  map.is_reached.resize(num_columns * static_cast<std::size_t>(map.num_rows()));
  for (const robot::Arm& arm : robot.model.arms) {
    if (arm.joints.empty()) continue;
    ArmSearch search(robot.model, arm, X_WBase, object_height);
    for (int row = 0; row < map.num_rows(); ++row) {
      for (int i = 0; i < map.num_columns(); ++i) {
        // To and fro, so that the search goes on beside its last place.
        const int column = row % 2 == 0 ? i : map.num_columns() - 1 - i;
        const std::size_t cell =
            static_cast<std::size_t>(row) * num_columns + static_cast<std::size_t>(column);
        if (!map.is_reached[cell]) map.is_reached[cell] = search.Reaches(map.MiddleOf(column, row));
      }
    }
  }
  return map;
}

/// Identity of a robot in its place, and of objects.
std::string KeyOf(const model::RobotPlacement& robot, double object_height) {
  return ContentOf(robot.files) + " " + robot.gripper + " " + NumberText(robot.gap) + " " +
         NumberText(robot.height) + " " + NumberText(object_height);
}

}  // namespace

layout::LayoutRegion RegionOf(const model::RobotPlacement& robot, double object_height) {
  layout::LayoutRegion region;
  // A table of depth 0 has its near edge at y = 0.
  const RigidTransform X_WBase = model::RobotBasePose({.y_span = 0}, robot.gap, robot.height);
  region.touches_at_start = [start = StartingPose(robot.model, X_WBase)](
                                const layout::Footprint& footprint, double top) {
    return start.Touches(footprint, top);
  };
  if (robot.model.name == "baxter") return region;
  if (robot.model.head) {
    region.X_EC =
        robot::FramePose(robot.model, X_WBase, robot.model.q_start, robot.model.head->camera);
  }
  // The map knows the middles of its cells only: a place needs all of those around it.
  region.reach_margin = layout::ReachMap().cell / std::numbers::sqrt2;
  // A robot that was not read from files has no identity.
  if (robot.files.empty()) {
    region.reach_map =
        std::make_shared<const layout::ReachMap>(MapOf(robot, X_WBase, object_height));
    return region;
  }
  static std::mutex mutex;
  static std::list<std::pair<std::string, std::shared_ptr<const layout::ReachMap>>>& kept =
      *new std::list<std::pair<std::string, std::shared_ptr<const layout::ReachMap>>>;
  const std::lock_guard lock(mutex);
  const std::string key = KeyOf(robot, object_height);
  auto found = std::ranges::find(kept, key, [](const auto& item) { return item.first; });
  if (found == kept.end()) {
    kept.emplace_front(
        key, std::make_shared<const layout::ReachMap>(MapOf(robot, X_WBase, object_height)));
    found = kept.begin();
    if (kept.size() > kMaxKept) kept.pop_back();
  }
  region.reach_map = found->second;
  return region;
}

}  // namespace smile::experiment
