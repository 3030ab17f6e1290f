#include "robot/robot_model.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/demand.h"

namespace smile::robot {
namespace {

/// Returns the index of the first item named `name`.
template <class Items, class NameOf>
std::optional<int> IndexOf(const Items& items, std::string_view name, NameOf name_of) {
  // Linear: models have some dozens of links, and names are looked up when files are read.
  const auto found = std::ranges::find(items, name, name_of);
  if (found == items.end()) return std::nullopt;
  return static_cast<int>(found - items.begin());
}

template <class Item>
const Item* Find(const std::vector<Item>& items, std::string_view name) {
  const auto found = std::ranges::find(items, name, &Item::name);
  return found == items.end() ? nullptr : &*found;
}

/// Table of the openings of a gripper of jaws, linear between its entries.
class OpeningTable {
 public:
  OpeningTable(const RobotModel& model, const Gripper& gripper)
      : openings_(gripper.openings), drive_(model.links.at(gripper.drive)) {
    SMILE_DEMAND(gripper.kind == GripperKind::kJaws && openings_.size() > 1);
    step_ = (drive_.upper - drive_.lower) / static_cast<double>(openings_.size() - 1);
  }

  double OpeningAt(double q) const {
    const std::size_t i = SegmentAt(q);
    const double from = drive_.lower + static_cast<double>(i) * step_;
    return openings_[i] + (q - from) * Slope(i);
  }
  double DriveAt(double opening) const {
    const bool rises = openings_.back() > openings_.front();
    // The first segment that ends at or beyond the opening.
    std::size_t i = 0;
    while (i + 2 < openings_.size() &&
           (rises ? openings_[i + 1] < opening : openings_[i + 1] > opening)) {
      ++i;
    }
    const double from = drive_.lower + static_cast<double>(i) * step_;
    return std::clamp(from + (opening - openings_[i]) / Slope(i), drive_.lower, drive_.upper);
  }
  double SlopeAt(double q) const { return Slope(SegmentAt(q)); }
  double least_slope() const {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i + 1 < openings_.size(); ++i) {
      least = std::min(least, std::abs(Slope(i)));
    }
    return least;
  }

 private:
  double Slope(std::size_t i) const { return (openings_[i + 1] - openings_[i]) / step_; }
  std::size_t SegmentAt(double q) const {
    const double steps = std::floor((q - drive_.lower) / step_);
    return static_cast<std::size_t>(
        std::clamp(steps, 0.0, static_cast<double>(openings_.size() - 2)));
  }

  const std::vector<double>& openings_;
  const scene::LinkSpec& drive_;
  double step_ = 0;  // of the drive between two entries
};

}  // namespace

OpeningRange OpeningRangeOf(const RobotModel& model, const Gripper& gripper) {
  switch (gripper.kind) {
    case GripperKind::kFingers: {
      const scene::LinkSpec& left = model.links.at(gripper.left_finger);
      const scene::LinkSpec& right = model.links.at(gripper.right_finger);
      // Both fingers move at the speed of the slower one.
      return {.closed = left.lower + right.lower + gripper.closed_opening,
              .open = left.upper + right.upper + gripper.closed_opening,
              .max_speed = 2 * std::min(left.max_velocity, right.max_velocity)};
    }
    case GripperKind::kJaws: {
      const auto [least, greatest] = std::minmax(gripper.openings.front(), gripper.openings.back());
      return {.closed = least,
              .open = greatest,
              .max_speed = model.links.at(gripper.drive).max_velocity *
                           OpeningTable(model, gripper).least_slope()};
    }
    case GripperKind::kSuction:
      break;
  }
  return {};
}

double OpeningOf(const RobotModel& model, const Gripper& gripper, std::span<const double> q) {
  switch (gripper.kind) {
    case GripperKind::kFingers:
      return q[gripper.left_finger] + q[gripper.right_finger] + gripper.closed_opening;
    case GripperKind::kJaws:
      return OpeningTable(model, gripper).OpeningAt(q[gripper.drive]);
    case GripperKind::kSuction:
      break;
  }
  return 0;
}

double MiddleAt(const RobotModel& model, const Gripper& gripper, double opening) {
  if (gripper.kind != GripperKind::kJaws) return 0;
  const scene::LinkSpec& drive = model.links.at(gripper.drive);
  const double last = static_cast<double>(gripper.middles.size() - 1);
  const double entry =
      (DrivePositionAt(model, gripper, opening) - drive.lower) / (drive.upper - drive.lower) * last;
  const std::size_t i = static_cast<std::size_t>(std::clamp(std::floor(entry), 0.0, last - 1));
  return std::lerp(gripper.middles[i], gripper.middles[i + 1], entry - static_cast<double>(i));
}

double DrivePositionAt(const RobotModel& model, const Gripper& gripper, double opening) {
  return OpeningTable(model, gripper).DriveAt(opening);
}

void SetOpening(const RobotModel& model, const Gripper& gripper, double opening,
                std::span<double> q) {
  if (gripper.kind == GripperKind::kSuction) return;
  if (gripper.kind == GripperKind::kFingers) {
    const OpeningRange range = OpeningRangeOf(model, gripper);
    const double part = (std::clamp(opening, range.closed, range.open) - range.closed) /
                        (range.open - range.closed);
    for (const int finger : {gripper.left_finger, gripper.right_finger}) {
      const scene::LinkSpec& link = model.links.at(finger);
      q[finger] = std::lerp(link.lower, link.upper, part);
    }
    return;
  }
  q[gripper.drive] = DrivePositionAt(model, gripper, opening);
  scene::FollowLeaders(model.links, q);
}

double DriveRateAt(const RobotModel& model, const Gripper& gripper, std::span<const double> q) {
  return 1 / OpeningTable(model, gripper).SlopeAt(q[gripper.drive]);
}

int LeadingJointOf(const Gripper& gripper) {
  return gripper.kind == GripperKind::kFingers ? gripper.left_finger : gripper.drive;
}

std::vector<int> JointsOf(const RobotModel& model, const Gripper& gripper) {
  if (gripper.kind == GripperKind::kSuction) return {};
  if (gripper.kind == GripperKind::kFingers) return {gripper.left_finger, gripper.right_finger};
  std::vector<int> joints{gripper.drive};
  for (int i = 0; i < model.num_joints(); ++i) {
    const auto& mimic = model.links[i].mimic;
    if (mimic && mimic->leader == gripper.drive) joints.push_back(i);
  }
  return joints;
}

std::optional<int> FindJoint(const RobotModel& model, std::string_view name) {
  return IndexOf(model.links, name, &scene::LinkSpec::joint_name);
}

std::optional<int> FindFrame(const RobotModel& model, std::string_view name) {
  return IndexOf(model.frames, name, &Frame::name);
}

const Arm* FindArm(const RobotModel& model, std::string_view name) {
  return Find(model.arms, name);
}

const NamedPose* FindPose(const RobotModel& model, std::string_view name) {
  return Find(model.poses, name);
}

bool IsWithinLimits(const RobotModel& model, std::span<const double> q, double tolerance) {
  if (q.size() != model.links.size()) return false;
  for (std::size_t i = 0; i < q.size(); ++i) {
    // Written so that NaN is outside.
    const bool is_within =
        q[i] >= model.links[i].lower - tolerance && q[i] <= model.links[i].upper + tolerance;
    if (!is_within) return false;
  }
  return true;
}

scene::ArticulationSpec MakeArticulationSpec(const RobotModel& model,
                                             const RigidTransform& X_WBase) {
  return {.X_WBase = X_WBase,
          .base_solids = model.base_solids,
          .links = model.links,
          .never_collide = model.never_collide};
}

}  // namespace smile::robot
