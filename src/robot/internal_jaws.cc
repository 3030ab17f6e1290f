#include "robot/internal_jaws.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "base/wording.h"
#include "robot/kinematics.h"

namespace smile::robot::internal {
namespace {

/// Entries of a table of openings: linear between them, the opening of a jaw that turns by 100
/// degrees is off by less than 0.1 % of its length.
constexpr int kEntries = 65;
/// Least difference of the greatest and the smallest opening [m].
constexpr double kLeastStroke = 0.001;

/// Range of entries in a list, with both ends.
struct Run {
  int first = 0, last = 0;
};

/// Openings of jaws, and the middles between them along y of the tool [m].
struct JawTable {
  std::vector<double> openings, middles;
};

/// Returns the table at positions of the drive that divide a range evenly.
JawTable MeasureBetween(double lower, double upper, std::pair<int, int> pads, int tool,
                        const RobotModel& model, int drive) {
  std::vector<double> q;
  for (const scene::LinkSpec& link : model.links) {
    q.push_back(std::clamp(0.0, link.lower, link.upper));
  }
  JawTable table;
  for (int i = 0; i < kEntries; ++i) {
    q[drive] = std::lerp(lower, upper, i / (kEntries - 1.0));
    scene::FollowLeaders(model.links, q);
    const RigidTransform X_GBase = FramePose(model, {}, q, tool).inverse();
    const Vector3 left = (X_GBase * FramePose(model, {}, q, pads.first)).translation();
    const Vector3 right = (X_GBase * FramePose(model, {}, q, pads.second)).translation();
    table.openings.push_back(left.y() - right.y());
    table.middles.push_back((left.y() + right.y()) / 2);
  }
  return table;
}

/// Returns the entries from the greatest opening down to the least one that is not negative, as
/// long as they fall.
Run RunOf(const std::vector<double>& openings) {
  const int widest = static_cast<int>(std::ranges::max_element(openings) - openings.begin());
  // Towards the end at which the jaws are closer.
  const int step = openings.front() < openings.back() ? -1 : 1;
  int last = widest;
  for (int next = widest + step; next >= 0 && next < kEntries; next += step) {
    if (!(openings[next] >= 0 && openings[next] < openings[last])) break;
    last = next;
  }
  return {std::min(widest, last), std::max(widest, last)};
}

}  // namespace

std::optional<std::string> MeasureJaws(std::pair<int, int> pads, int tool, RobotModel* model,
                                       Gripper* gripper) {
  scene::LinkSpec& drive = model->links[gripper->drive];
  const std::vector<double> openings =
      MeasureBetween(drive.lower, drive.upper, pads, tool, *model, gripper->drive).openings;
  const Run run = RunOf(openings);
  const double stroke = std::abs(openings[run.last] - openings[run.first]);
  if (!(stroke >= kLeastStroke)) {
    return "open from " + NumberText(openings.front()) + " to " + NumberText(openings.back()) +
           " m along y of the tool, expected from 0 or more by at least " +
           NumberText(kLeastStroke) + " m, with the left one at +y";
  }
  const double step = (drive.upper - drive.lower) / (kEntries - 1);
  const double lower = drive.lower + run.first * step;
  drive.upper = std::min(drive.upper, drive.lower + run.last * step);
  drive.lower = lower;
  JawTable table = MeasureBetween(drive.lower, drive.upper, pads, tool, *model, gripper->drive);
  gripper->openings = std::move(table.openings);
  gripper->middles = std::move(table.middles);
  return std::nullopt;
}

std::optional<std::string> AddMimics(const std::vector<Mimic>& mimics, RobotModel* model) {
  std::map<std::string, const Mimic*> by_joint;
  for (const Mimic& mimic : mimics) by_joint[mimic.joint] = &mimic;
  for (const Mimic& named : mimics) {
    const std::string what = "joint " + Quoted(named.joint) + " mimics " + Quoted(named.master);
    // Follows the chain of mimics to a joint that follows none.
    scene::Mimic mimic{.leader = -1, .multiplier = named.multiplier, .offset = named.offset};
    std::string leader = named.master;
    std::size_t steps = 0;
    for (auto next = by_joint.find(leader); next != by_joint.end(); next = by_joint.find(leader)) {
      if (++steps > mimics.size()) return what + ", which follows itself, expected no loop";
      mimic.offset += mimic.multiplier * next->second->offset;
      mimic.multiplier *= next->second->multiplier;
      leader = next->second->master;
    }
    const auto follower = FindJoint(*model, named.joint), leading = FindJoint(*model, leader);
    if (!leading) return what + ", expected a joint that moves";
    mimic.leader = *leading;
    if (!(std::isfinite(mimic.multiplier) && std::abs(mimic.multiplier) > 1e-6 &&
          std::abs(mimic.multiplier) < 1e6 && std::abs(mimic.offset) < 1e3)) {
      return what + " with the multiplier " + NumberText(mimic.multiplier) + " and the offset " +
             NumberText(mimic.offset) + ", expected finite ones, the multiplier not 0";
    }
    model->links[*follower].mimic = mimic;
  }
  // Leaders stay where their followers can follow.
  for (const scene::LinkSpec& link : model->links) {
    if (!link.mimic) continue;
    scene::LinkSpec& leader = model->links[link.mimic->leader];
    const double at_lower = (link.lower - link.mimic->offset) / link.mimic->multiplier;
    const double at_upper = (link.upper - link.mimic->offset) / link.mimic->multiplier;
    const double least = std::min(at_lower, at_upper), most = std::max(at_lower, at_upper);
    const std::string own_range = NumberText(leader.lower) + " to " + NumberText(leader.upper);
    leader.lower = std::max(leader.lower, least);
    leader.upper = std::min(leader.upper, most);
    leader.max_velocity =
        std::min(leader.max_velocity, link.max_velocity / std::abs(link.mimic->multiplier));
    if (leader.lower < leader.upper) continue;
    return "joint " + Quoted(link.joint_name) + " mimics " + Quoted(leader.joint_name) +
           ", and its limits allow that one only " + NumberText(least + 0.0) + " to " +
           NumberText(most + 0.0) + ", expected a part of the range " + own_range;
  }
  return std::nullopt;
}

}  // namespace smile::robot::internal
