#include <cstdio>

#include "motion/planning_robot.h"

int main(int, char** arguments) {
  using namespace smile::motion;
  Eigen::Matrix4d base, goal;
  base << 0, -1, 0, 0, 1, 0, 0, -8, 0, 0, 1, 2, 0, 0, 0, 1;
  goal << 1, 0, 0, -2, 0, -1, 0, -4, 0, 0, -1, 3, 0, 0, 0, 1;
  const PlanningRobot robot = ReadPlanningRobot(arguments[1], base, 0.1);
  const auto ready = robot.NamedPose("left", "untucked").value();

  const auto above = robot.Inverse("left", goal, ready, {.any_turn = true});
  if (!above) return 1;  // an ordinary answer: out of reach
  const JointTrajectory there = robot.MoveJoints("left", std::vector{ready, *above});

  goal(2, 3) = 1;
  const auto down = robot.MoveLine("left", *above, goal, {.tool_speed = 2, .any_turn = true});
  if (std::holds_alternative<LineFault>(down)) return 1;
  const auto& move = std::get<JointTrajectory>(down);
  const TrajectoryPoint half = SampleAt(move, move.seconds() / 2);
  std::printf("after %.2f s at %.3f units\n", there.seconds(),
              robot.Forward("left", half.positions)(2, 3));
}
