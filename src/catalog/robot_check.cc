#include "catalog/robot_check.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "base/wording.h"
#include "catalog/internal_sampling.h"
#include "motion/articulation_probe.h"
#include "robot/kinematics.h"

namespace smile::catalog {
namespace {

/// Links that overlap in this fraction of random configurations probably touch by construction.
constexpr double kSuspicious = 0.8;
/// Places over the table that a tool should reach: a grid of this many by this many before the
/// shoulder, as far to each side as forward, up to the reach of the arm; at a fraction of its reach
/// above the table.
constexpr int kPlaces = 5;
constexpr double kHeight = 0.1;

std::string CountOf(std::size_t count, const std::string& noun) {
  return std::to_string(count) + " " + noun + (count == 1 ? "" : "s");
}

std::string WordFor(const robot::RobotModel& model, const robot::Gripper& gripper) {
  const robot::OpeningRange range = OpeningRangeOf(model, gripper);
  const std::string opens = ", " + NumberText(std::round(range.closed * 1e4) / 1e4) + " to " +
                            NumberText(std::round(range.open * 1e4) / 1e4) + " m";
  switch (gripper.kind) {
    case robot::GripperKind::kFingers:
      return "two fingers" + opens;
    case robot::GripperKind::kJaws:
      return "jaws" + opens;
    case robot::GripperKind::kSuction:
      return "suction cup";
  }
  return "";
}

class Checker {
 public:
  Checker(const model::RobotPlacement& robot, const Progress& progress)
      : robot_(robot), model_(robot.model), progress_(progress) {}

  RobotReport Check() {
    AddFacts();
    CheckPoses();
    CheckLinks();
    for (const robot::Arm& arm : model_.arms) CheckReach(arm);
    return std::move(report_);
  }

 private:
  std::string NameOf(int link) const {
    if (link == motion::kEnvironment) return "the table";
    return Quoted(link < 0 ? model_.frames.front().name : model_.links[link].name);
  }
  RigidTransform X_WBase() const {
    return model::RobotBasePose(scene::TableSpec(), robot_.gap, robot_.height);
  }

  void AddFacts() {
    report_.facts.push_back(SummaryOf(model_));
    for (const robot::Arm& arm : model_.arms) {
      std::string fact = arm.name + ": " + CountOf(arm.joints.size(), "joint") + ", tool " +
                         model_.frames[arm.tool].name;
      if (arm.gripper) fact += ", " + WordFor(model_, *arm.gripper);
      if (std::isfinite(arm.payload)) fact += ", carries " + NumberText(arm.payload) + " kg";
      report_.facts.push_back(std::move(fact));
    }
    if (model_.head) {
      report_.facts.push_back("head: " + CountOf(model_.head->joints.size(), "joint") + ", eye " +
                              model_.frames[model_.head->camera].name);
    }
    if (model_.arms.empty()) {
      report_.findings.push_back("no arm: the robot cannot be moved, expected arms in a side file");
    }
    if (FindPose(model_, "ready") == nullptr) {
      report_.findings.push_back("no pose \"ready\": expected one over the table, fingers down");
    }
  }

  void CheckPoses() {
    motion::ArticulationProbe probe(robot::MakeArticulationSpec(model_, X_WBase()),
                                    {scene::TableSolid(scene::TableSpec())});
    const auto check = [&](const std::string& name, const std::vector<double>& q) {
      const auto overlap = probe.FirstOverlap(q);
      if (!overlap) return;
      const std::string depth = NumberText(std::round(overlap->depth * 1e4) / 10) + " mm";
      report_.findings.push_back(name + ": " + NameOf(overlap->link) + " and " +
                                 NameOf(overlap->other) + " overlap by " + depth +
                                 ", expected a pose in which nothing does");
    };
    check("start", model_.q_start);
    for (const robot::NamedPose& pose : model_.poses) check("pose " + Quoted(pose.name), pose.q);
  }

  void CheckLinks() {
    const internal::LinkPairs never(model_.never_collide.begin(), model_.never_collide.end());
    for (const auto& [pair, fraction] : internal::OverlapFractions(model_, never, progress_)) {
      if (fraction < kSuspicious) continue;
      report_.findings.push_back(
          NameOf(pair.first) + " and " + NameOf(pair.second) + " overlap in " +
          std::to_string(static_cast<int>(100 * fraction)) +
          " % of random configurations, expected this pair in never_collide if they are made so");
    }
  }

  void CheckReach(const robot::Arm& arm) {
    const std::vector<double>& q_start = model_.q_start;
    const double reach = internal::ReachOf(model_, arm, q_start);
    const Vector3 p_WS =
        X_WBase() * robot::LinkPoses(model_, {}, q_start)[arm.joints.front()].translation();
    int num_reached = 0;
    for (int i = 0; i < kPlaces * kPlaces; ++i) {
      if (progress_ && !progress_(i, kPlaces * kPlaces)) throw std::runtime_error("interrupted");
      const int row = i / kPlaces, column = i % kPlaces;
      const double aside = reach * ((column + 0.5) / kPlaces - 0.5) * 2;
      const double forward = reach * (row + 0.5) / kPlaces;
      const Vector3 place(p_WS.x() + aside, p_WS.y() + forward, kHeight * reach);
      num_reached += internal::ReachDown(model_, arm, X_WBase(), place, q_start).has_value();
    }
    report_.facts.push_back(arm.name + ": its tool reaches, pointing down, " +
                            std::to_string(num_reached) + " of " +
                            std::to_string(kPlaces * kPlaces) + " places over the table, up to " +
                            NumberText(std::round(reach * 100) / 100) + " m before it and aside");
    if (num_reached == 0) {
      report_.findings.push_back(arm.name +
                                 ": its tool reaches no place over the table pointing down, "
                                 "expected z of the tool out of the gripper, and a place where "
                                 "the robot stands within reach (stands)");
    }
  }

  const model::RobotPlacement& robot_;
  const robot::RobotModel& model_;
  const Progress& progress_;
  RobotReport report_;
};

}  // namespace

std::string SummaryOf(const robot::RobotModel& model) {
  std::string summary = CountOf(model.arms.size(), "arm");
  for (std::size_t i = 0; i < model.arms.size(); ++i) {
    const robot::Arm& arm = model.arms[i];
    summary += (i == 0 ? ": " : "; ") + arm.name + " of " + CountOf(arm.joints.size(), "joint") +
               (arm.gripper ? " with " + WordFor(model, *arm.gripper) : ", no gripper");
  }
  return summary;
}

RobotReport CheckRobot(const model::RobotPlacement& robot, const Progress& progress) {
  return Checker(robot, progress).Check();
}

}  // namespace smile::catalog
