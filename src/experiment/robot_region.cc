#include "experiment/robot_region.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <list>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/wording.h"
#include "experiment/content_hash.h"
#include "motion/inverse_kinematics.h"

namespace smile::experiment {
namespace {

/// Heights of the tool above the table at which an object is grasped and lifted [m].
constexpr std::array kToolHeights{0.05, 0.12};
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

/// Search for configurations of one arm above places of a table whose near edge is at y = 0.
class ArmSearch {
 public:
  ArmSearch(const robot::RobotModel& model, const robot::Arm& arm, const RigidTransform& X_WBase)
      : kinematics_(model, arm, X_WBase), length_(LengthOf(model, arm)) {
    for (const int joint : arm.joints) start_.push_back(model.q_start[joint]);
    q_ = start_;
    const scene::LinkSpec& first = model.links[static_cast<std::size_t>(arm.joints.front())];
    if (first.parent < 0 && first.joint_type != scene::JointType::kPrismatic) {
      shoulder_ = X_WBase * first.X_PJ.translation();
    }
  }

  bool Reaches(const layout::Vector2& place) {
    return std::ranges::all_of(kToolHeights, [&](double height) {
      const RigidTransform X_WG(Quaternion(0, 1, 0, 0), Vector3(place.x(), place.y(), height));
      if (shoulder_ && (X_WG.translation() - *shoulder_).norm() > length_) return false;
      const motion::IkOptions options{.position_tolerance = 1e-4,
                                      .angle_tolerance = 1e-3,
                                      .any_turn = true,
                                      .max_iterations = kIterations};
      const auto q = motion::SolveInverseKinematics(kinematics_, X_WG, q_, options);
      q_ = q.value_or(start_);
      return q.has_value();
    });
  }

 private:
  motion::ArmKinematics kinematics_;
  double length_;
  std::optional<Vector3> shoulder_;  ///< nullopt if it moves
  std::vector<double> start_, q_;
};

layout::ReachMap MapOf(const model::RobotPlacement& robot) {
  layout::ReachMap map;
  const std::size_t num_columns = static_cast<std::size_t>(map.num_columns());
  map.is_reached.resize(num_columns * static_cast<std::size_t>(map.num_rows()));
  // A table of depth 0 has its near edge at y = 0.
  const RigidTransform X_WBase = model::RobotBasePose({.y_span = 0}, robot.gap, robot.height);
  for (const robot::Arm& arm : robot.model.arms) {
    if (arm.joints.empty()) continue;
    ArmSearch search(robot.model, arm, X_WBase);
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

/// Identity of a robot in its place.
std::string KeyOf(const model::RobotPlacement& robot) {
  return ContentOf(robot.files) + " " + robot.gripper + " " + NumberText(robot.gap) + " " +
         NumberText(robot.height);
}

}  // namespace

layout::LayoutRegion RegionOf(const model::RobotPlacement& robot) {
  layout::LayoutRegion region;
  if (robot.model.name == "baxter") return region;
  region.has_standard_eye = !robot.model.head.has_value();
  // A robot that was not read from files has no identity.
  if (robot.files.empty()) {
    region.reach_map = std::make_shared<const layout::ReachMap>(MapOf(robot));
    return region;
  }
  static std::mutex mutex;
  static std::list<std::pair<std::string, std::shared_ptr<const layout::ReachMap>>>& kept =
      *new std::list<std::pair<std::string, std::shared_ptr<const layout::ReachMap>>>;
  const std::lock_guard lock(mutex);
  const std::string key = KeyOf(robot);
  auto found = std::ranges::find(kept, key, [](const auto& item) { return item.first; });
  if (found == kept.end()) {
    kept.emplace_front(key, std::make_shared<const layout::ReachMap>(MapOf(robot)));
    found = kept.begin();
    if (kept.size() > kMaxKept) kept.pop_back();
  }
  region.reach_map = found->second;
  return region;
}

}  // namespace smile::experiment
