// smile.motion, the compiled half: a thin door to motion::PlanningRobot.

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <limits>

#include "base/diagnostic.h"
#include "motion/planning_robot.h"

namespace py = pybind11;

namespace smile::motion {
namespace {

using Array = py::array_t<double, py::array::c_style | py::array::forcecast>;

/// A trajectory, and how many rows its configurations are shown in.
struct RowedTrajectory {
  std::string arm;
  int num_rows = 1;
  JointTrajectory joints;
};

std::string ShapeOf(const Array& array) {
  std::string text;
  for (py::ssize_t i = 0; i < array.ndim(); ++i) {
    text += (i ? "x" : "") + std::to_string(array.shape(i));
  }
  return text.empty() ? "a single number" : text;
}

[[noreturn]] void RejectShape(const char* name, const Array& array, const std::string& expected) {
  throw std::invalid_argument(std::string(name) + " is " + ShapeOf(array) + ", expected " +
                              expected);
}

Eigen::Matrix4d PoseFrom(const char* name, const Array& array) {
  if (array.ndim() != 2 || array.shape(0) != 4 || array.shape(1) != 4) {
    RejectShape(name, array, "4x4");
  }
  Eigen::Matrix4d pose;
  for (int i = 0; i < 16; ++i) pose(i / 4, i % 4) = array.data()[i];
  return pose;
}

/// The shape of a configuration.
std::vector<py::ssize_t> ShapeFor(int num_rows, std::size_t num_joints) {
  const auto count = static_cast<py::ssize_t>(num_joints);
  if (num_rows == 1) return {count};
  return {num_rows, count / num_rows};
}

std::string TextOf(const std::vector<py::ssize_t>& shape) {
  return shape.size() == 1 ? std::to_string(shape[0])
                           : std::to_string(shape[0]) + "x" + std::to_string(shape[1]);
}

std::vector<double> ConfigurationFrom(const char* name, const Array& array,
                                      const std::vector<py::ssize_t>& shape) {
  const bool fits =
      std::equal(shape.begin(), shape.end(), array.shape(), array.shape() + array.ndim());
  const bool is_one_row =
      shape.size() == 1 && array.ndim() == 2 && array.shape(0) == 1 && array.shape(1) == shape[0];
  if (!fits && !is_one_row) RejectShape(name, array, TextOf(shape));
  return {array.data(), array.data() + array.size()};
}

std::vector<py::ssize_t> ShapeFor(const PlanningRobot& robot, const std::string& arm) {
  return ShapeFor(robot.NumRows(arm), robot.JointNames(arm).size());
}

std::vector<std::vector<double>> WaypointsFrom(const Array& array,
                                               const std::vector<py::ssize_t>& shape) {
  const bool fits = array.ndim() == static_cast<py::ssize_t>(shape.size()) + 1 &&
                    std::equal(shape.begin(), shape.end(), array.shape() + 1);
  if (!fits) RejectShape("waypoints", array, "Kx" + TextOf(shape));
  std::vector<std::vector<double>> waypoints;
  const py::ssize_t count = array.shape(0), size = count == 0 ? 0 : array.size() / count;
  for (py::ssize_t k = 0; k < count; ++k) {
    waypoints.emplace_back(array.data() + k * size, array.data() + (k + 1) * size);
  }
  return waypoints;
}

Array ArrayOf(const std::vector<double>& values, const std::vector<py::ssize_t>& shape) {
  return Array(shape, values.data());
}

template <class Matrix>
Array ArrayOf(const Matrix& matrix) {
  Array array({static_cast<py::ssize_t>(matrix.rows()), static_cast<py::ssize_t>(matrix.cols())});
  for (py::ssize_t i = 0; i < matrix.rows(); ++i) {
    for (py::ssize_t j = 0; j < matrix.cols(); ++j) array.mutable_at(i, j) = matrix(i, j);
  }
  return array;
}

/// All points' positions (or velocities) in one array.
Array Stacked(const RowedTrajectory& trajectory, std::vector<double> TrajectoryPoint::*values) {
  const auto& points = trajectory.joints.points;
  std::vector<py::ssize_t> shape =
      ShapeFor(trajectory.num_rows, trajectory.joints.joint_names.size());
  shape.insert(shape.begin(), static_cast<py::ssize_t>(points.size()));
  std::vector<double> all;
  for (const TrajectoryPoint& point : points) {
    all.insert(all.end(), (point.*values).begin(), (point.*values).end());
  }
  return ArrayOf(all, shape);
}

void BindTrajectory(py::module_& m) {
  py::class_<RowedTrajectory>(m, "Trajectory", R"(How the joints of an arm, or of both, move.

Between its points each joint follows the cubic with their positions and velocities.)")
      .def_readonly("arm", &RowedTrajectory::arm, "'left', 'right' or 'both'")
      .def_property_readonly(
          "joint_names", [](const RowedTrajectory& t) { return t.joints.joint_names; },
          "list of n names; for 'both' the left arm's first")
      .def_property_readonly(
          "duration", [](const RowedTrajectory& t) { return t.joints.seconds(); }, "seconds")
      .def_property_readonly(
          "times",
          [](const RowedTrajectory& t) {
            std::vector<double> times;
            for (const TrajectoryPoint& point : t.joints.points) times.push_back(point.seconds);
            return ArrayOf(times, {static_cast<py::ssize_t>(times.size())});
          },
          "K seconds since the start, rising")
      .def_property_readonly(
          "positions",
          [](const RowedTrajectory& t) { return Stacked(t, &TrajectoryPoint::positions); },
          "Kx7, or Kx2x7 for 'both' [rad]")
      .def_property_readonly(
          "velocities",
          [](const RowedTrajectory& t) { return Stacked(t, &TrajectoryPoint::velocities); },
          "Kx7, or Kx2x7 for 'both' [rad/s]")
      .def(
          "at",
          [](const RowedTrajectory& t, double seconds) {
            const TrajectoryPoint point = SampleAt(t.joints, seconds);
            const auto shape = ShapeFor(t.num_rows, t.joints.joint_names.size());
            return py::make_tuple(ArrayOf(point.positions, shape),
                                  ArrayOf(point.velocities, shape));
          },
          py::arg("seconds"),
          R"(The angles [rad] and velocities [rad/s] at a moment, each 7, or 2x7 for 'both'.

Before the start it is the first point, after the end the last one, at rest.)");
}

void BindAnswers(py::module_& m) {
  py::class_<LineFault>(m, "LineFault", "Why the tool cannot go along a line.")
      .def_readonly("share", &LineFault::share, "how far it comes, from 0 to 1")
      .def_readonly("reason", &LineFault::reason)
      .def("__repr__", [](const LineFault& fault) {
        return "<LineFault at " + std::to_string(fault.share) + ": " + fault.reason + ">";
      });
  py::class_<InvalidMoment>(m, "InvalidMoment", "When and why a motion cannot be made.")
      .def_readonly("seconds", &InvalidMoment::seconds, "since the start")
      .def_readonly("reason", &InvalidMoment::reason)
      .def("__repr__", [](const InvalidMoment& moment) {
        return "<InvalidMoment at " + std::to_string(moment.seconds) + " s: " + moment.reason + ">";
      });
}

py::object Inverse(const PlanningRobot& robot, const std::string& arm, const Array& goal,
                   const Array& q_start, bool any_turn, double position_tolerance,
                   double angle_tolerance, int max_iterations, std::uint64_t seed) {
  const auto shape = ShapeFor(robot, arm);
  const auto q =
      robot.Inverse(arm, PoseFrom("goal", goal), ConfigurationFrom("q_start", q_start, shape),
                    {.position_tolerance = position_tolerance,
                     .angle_tolerance = angle_tolerance,
                     .any_turn = any_turn,
                     .max_iterations = max_iterations,
                     .seed = seed});
  return q ? py::object(ArrayOf(*q, shape)) : py::none();
}

py::tuple MoveLine(const PlanningRobot& robot, const std::string& arm, const Array& q_from,
                   const Array& goal, double speed, double tool_speed, bool any_turn) {
  auto answer = robot.MoveLine(arm, ConfigurationFrom("q_from", q_from, ShapeFor(robot, arm)),
                               PoseFrom("goal", goal),
                               {.speed = speed, .tool_speed = tool_speed, .any_turn = any_turn});
  if (auto* fault = std::get_if<LineFault>(&answer)) return py::make_tuple(py::none(), *fault);
  return py::make_tuple(RowedTrajectory{arm, 1, std::get<JointTrajectory>(std::move(answer))},
                        py::none());
}

using RobotClass = py::class_<PlanningRobot>;

RobotClass BindRobot(py::module_& m) {
  RobotClass robot_class(m, "Robot", R"(A robot as programs plan with it.

Lengths are in the scene's unit, angles in radians; poses are 4x4 matrices of the tool in the world:
z is the approach direction, y goes across the fingers. Arms are 'left' and 'right'.)");
  robot_class
      .def(py::init([](const std::string& path, const std::optional<Array>& base, double unit,
                       const std::string& gripper) {
             return ReadPlanningRobot(
                 path,
                 base ? PoseFrom("base", *base) : Eigen::Matrix4d(Eigen::Matrix4d::Identity()),
                 unit, gripper);
           }),
           py::arg("path"), py::kw_only(), py::arg("base") = py::none(), py::arg("unit") = 1.0,
           py::arg("gripper") = "",
           R"(Reads a URDF file, and the .robot.json beside it.

base: 4x4, where the robot's base stands in the world [units]; the world is the base without it.
unit: metres per unit; a brain is told it as aux.unit.
gripper: which of the robot's grippers; the usual one without it.)")
      .def("joint_names", &PlanningRobot::JointNames, py::arg("arm"),
           "Names of an arm's joints; of all for 'both'.")
      .def(
          "limits",
          [](const PlanningRobot& robot, const std::string& arm) {
            std::vector<double> lower, upper;
            for (const JointLimits& limit : robot.Limits(arm)) {
              lower.push_back(limit.lower);
              upper.push_back(limit.upper);
            }
            const auto shape = ShapeFor(robot, arm);
            return py::make_tuple(ArrayOf(lower, shape), ArrayOf(upper, shape));
          },
          py::arg("arm"),
          "The least and the greatest angles: two arrays of 7, 2x7 for 'both' [rad].")
      .def(
          "pose",
          [](const PlanningRobot& robot, const std::string& arm, const std::string& name) {
            const auto q = robot.NamedPose(arm, name);
            return q ? py::object(ArrayOf(*q, ShapeFor(robot, arm))) : py::none();
          },
          py::arg("arm"), py::arg("name"),
          "The angles of a pose that comes with the robot, such as 'untucked'; None if it has none "
          "of that name.");
  return robot_class;
}

void BindKinematics(RobotClass& robot_class) {
  const IkOptions ik;
  robot_class
      .def(
          "forward",
          [](const PlanningRobot& robot, const std::string& arm, const Array& q) {
            return ArrayOf(robot.Forward(arm, ConfigurationFrom("q", q, ShapeFor(robot, arm))));
          },
          py::arg("arm"), py::arg("q"), "Where 7 angles bring the tool: 4x4.")
      .def(
          "jacobian",
          [](const PlanningRobot& robot, const std::string& arm, const Array& q) {
            return ArrayOf(robot.Jacobian(arm, ConfigurationFrom("q", q, ShapeFor(robot, arm))));
          },
          py::arg("arm"), py::arg("q"),
          "6x7: how each joint moves the tool, rows 0..2 along x y z [units/s per rad/s], rows "
          "3..5 "
          "about x y z.")
      .def(
          "inverse", &Inverse, py::arg("arm"), py::arg("goal"), py::arg("q_start"), py::kw_only(),
          py::arg("any_turn") = ik.any_turn, py::arg("position_tolerance") = ik.position_tolerance,
          py::arg("angle_tolerance") = ik.angle_tolerance,
          py::arg("max_iterations") = ik.max_iterations, py::arg("seed") = ik.seed,
          R"(Angles that bring the tool to `goal` (4x4), within limits: 7, or None when none are found.

q_start: 7 angles near which to look first.
any_turn: the tool may be turned about its own axis as the arm likes.
position_tolerance [units], angle_tolerance [rad].
max_iterations: of all attempts together, about 1.5 microseconds each.)");
}

void BindPlanning(RobotClass& robot_class) {
  robot_class
      .def(
          "move_joints",
          [](const PlanningRobot& robot, const std::string& arm, const Array& waypoints,
             double speed) {
            return RowedTrajectory{
                arm, robot.NumRows(arm),
                robot.MoveJoints(arm, WaypointsFrom(waypoints, ShapeFor(robot, arm)), speed)};
          },
          py::arg("arm"), py::arg("waypoints"), py::kw_only(), py::arg("speed") = 1.0,
          R"(A motion through waypoints, from rest to rest, within all limits: a Trajectory.

arm: may be 'both'.
waypoints: Kx7, or Kx2x7 for 'both' [rad].
speed: share of the joints' greatest velocities, above 0, at most 1.)")
      .def("move_line", &MoveLine, py::arg("arm"), py::arg("q_from"), py::arg("goal"),
           py::kw_only(), py::arg("speed") = 1.0,
           py::arg("tool_speed") = std::numeric_limits<double>::infinity(),
           py::arg("any_turn") = false,
           R"(Moves the tool along a straight line to `goal` (4x4): (Trajectory, None), or
(None, LineFault) where the arm cannot.

q_from: 7, where the arm is [rad].
speed: share of the joints' greatest velocities, above 0, at most 1.
tool_speed: at most [units/s].
any_turn: the tool may turn about its own axis on the way.)")
      .def(
          "first_invalid",
          [](const PlanningRobot& robot, const RowedTrajectory& trajectory,
             const std::optional<Array>& q_both, std::optional<std::pair<double, double>> table) {
            std::vector<double> q;
            if (q_both) q = ConfigurationFrom("q_both", *q_both, ShapeFor(robot, "both"));
            return robot.FirstInvalid(trajectory.joints, q, table);
          },
          py::arg("trajectory"), py::kw_only(), py::arg("q_both") = py::none(),
          py::arg("table") = py::none(),
          R"(The first InvalidMoment of a Trajectory, None when there is none.

Invalid is what breaks a joint's limit, and where the robot would touch itself or the table.
q_both: 2x7, where the arms stand that do not move [rad]; without it where the robot starts.
table: (width, depth) of a table whose top is z = 0 around the origin [units].)");
}

void BindMotion(py::module_& m) {
  m.doc() = "The compiled half of smile.motion.";
  py::register_exception_translator([](std::exception_ptr raised) {
    try {
      if (raised) std::rethrow_exception(raised);
    } catch (const InputError& error) {
      PyErr_SetString(PyExc_ValueError, error.what());
    }
  });
  BindAnswers(m);
  BindTrajectory(m);
  RobotClass robot_class = BindRobot(m);
  BindKinematics(robot_class);
  BindPlanning(robot_class);
}

}  // namespace
}  // namespace smile::motion

PYBIND11_MODULE(smile_motion_native, m) { smile::motion::BindMotion(m); }
