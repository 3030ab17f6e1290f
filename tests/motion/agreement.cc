// Asks what agreement.py and agreement.m ask, in C++, and prints the answers to the last bit; the
// three outputs must be the same text.

#include <cmath>
#include <cstdio>
#include <string>

#include "motion/planning_robot.h"

namespace smile::motion {
namespace {

void Print(const std::string& name, std::span<const double> numbers) {
  std::printf("%s", name.c_str());
  for (const double number : numbers) std::printf(" %.17g", number);
  std::printf("\n");
}

template <class Matrix>
void PrintRows(const std::string& name, const Matrix& matrix) {
  for (Eigen::Index i = 0; i < matrix.rows(); ++i) {
    const Eigen::VectorXd row = matrix.row(i);
    Print(name, {row.data(), static_cast<std::size_t>(row.size())});
  }
}

void PrintMove(const std::string& name, const JointTrajectory& move) {
  for (const TrajectoryPoint& point : move.points) {
    Print(name + " times", std::vector{point.seconds});
    Print(name + " positions", point.positions);
    Print(name + " velocities", point.velocities);
  }
  const TrajectoryPoint third = SampleAt(move, move.seconds() / 3);
  Print(name + " sample", third.positions);
  Print(name + " sample", third.velocities);
}

/// Numbers that any language makes the same: quotients of whole numbers.
std::vector<double> Configuration(const PlanningRobot& robot, const std::string& arm, int k) {
  std::vector<double> q;
  int i = 0;
  for (const JointLimits& limit : robot.Limits(arm)) {
    const double share = ((k * 37 + i * 61) % 101) / 101.0;
    q.push_back(limit.lower + share * (limit.upper - limit.lower));
    ++i;
  }
  return q;
}

void AskArm(const PlanningRobot& robot, const std::string& arm) {
  const std::vector<double> ready = robot.NamedPose(arm, "untucked").value();
  PrintRows("fingers", robot.FingerBounds(arm, 0.4));
  for (int k = 0; k < 40; ++k) {
    const Eigen::Matrix4d goal = robot.Forward(arm, Configuration(robot, arm, k));
    PrintRows("forward", goal);
    PrintRows("jacobian", robot.Jacobian(arm, Configuration(robot, arm, k)));
    for (const bool any_turn : {false, true}) {
      const auto q = robot.Inverse(arm, goal, ready, {.any_turn = any_turn});
      Print("inverse", q.value_or(std::vector<double>()));
    }
  }
  std::vector<std::vector<double>> waypoints;
  for (int k = 0; k < 5; ++k) waypoints.push_back(Configuration(robot, arm, k));
  PrintMove("through", robot.MoveJoints(arm, waypoints, 0.5));
  const JointTrajectory straight = robot.MoveJoints(arm, std::vector{waypoints[0], waypoints[1]});
  PrintMove("straight", straight);
  const HeldBox plate{Vector3(-3, -3, -0.5), Vector3(3, 3, 0.5)};
  const auto moment = robot.FirstInvalid(straight, {}, std::nullopt, plate);
  if (moment) Print("held " + moment->reason, std::vector{moment->seconds});

  for (const double way : {1.0, 40.0}) {
    Eigen::Matrix4d goal = robot.Forward(arm, ready);
    goal(2, 3) += way;
    const auto answer = robot.MoveLine(arm, ready, goal, {.tool_speed = 2});
    if (const auto* fault = std::get_if<LineFault>(&answer)) {
      Print("fault " + fault->reason, std::vector{fault->fraction});
    } else {
      PrintMove("line", std::get<JointTrajectory>(answer));
    }
  }
}

void AskBoth(const PlanningRobot& robot) {
  const std::vector<double> low = Configuration(robot, "both", 3);
  const std::vector<double> high = Configuration(robot, "both", 8);
  const JointTrajectory move = robot.MoveJoints("both", std::vector{low, high, low});
  PrintMove("both", move);
  const auto moment = robot.FirstInvalid(move, low, std::pair(20.0, 12.0));
  if (moment) Print("invalid " + moment->reason, std::vector{moment->seconds});
}

}  // namespace
}  // namespace smile::motion

int main(int, char** arguments) {
  using namespace smile::motion;
  Eigen::Matrix4d base;
  base << 0, -1, 0, 0.5, 1, 0, 0, -8, 0, 0, 1, 2, 0, 0, 0, 1;
  const PlanningRobot robot = ReadPlanningRobot(arguments[1], base, 0.1);
  AskArm(robot, "left");
  AskArm(robot, "right");
  AskBoth(robot);
}
