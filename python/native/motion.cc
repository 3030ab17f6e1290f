// smile.motion, the compiled half: a thin door to motion::PlanningRobot.

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <filesystem>
#include <limits>

#include "base/diagnostic.h"
#include "motion/planning_robot.h"
#include "standard_errors.h"

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

/// Returns what an arm holds, from two corners.
HeldBox HeldBoxFrom(const Array& corners) {
  const std::vector<double> row = ConfigurationFrom("held", corners, {2, 3});
  return {Vector3(row[0], row[1], row[2]), Vector3(row[3], row[4], row[5])};
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

/// Positions and velocities at one time, or at each of K times.
py::tuple At(const RowedTrajectory& trajectory, const Array& seconds) {
  if (seconds.ndim() > 1) RejectShape("seconds", seconds, "a single number or K");
  std::vector<double> positions, velocities;
  for (py::ssize_t k = 0; k < seconds.size(); ++k) {
    const TrajectoryPoint point = SampleAt(trajectory.joints, seconds.data()[k]);
    positions.insert(positions.end(), point.positions.begin(), point.positions.end());
    velocities.insert(velocities.end(), point.velocities.begin(), point.velocities.end());
  }
  std::vector<py::ssize_t> shape =
      ShapeFor(trajectory.num_rows, trajectory.joints.joint_names.size());
  if (seconds.ndim() == 1) shape.insert(shape.begin(), seconds.size());
  return py::make_tuple(ArrayOf(positions, shape), ArrayOf(velocities, shape));
}

void BindTrajectory(py::module_& m) {
  py::class_<RowedTrajectory>(m, "Trajectory", R"(Motion of the joints of an arm, or of all arms.

Between points, each joint follows the cubic through their positions and velocities.)")
      .def_readonly("arm", &RowedTrajectory::arm, "name of the arm, or 'both'")
      .def_property_readonly(
          "joint_names", [](const RowedTrajectory& t) { return t.joints.joint_names; },
          "list of n names; for 'both', those of all arms")
      .def_property_readonly(
          "duration", [](const RowedTrajectory& t) { return t.joints.seconds(); }, "seconds")
      .def_property_readonly(
          "times",
          [](const RowedTrajectory& t) {
            std::vector<double> times;
            for (const TrajectoryPoint& point : t.joints.points) times.push_back(point.seconds);
            return ArrayOf(times, {static_cast<py::ssize_t>(times.size())});
          },
          "K times since the start, increasing [s]")
      .def_property_readonly(
          "positions",
          [](const RowedTrajectory& t) { return Stacked(t, &TrajectoryPoint::positions); },
          "Kxn, or KxNxn for 'both' [rad; m]")
      .def_property_readonly(
          "velocities",
          [](const RowedTrajectory& t) { return Stacked(t, &TrajectoryPoint::velocities); },
          "Kxn, or KxNxn for 'both' [rad/s; m/s]")
      .def("at", &At, py::arg("seconds"),
           R"(Positions and velocities at a time, each n, or Nxn for 'both'.

Of K times, each Kxn, or KxNxn for 'both'. The arm rests at the first point before the start, and at
the last point after the end.)");
}

void BindAnswers(py::module_& m) {
  py::class_<LineFault>(m, "LineFault", "Reason why the tool cannot follow a line.")
      .def_readonly("fraction", &LineFault::fraction, "completed fraction, from 0 to 1")
      .def_readonly("reason", &LineFault::reason, "in words")
      .def("__repr__", [](const LineFault& fault) {
        return "<LineFault at " + std::to_string(fault.fraction) + ": " + fault.reason + ">";
      });
  py::class_<InvalidMoment>(m, "InvalidMoment",
                            "Time and reason at which a motion becomes invalid.")
      .def_readonly("seconds", &InvalidMoment::seconds, "since the start")
      .def_readonly("reason", &InvalidMoment::reason, "in words")
      .def("__repr__", [](const InvalidMoment& moment) {
        return "<InvalidMoment at " + std::to_string(moment.seconds) + " s: " + moment.reason + ">";
      });
}

py::object Inverse(const PlanningRobot& robot, const std::string& arm, const Array& goal,
                   const Array& q_start, bool any_turn, bool any_rotation,
                   double position_tolerance, double angle_tolerance, int max_iterations,
                   std::uint64_t seed) {
  const auto shape = ShapeFor(robot, arm);
  const auto q =
      robot.Inverse(arm, PoseFrom("goal", goal), ConfigurationFrom("q_start", q_start, shape),
                    {.position_tolerance = position_tolerance,
                     .angle_tolerance = angle_tolerance,
                     .any_turn = any_turn,
                     .any_rotation = any_rotation,
                     .max_iterations = max_iterations,
                     .seed = seed});
  return q ? py::object(ArrayOf(*q, shape)) : py::none();
}

std::string WhyUnreachable(const PlanningRobot& robot, const std::string& arm, const Array& goal,
                           const Array& q_start, bool any_turn) {
  return robot.WhyUnreachable(arm, PoseFrom("goal", goal),
                              ConfigurationFrom("q_start", q_start, ShapeFor(robot, arm)),
                              {.any_turn = any_turn});
}

py::tuple MoveLine(const PlanningRobot& robot, const std::string& arm, const Array& q_from,
                   const Array& goal, double speed, double tool_speed, bool any_turn,
                   bool any_rotation) {
  auto answer = robot.MoveLine(arm, ConfigurationFrom("q_from", q_from, ShapeFor(robot, arm)),
                               PoseFrom("goal", goal),
                               {.speed = speed,
                                .tool_speed = tool_speed,
                                .any_turn = any_turn,
                                .any_rotation = any_rotation});
  if (auto* fault = std::get_if<LineFault>(&answer)) return py::make_tuple(py::none(), *fault);
  return py::make_tuple(RowedTrajectory{arm, 1, std::get<JointTrajectory>(std::move(answer))},
                        py::none());
}

using RobotClass = py::class_<PlanningRobot>;

RobotClass BindRobot(py::module_& m) {
  RobotClass robot_class(m, "Robot", R"(Robot model for planning.

Lengths are in the scene's unit, angles in radians; poses are 4x4 matrices of the tool in the world:
z is the approach direction, y goes across the fingers. Arms have names; 'both' means all arms. An
arm has n joints. Where all N arms have n joints, arrays for 'both' are Nxn, otherwise the joints of
all arms in one row.)");
  robot_class
      .def(py::init([](const std::filesystem::path& path, const std::optional<Array>& base,
                       double unit, const std::string& gripper) {
             return ReadPlanningRobot(
                 path,
                 base ? PoseFrom("base", *base) : Eigen::Matrix4d(Eigen::Matrix4d::Identity()),
                 unit, gripper);
           }),
           py::arg("path"), py::kw_only(), py::arg("base") = py::none(), py::arg("unit") = 1.0,
           py::arg("gripper") = "",
           R"(Reads a URDF file, and the .robot.json beside it.

base: 4x4, pose of the robot's base in the world [units]; by default the world is the base.
unit: meters per unit; brains receive it as aux.unit.
gripper: name of the robot's gripper; by default its default gripper.)")
      .def_property_readonly("arms", &PlanningRobot::ArmNames, "names of the arms")
      .def("joint_names", &PlanningRobot::JointNames, py::arg("arm"),
           "Names of an arm's joints; for 'both', of all joints.")
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
          "Lower and upper limits of the joints: two arrays of n, or Nxn for 'both' [rad; m].")
      .def(
          "pose",
          [](const PlanningRobot& robot, const std::string& arm, const std::string& name) {
            const auto q = robot.NamedPose(arm, name);
            return q ? py::object(ArrayOf(*q, ShapeFor(robot, arm))) : py::none();
          },
          py::arg("arm"), py::arg("name"),
          "Angles of a named pose of the robot, such as 'untucked'; None if it has no pose of that "
          "name.");
  robot_class.def(
      "gripper_middle", &PlanningRobot::GripperMiddle, py::arg("arm"), py::arg("opening"),
      R"(Place of the middle between both sides of the gripper at an opening, along y of the tool [units].

0 for fingers that slide apart, but not where one jaw is fixed.
opening: free width between the sides [units].)");
  robot_class.def(
      "finger_bounds",
      [](const PlanningRobot& robot, const std::string& arm, double opening) {
        return ArrayOf(robot.FingerBounds(arm, opening));
      },
      py::arg("arm"), py::arg("opening"),
      R"(Box around what moves when the gripper opens, such as its two fingers, at an opening: 2x3.

The least and the greatest x y z in the frame of the tool [units].
opening: free width between the sides [units].)");
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
          py::arg("arm"), py::arg("q"), "Pose of the tool at n joint positions: 4x4.")
      .def(
          "jacobian",
          [](const PlanningRobot& robot, const std::string& arm, const Array& q) {
            return ArrayOf(robot.Jacobian(arm, ConfigurationFrom("q", q, ShapeFor(robot, arm))));
          },
          py::arg("arm"), py::arg("q"),
          "Velocity of the tool per joint velocity: 6xn, rows 0..2 along x y z [units/s per "
          "rad/s], "
          "rows 3..5 about x y z.")
      .def(
          "inverse", &Inverse, py::arg("arm"), py::arg("goal"), py::arg("q_start"), py::kw_only(),
          py::arg("any_turn") = ik.any_turn, py::arg("any_rotation") = ik.any_rotation,
          py::arg("position_tolerance") = ik.position_tolerance,
          py::arg("angle_tolerance") = ik.angle_tolerance,
          py::arg("max_iterations") = ik.max_iterations, py::arg("seed") = ik.seed,
          R"(n joint positions within the limits that put the tool at `goal` (4x4), or None if none are found.

q_start: n positions at which the search starts.
any_turn: any rotation of the tool about its own axis is accepted.
any_rotation: any rotation of the tool is accepted; only its position matters. Arms of fewer than
six joints cannot take every rotation.
position_tolerance [units], angle_tolerance [rad].
max_iterations: limit for all attempts together; about 1.5 microseconds each.)")
      .def("why_unreachable", &WhyUnreachable, py::arg("arm"), py::arg("goal"), py::arg("q_start"),
           py::kw_only(), py::arg("any_turn") = ik.any_turn,
           "Reason why inverse() returns None, for people: str.");
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
          R"(Plans a motion through waypoints, from rest to rest, within all limits: a Trajectory.

arm: may be 'both'.
waypoints: Kxn, or KxNxn for 'both' [rad; m].
speed: fraction of the joints' maximum velocities, above 0, at most 1.)")
      .def("move_line", &MoveLine, py::arg("arm"), py::arg("q_from"), py::arg("goal"),
           py::kw_only(), py::arg("speed") = 1.0,
           py::arg("tool_speed") = std::numeric_limits<double>::infinity(),
           py::arg("any_turn") = false, py::arg("any_rotation") = false,
           R"(Moves the tool along a straight line to `goal` (4x4): (Trajectory, None), or
(None, LineFault) if the arm cannot follow the line.

q_from: n, positions at the start [rad; m].
speed: fraction of the joints' maximum velocities, above 0, at most 1.
tool_speed: maximum speed of the tool [units/s].
any_turn: the tool may rotate about its own axis during the motion.
any_rotation: the tool may rotate in any way.)")
      .def(
          "first_invalid",
          [](const PlanningRobot& robot, const RowedTrajectory& trajectory,
             const std::optional<Array>& q_both, std::optional<std::pair<double, double>> table,
             const std::optional<Array>& held) {
            std::vector<double> q;
            if (q_both) q = ConfigurationFrom("q_both", *q_both, ShapeFor(robot, "both"));
            std::optional<HeldBox> box;
            if (held) box = HeldBoxFrom(*held);
            return robot.FirstInvalid(trajectory.joints, q, table, box);
          },
          py::arg("trajectory"), py::kw_only(), py::arg("q_both") = py::none(),
          py::arg("table") = py::none(), py::arg("held") = py::none(),
          R"(First InvalidMoment of a Trajectory, or None if the trajectory is valid.

A moment is invalid if a joint exceeds a limit, or if the robot touches itself or the table.
q_both: Nxn as for 'both', positions of the arms that do not move [rad; m]; default: the robot's start angles.
table: (width, depth) of a table centered at the origin, with its top at z = 0 [units].
held: 2x3, lower and upper corner of a box around what the arm that moves holds, in the frame of its tool
[units]; it counts as part of the hand.)");
}

void BindMotion(py::module_& m) {
  m.doc() = "Compiled part of smile.motion.";
  python::RegisterStandardErrors();
  py::register_local_exception_translator([](std::exception_ptr raised) {
    try {
      if (raised) std::rethrow_exception(raised);
    } catch (const InputError& error) {
      PyErr_SetObject(PyExc_ValueError, python::MessageText(error.what()).ptr());
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
