// SMILEMOTION  Kinematics and motions of a robot's arms, for the functions in this folder:
//
//   [results] = smilemotion('smileForward', robot, arm, q)     and so on
//
// A thin door to motion::PlanningRobot. `robot` is the struct that smileRobot makes; robots are
// kept here between calls. Uses the documented MEX C API only. Whatever goes wrong becomes an error
// of Octave that names the function and the argument.

#include "mex.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <exception>
#include <list>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "motion/planning_robot.h"

namespace smile::motion {
namespace {

/// What a call was given, and which function of the folder asks.
struct Call {
  std::string function;
  int num_outputs;
  mxArray** outputs;
  std::vector<const mxArray*> arguments;  ///< after the function's name
};

[[noreturn]] void Reject(const std::string& name, const std::string& expected) {
  throw std::invalid_argument(name + ": expected " + expected);
}

// ---- what comes in ----------------------------------------------------------------------------

std::string TextFrom(const mxArray* value, const std::string& name) {
  if (!value || !mxIsChar(value)) Reject(name, "text");
  if (mxIsEmpty(value)) return "";
  if (mxGetM(value) != 1) Reject(name, "text");
  char* text = mxArrayToString(value);
  if (!text) Reject(name, "text");
  std::string copy(text);
  mxFree(text);
  return copy;
}

/// Real doubles, column by column as they lie there.
const double* NumbersFrom(const mxArray* value, const std::string& name) {
  if (!value || !mxIsDouble(value) || mxIsComplex(value) || mxIsSparse(value)) {
    Reject(name, "real numbers (double)");
  }
  return mxGetPr(value);
}

double NumberFrom(const mxArray* value, const std::string& name) {
  const double* numbers = NumbersFrom(value, name);
  if (mxGetNumberOfElements(value) != 1) Reject(name, "one number");
  return numbers[0];
}

std::string SizeOf(const mxArray* value) {
  std::string text;
  for (mwSize i = 0; i < mxGetNumberOfDimensions(value); ++i) {
    text += (i ? "x" : "") + std::to_string(mxGetDimensions(value)[i]);
  }
  return text;
}

void CheckSize(const mxArray* value, const std::string& name, std::size_t rows,
               std::size_t columns) {
  NumbersFrom(value, name);
  if (mxGetNumberOfDimensions(value) == 2 && mxGetM(value) == rows && mxGetN(value) == columns) {
    return;
  }
  throw std::invalid_argument(name + " is " + SizeOf(value) + ", expected " + std::to_string(rows) +
                              "x" + std::to_string(columns));
}

Eigen::Matrix4d PoseFrom(const mxArray* value, const std::string& name) {
  CheckSize(value, name, 4, 4);
  return Eigen::Map<const Eigen::Matrix4d>(mxGetPr(value));
}

/// One pose, or several, one behind the other: 4x4xN.
std::vector<Eigen::Matrix4d> PosesFrom(const mxArray* value, const std::string& name) {
  const double* numbers = NumbersFrom(value, name);
  const auto* dimensions = mxGetDimensions(value);
  const mwSize num_dimensions = mxGetNumberOfDimensions(value);
  if (num_dimensions > 3 || dimensions[0] != 4 || dimensions[1] != 4 || mxIsEmpty(value)) {
    throw std::invalid_argument(name + " is " + SizeOf(value) + ", expected 4x4 or 4x4xN");
  }
  std::vector<Eigen::Matrix4d> poses;
  for (std::size_t i = 0; i < mxGetNumberOfElements(value); i += 16) {
    poses.emplace_back(Eigen::Map<const Eigen::Matrix4d>(numbers + i));
  }
  return poses;
}

const mxArray* FieldOf(const mxArray* value, const char* field, const std::string& name) {
  const mxArray* found = mxGetField(value, 0, field);
  if (!found) Reject(name, std::string("a field `") + field + "`");
  return found;
}

void CheckStruct(const mxArray* value, const std::string& name, const char* maker) {
  if (value && mxIsStruct(value) && mxGetNumberOfElements(value) == 1) return;
  Reject(name, std::string("what ") + maker + " made");
}

/// How a configuration of an arm, or of both, is written: rows x columns.
struct Shape {
  std::size_t rows, columns;
};

Shape ShapeFor(const PlanningRobot& robot, const std::string& arm) {
  const auto rows = static_cast<std::size_t>(robot.NumRows(arm));
  return {rows, robot.JointNames(arm).size() / rows};
}

/// Row by row, from column by column.
std::vector<double> RowByRow(const double* numbers, Shape shape) {
  std::vector<double> values;
  for (std::size_t i = 0; i < shape.rows; ++i) {
    for (std::size_t j = 0; j < shape.columns; ++j) values.push_back(numbers[i + shape.rows * j]);
  }
  return values;
}

/// Returns the shape of one or more rows of numbers.
Shape RowsFrom(const mxArray* value, const std::string& name, std::size_t columns) {
  NumbersFrom(value, name);
  const Shape shape{mxGetM(value), mxGetN(value)};
  const bool fits = mxGetNumberOfDimensions(value) == 2 && shape.columns == columns;
  if (fits && shape.rows > 0) return shape;
  throw std::invalid_argument(name + " is " + SizeOf(value) + ", expected Nx" +
                              std::to_string(columns));
}

std::vector<double> ConfigurationFrom(const mxArray* value, const std::string& name, Shape shape) {
  CheckSize(value, name, shape.rows, shape.columns);
  return RowByRow(mxGetPr(value), shape);
}

/// K x n for an arm, N x n x K for N arms.
std::vector<std::vector<double>> WaypointsFrom(const mxArray* value, Shape shape) {
  const double* numbers = NumbersFrom(value, "waypoints");
  const mwSize num_dimensions = mxGetNumberOfDimensions(value);
  const auto* dimensions = mxGetDimensions(value);
  const auto is = [](auto size, std::size_t wanted) {
    return static_cast<std::size_t>(size) == wanted;
  };
  std::vector<std::vector<double>> waypoints;
  if (shape.rows == 1) {
    if (num_dimensions != 2 || !is(dimensions[1], shape.columns)) {
      throw std::invalid_argument("waypoints is " + SizeOf(value) + ", expected Kx" +
                                  std::to_string(shape.columns));
    }
    const auto count = static_cast<std::size_t>(dimensions[0]);
    for (std::size_t k = 0; k < count; ++k) {
      std::vector<double>& q = waypoints.emplace_back();
      for (std::size_t j = 0; j < shape.columns; ++j) q.push_back(numbers[k + count * j]);
    }
    return waypoints;
  }
  if (num_dimensions > 3 || !is(dimensions[0], shape.rows) || !is(dimensions[1], shape.columns)) {
    throw std::invalid_argument("waypoints is " + SizeOf(value) + ", expected " +
                                std::to_string(shape.rows) + "x" + std::to_string(shape.columns) +
                                "xK");
  }
  const std::size_t count = num_dimensions == 3 ? static_cast<std::size_t>(dimensions[2]) : 1;
  for (std::size_t k = 0; k < count; ++k) {
    waypoints.push_back(RowByRow(numbers + k * shape.rows * shape.columns, shape));
  }
  return waypoints;
}

// ---- what goes out ----------------------------------------------------------------------------

mxArray* MatrixOf(const Eigen::MatrixXd& matrix) {
  mxArray* made = mxCreateDoubleMatrix(static_cast<mwSize>(matrix.rows()),
                                       static_cast<mwSize>(matrix.cols()), mxREAL);
  std::copy(matrix.data(), matrix.data() + matrix.size(), mxGetPr(made));
  return made;
}

/// Room for matrices in one array: RxC, and RxCxN for N of them.
mxArray* StackOf(Eigen::Index rows, Eigen::Index columns, std::size_t count) {
  const std::array<mwSize, 3> dims{static_cast<mwSize>(rows), static_cast<mwSize>(columns),
                                   static_cast<mwSize>(count)};
  return mxCreateNumericArray(3, dims.data(), mxDOUBLE_CLASS, mxREAL);
}

mxArray* Empty() { return mxCreateDoubleMatrix(0, 0, mxREAL); }

mxArray* ConfigurationOf(const std::vector<double>& values, Shape shape) {
  return MatrixOf(
      Eigen::Map<const Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>>(
          values.data(), static_cast<Eigen::Index>(shape.rows),
          static_cast<Eigen::Index>(shape.columns)));
}

/// Configurations in the shape of waypoints: Kxn for one arm, NxnxK for N arms.
mxArray* ConfigurationsOf(const std::vector<std::vector<double>>& configurations, Shape shape) {
  const std::size_t count = configurations.size();
  const std::array<mwSize, 3> dims{static_cast<mwSize>(shape.rows),
                                   static_cast<mwSize>(shape.columns), static_cast<mwSize>(count)};
  const bool is_one_arm = shape.rows == 1;
  mxArray* array = is_one_arm ? mxCreateDoubleMatrix(dims[2], dims[1], mxREAL)
                              : mxCreateNumericArray(3, dims.data(), mxDOUBLE_CLASS, mxREAL);
  double* to = mxGetPr(array);
  for (std::size_t k = 0; k < count; ++k) {
    for (std::size_t i = 0; i < shape.rows * shape.columns; ++i) {
      const std::size_t row = i / shape.columns, column = i % shape.columns;
      to[is_one_arm ? k + count * column : row + shape.rows * (column + shape.columns * k)] =
          configurations[k][i];
    }
  }
  return array;
}

mxArray* NamesOf(const std::vector<std::string>& names) {
  mxArray* cell = mxCreateCellMatrix(1, static_cast<mwSize>(names.size()));
  for (std::size_t i = 0; i < names.size(); ++i) {
    mxSetCell(cell, static_cast<mwIndex>(i), mxCreateString(names[i].c_str()));
  }
  return cell;
}

mxArray* StructOf(const std::vector<std::pair<const char*, mxArray*>>& fields) {
  std::vector<const char*> names;
  for (const auto& field : fields) names.push_back(field.first);
  mxArray* made = mxCreateStructMatrix(1, 1, static_cast<int>(names.size()), names.data());
  for (const auto& [name, value] : fields) mxSetField(made, 0, name, value);
  return made;
}

// ---- robots and trajectories ------------------------------------------------------------------

/// A robot that was read, and what it was asked for as.
struct KnownRobot {
  std::string file;
  Eigen::Matrix4d base;
  double unit;
  std::string gripper;
  PlanningRobot robot;
};

constexpr std::size_t kMostRobots = 8;

/// The latest first. Kept between calls.
std::list<KnownRobot>& KnownRobots() {
  static std::list<KnownRobot> robots;
  return robots;
}

const PlanningRobot& RobotAs(const std::string& file, const Eigen::Matrix4d& base, double unit,
                             const std::string& gripper) {
  auto& robots = KnownRobots();
  const auto known = std::ranges::find_if(robots, [&](const KnownRobot& robot) {
    return robot.file == file && robot.base == base && robot.unit == unit &&
           robot.gripper == gripper;
  });
  if (known != robots.end()) return known->robot;
  robots.push_front({file, base, unit, gripper, ReadPlanningRobot(file, base, unit, gripper)});
  if (robots.size() > kMostRobots) robots.pop_back();
  return robots.front().robot;
}

const PlanningRobot& RobotFrom(const Call& call) {
  const mxArray* value = call.arguments.empty() ? nullptr : call.arguments[0];
  CheckStruct(value, "robot", "smileRobot");
  return RobotAs(TextFrom(FieldOf(value, "file", "robot"), "robot.file"),
                 PoseFrom(FieldOf(value, "base", "robot"), "robot.base"),
                 NumberFrom(FieldOf(value, "unit", "robot"), "robot.unit"),
                 TextFrom(FieldOf(value, "gripper", "robot"), "robot.gripper"));
}

Eigen::MatrixXd RowsOf(const JointTrajectory& trajectory,
                       std::vector<double> TrajectoryPoint::*values) {
  Eigen::MatrixXd rows(trajectory.points.size(), trajectory.joint_names.size());
  for (Eigen::Index k = 0; k < rows.rows(); ++k) {
    for (Eigen::Index i = 0; i < rows.cols(); ++i) {
      rows(k, i) = (trajectory.points[k].*values)[i];
    }
  }
  return rows;
}

mxArray* TrajectoryOf(const JointTrajectory& trajectory, const std::string& arm, Shape shape) {
  Eigen::MatrixXd times(1, trajectory.points.size());
  for (Eigen::Index k = 0; k < times.cols(); ++k) times(0, k) = trajectory.points[k].seconds;
  return StructOf({{"arm", mxCreateString(arm.c_str())},
                   {"jointNames", NamesOf(trajectory.joint_names)},
                   {"numRows", mxCreateDoubleScalar(static_cast<double>(shape.rows))},
                   {"duration", mxCreateDoubleScalar(trajectory.seconds())},
                   {"times", MatrixOf(times)},
                   {"positions", MatrixOf(RowsOf(trajectory, &TrajectoryPoint::positions))},
                   {"velocities", MatrixOf(RowsOf(trajectory, &TrajectoryPoint::velocities))}});
}

/// One that TrajectoryOf() made; people may have changed it since.
JointTrajectory TrajectoryFrom(const mxArray* value, std::size_t* num_rows) {
  CheckStruct(value, "trajectory", "smileMoveJoints or smileMoveLine");
  const auto field = [&](const char* name) { return FieldOf(value, name, "trajectory"); };
  JointTrajectory trajectory;
  const mxArray* names = field("jointNames");
  if (!mxIsCell(names)) Reject("trajectory.jointNames", "a cell array of names");
  for (std::size_t i = 0; i < mxGetNumberOfElements(names); ++i) {
    trajectory.joint_names.push_back(
        TextFrom(mxGetCell(names, static_cast<mwIndex>(i)), "trajectory.jointNames"));
  }
  const std::size_t num_joints = trajectory.joint_names.size();
  const double rows = NumberFrom(field("numRows"), "trajectory.numRows");
  if (!(rows >= 1 && rows <= 16) || rows != std::floor(rows) ||
      num_joints % static_cast<std::size_t>(rows) != 0) {
    Reject("trajectory.numRows", "1, or the number of arms");
  }
  *num_rows = static_cast<std::size_t>(rows);
  const std::size_t count = mxGetNumberOfElements(field("times"));
  CheckSize(field("times"), "trajectory.times", 1, count);
  CheckSize(field("positions"), "trajectory.positions", count, num_joints);
  CheckSize(field("velocities"), "trajectory.velocities", count, num_joints);
  for (std::size_t k = 0; k < count; ++k) {
    TrajectoryPoint point{.seconds = mxGetPr(field("times"))[k]};
    for (std::size_t i = 0; i < num_joints; ++i) {
      point.positions.push_back(mxGetPr(field("positions"))[k + count * i]);
      point.velocities.push_back(mxGetPr(field("velocities"))[k + count * i]);
    }
    if (k > 0 && !(point.seconds > trajectory.points.back().seconds)) {
      Reject("trajectory.times", "rising numbers");
    }
    trajectory.points.push_back(std::move(point));
  }
  return trajectory;
}

// ---- options ----------------------------------------------------------------------------------

/// 'name', value, 'name', value at the end of a call.
class Options {
 public:
  Options(const Call& call, std::size_t first) : call_(call), first_(first) {
    if (call.arguments.size() > first && (call.arguments.size() - first) % 2 != 0) {
      throw std::invalid_argument("options come in pairs: a name, then its value");
    }
  }
  /// Number `k` of them, false after the last.
  bool Get(std::size_t k, std::string* name, const mxArray** value) const {
    const std::size_t at = first_ + 2 * k;
    if (at >= call_.arguments.size()) return false;
    *name = TextFrom(call_.arguments[at], "the name of an option");
    *value = call_.arguments[at + 1];
    return true;
  }

 private:
  const Call& call_;
  std::size_t first_;
};

bool TruthFrom(const mxArray* value, const std::string& name) {
  if (value && mxIsLogicalScalar(value)) return mxIsLogicalScalarTrue(value);
  return NumberFrom(value, name) != 0;
}

[[noreturn]] void RejectOption(const std::string& name, const std::string& known) {
  throw std::invalid_argument("there is no option '" + name + "', expected " + known);
}

int IntegerFrom(const mxArray* value, const std::string& name) {
  const double number = NumberFrom(value, name);
  if (!(std::abs(number) <= 1e9) || number != std::floor(number)) Reject(name, "a whole number");
  return static_cast<int>(number);
}

// ---- the functions ----------------------------------------------------------------------------

void CheckCount(const Call& call, std::size_t at_least, std::size_t at_most, const char* usage) {
  if (call.arguments.size() >= at_least && call.arguments.size() <= at_most) return;
  throw std::invalid_argument(std::string("expected ") + usage);
}

constexpr std::size_t kManyOptions = 32;

void Robot(const Call& call) {
  CheckCount(call, 4, 4, "file, base, unit, gripper");
  const std::string file = TextFrom(call.arguments[0], "file");
  const Eigen::Matrix4d base = PoseFrom(call.arguments[1], "base");
  const double unit = NumberFrom(call.arguments[2], "unit");
  const std::string gripper = TextFrom(call.arguments[3], "gripper");
  // Requested again: the file may have changed.
  std::erase_if(KnownRobots(), [&](const KnownRobot& known) { return known.file == file; });
  const PlanningRobot& robot = RobotAs(file, base, unit, gripper);

  const Shape shape = ShapeFor(robot, "both");
  std::vector<double> lower, upper;
  for (const JointLimits& limit : robot.Limits("both")) {
    lower.push_back(limit.lower);
    upper.push_back(limit.upper);
  }
  std::vector<std::pair<const char*, mxArray*>> poses;
  std::vector<std::string> names;
  for (const robot::NamedPose& pose : robot.model().poses) names.push_back(pose.name);
  mxArray* angles = mxCreateCellMatrix(1, static_cast<mwSize>(names.size()));
  for (std::size_t i = 0; i < names.size(); ++i) {
    mxSetCell(angles, static_cast<mwIndex>(i),
              ConfigurationOf(robot.NamedPose("both", names[i]).value(), shape));
  }
  call.outputs[0] = StructOf({{"file", mxCreateString(file.c_str())},
                              {"base", MatrixOf(base)},
                              {"unit", mxCreateDoubleScalar(unit)},
                              {"gripper", mxCreateString(gripper.c_str())},
                              {"arms", NamesOf(robot.ArmNames())},
                              {"jointNames", NamesOf(robot.JointNames("both"))},
                              {"minJointAngles", ConfigurationOf(lower, shape)},
                              {"maxJointAngles", ConfigurationOf(upper, shape)},
                              {"poseNames", NamesOf(names)},
                              {"poseAngles", angles}});
}

/// Writes a matrix for each row of the joint angles of one arm: RxC, and RxCxN for N rows.
template <class MatrixAt>
void ForEachRow(const Call& call, MatrixAt matrix_at) {
  CheckCount(call, 3, 3, "robot, arm, q");
  const PlanningRobot& robot = RobotFrom(call);
  const std::string arm = TextFrom(call.arguments[1], "arm");
  const Shape shape = RowsFrom(call.arguments[2], "q", robot.JointNames(arm).size());
  const std::vector<double> angles = RowByRow(mxGetPr(call.arguments[2]), shape);
  for (std::size_t k = 0; k < shape.rows; ++k) {
    const auto q = std::span(angles).subspan(k * shape.columns, shape.columns);
    const auto matrix = matrix_at(robot, arm, q);
    if (k == 0) call.outputs[0] = StackOf(matrix.rows(), matrix.cols(), shape.rows);
    std::copy(matrix.data(), matrix.data() + matrix.size(),
              mxGetPr(call.outputs[0]) + k * matrix.size());
  }
}

void Forward(const Call& call) {
  ForEachRow(call, [](const PlanningRobot& robot, const std::string& arm,
                      std::span<const double> q) { return robot.Forward(arm, q); });
}

void GripperMiddle(const Call& call) {
  CheckCount(call, 3, 3, "robot, arm, opening");
  const PlanningRobot& robot = RobotFrom(call);
  call.outputs[0] = mxCreateDoubleScalar(robot.GripperMiddle(
      TextFrom(call.arguments[1], "arm"), NumberFrom(call.arguments[2], "opening")));
}

void FingerBounds(const Call& call) {
  CheckCount(call, 3, 3, "robot, arm, opening");
  const PlanningRobot& robot = RobotFrom(call);
  call.outputs[0] = MatrixOf(robot.FingerBounds(TextFrom(call.arguments[1], "arm"),
                                                NumberFrom(call.arguments[2], "opening")));
}

void Jacobian(const Call& call) {
  ForEachRow(call, [](const PlanningRobot& robot, const std::string& arm,
                      std::span<const double> q) { return robot.Jacobian(arm, q); });
}

IkOptions IkOptionsFrom(const Call& call, std::size_t first) {
  IkOptions options;
  const Options given(call, first);
  std::string name;
  const mxArray* value = nullptr;
  for (std::size_t k = 0; given.Get(k, &name, &value); ++k) {
    if (name == "anyTurn") {
      options.any_turn = TruthFrom(value, name);
    } else if (name == "anyRotation") {
      options.any_rotation = TruthFrom(value, name);
    } else if (name == "positionTolerance") {
      options.position_tolerance = NumberFrom(value, name);
    } else if (name == "angleTolerance") {
      options.angle_tolerance = NumberFrom(value, name);
    } else if (name == "maxIterations") {
      options.max_iterations = IntegerFrom(value, name);
    } else if (name == "seed") {
      options.seed = static_cast<std::uint64_t>(std::abs(IntegerFrom(value, name)));
    } else {
      RejectOption(
          name, "anyTurn, anyRotation, positionTolerance, angleTolerance, maxIterations or seed");
    }
  }
  return options;
}

void Inverse(const Call& call) {
  CheckCount(call, 4, kManyOptions, "robot, arm, goal, qStart and options");
  const PlanningRobot& robot = RobotFrom(call);
  const std::string arm = TextFrom(call.arguments[1], "arm");
  const Shape shape = ShapeFor(robot, arm);
  const std::vector<Eigen::Matrix4d> goals = PosesFrom(call.arguments[2], "goal");
  std::vector<double> q_start = ConfigurationFrom(call.arguments[3], "qStart", shape);
  const IkOptions options = IkOptionsFrom(call, 4);
  std::vector<std::vector<double>> found;
  std::string reason;
  for (const Eigen::Matrix4d& goal : goals) {
    const auto q = robot.Inverse(arm, goal, q_start, options);
    if (!q) {
      if (call.num_outputs > 1) reason = robot.WhyUnreachable(arm, goal, q_start, options);
      found.clear();
      break;
    }
    found.push_back(*q);
    q_start = *q;
  }
  call.outputs[0] = found.empty() ? Empty() : ConfigurationsOf(found, shape);
  if (call.num_outputs > 1) call.outputs[1] = mxCreateString(reason.c_str());
}

LineOptions LineOptionsFrom(const Call& call, std::size_t first, bool is_line) {
  LineOptions options;
  const Options given(call, first);
  std::string name;
  const mxArray* value = nullptr;
  for (std::size_t k = 0; given.Get(k, &name, &value); ++k) {
    if (name == "speed") {
      options.speed = NumberFrom(value, name);
    } else if (name == "toolSpeed" && is_line) {
      options.tool_speed = NumberFrom(value, name);
    } else if (name == "anyTurn" && is_line) {
      options.any_turn = TruthFrom(value, name);
    } else if (name == "anyRotation" && is_line) {
      options.any_rotation = TruthFrom(value, name);
    } else {
      RejectOption(name, is_line ? "speed, toolSpeed, anyTurn or anyRotation" : "speed");
    }
  }
  return options;
}

void MoveJoints(const Call& call) {
  CheckCount(call, 3, kManyOptions, "robot, arm, waypoints and options");
  const PlanningRobot& robot = RobotFrom(call);
  const std::string arm = TextFrom(call.arguments[1], "arm");
  const Shape shape = ShapeFor(robot, arm);
  const JointTrajectory move = robot.MoveJoints(arm, WaypointsFrom(call.arguments[2], shape),
                                                LineOptionsFrom(call, 3, /*is_line=*/false).speed);
  call.outputs[0] = TrajectoryOf(move, arm, shape);
}

void MoveLine(const Call& call) {
  CheckCount(call, 4, kManyOptions, "robot, arm, qFrom, goal and options");
  const PlanningRobot& robot = RobotFrom(call);
  const std::string arm = TextFrom(call.arguments[1], "arm");
  const Shape shape = ShapeFor(robot, arm);
  const auto answer = robot.MoveLine(arm, ConfigurationFrom(call.arguments[2], "qFrom", shape),
                                     PoseFrom(call.arguments[3], "goal"),
                                     LineOptionsFrom(call, 4, /*is_line=*/true));
  const auto* fault = std::get_if<LineFault>(&answer);
  call.outputs[0] = fault ? Empty() : TrajectoryOf(std::get<JointTrajectory>(answer), arm, shape);
  if (call.num_outputs < 2) return;
  call.outputs[1] = fault ? StructOf({{"fraction", mxCreateDoubleScalar(fault->fraction)},
                                      {"reason", mxCreateString(fault->reason.c_str())}})
                          : Empty();
}

void Sample(const Call& call) {
  CheckCount(call, 2, 2, "trajectory, seconds");
  std::size_t num_rows = 1;
  const JointTrajectory trajectory = TrajectoryFrom(call.arguments[0], &num_rows);
  const double* seconds = NumbersFrom(call.arguments[1], "seconds");
  std::vector<std::vector<double>> positions, velocities;
  for (std::size_t k = 0; k < mxGetNumberOfElements(call.arguments[1]); ++k) {
    TrajectoryPoint point = SampleAt(trajectory, seconds[k]);
    positions.push_back(std::move(point.positions));
    velocities.push_back(std::move(point.velocities));
  }
  const Shape shape{num_rows, trajectory.joint_names.size() / num_rows};
  call.outputs[0] = ConfigurationsOf(positions, shape);
  if (call.num_outputs > 1) call.outputs[1] = ConfigurationsOf(velocities, shape);
}

void FirstInvalid(const Call& call) {
  CheckCount(call, 2, kManyOptions, "robot, trajectory and options");
  const PlanningRobot& robot = RobotFrom(call);
  std::size_t num_rows = 1;
  const JointTrajectory trajectory = TrajectoryFrom(call.arguments[1], &num_rows);
  std::vector<double> q_both;
  std::optional<std::pair<double, double>> table;
  std::optional<HeldBox> held;
  const Options given(call, 2);
  std::string name;
  const mxArray* value = nullptr;
  for (std::size_t k = 0; given.Get(k, &name, &value); ++k) {
    if (name == "qBoth") {
      q_both = ConfigurationFrom(value, name, ShapeFor(robot, "both"));
    } else if (name == "table") {
      CheckSize(value, name, 1, 2);
      table.emplace(mxGetPr(value)[0], mxGetPr(value)[1]);
    } else if (name == "held") {
      const std::vector<double> row = ConfigurationFrom(value, name, {2, 3});
      held.emplace(Vector3(row[0], row[1], row[2]), Vector3(row[3], row[4], row[5]));
    } else {
      RejectOption(name, "qBoth, table or held");
    }
  }
  const auto moment = robot.FirstInvalid(trajectory, q_both, table, held);
  call.outputs[0] = moment ? StructOf({{"seconds", mxCreateDoubleScalar(moment->seconds)},
                                       {"reason", mxCreateString(moment->reason.c_str())}})
                           : Empty();
}

void Carry(const Call& call) {
  struct Function {
    const char* name;
    void (*run)(const Call&);
  };
  constexpr Function kFunctions[] = {{"smileRobot", &Robot},
                                     {"smileForward", &Forward},
                                     {"smileJacobian", &Jacobian},
                                     {"smileGripperMiddle", &GripperMiddle},
                                     {"smileFingerBounds", &FingerBounds},
                                     {"smileInverse", &Inverse},
                                     {"smileMoveJoints", &MoveJoints},
                                     {"smileMoveLine", &MoveLine},
                                     {"smileSample", &Sample},
                                     {"smileFirstInvalid", &FirstInvalid}};
  for (const Function& function : kFunctions) {
    if (call.function == function.name) return function.run(call);
  }
  throw std::invalid_argument("there is no such function");
}

/// Fills `message` instead of throwing: an error of Octave leaves by a jump, which must not pass
/// over anything that has a destructor.
bool Try(int num_outputs, mxArray** outputs, int num_inputs, const mxArray** inputs, char* message,
         std::size_t size) {
  std::string function = "smilemotion";
  try {
    Call call{function, num_outputs, outputs, {}};
    call.function = function = TextFrom(num_inputs > 0 ? inputs[0] : nullptr, "the first argument");
    call.arguments.assign(inputs + 1, inputs + num_inputs);
    Carry(call);
    return true;
  } catch (const std::exception& error) {
    std::snprintf(message, size, "%s: %s", function.c_str(), error.what());
  } catch (...) {
    std::snprintf(message, size, "%s: unknown error", function.c_str());
  }
  return false;
}

}  // namespace
}  // namespace smile::motion

extern "C" void mexFunction(int nlhs, mxArray* plhs[], int nrhs, const mxArray* prhs[]) {
  static char message[1024];
  if (smile::motion::Try(nlhs, plhs, nrhs, prhs, message, sizeof message)) return;
  // Octave's mexErrMsgIdAndTxt() would put our own name before the one of the function that people
  // called.
  mxArray* words[] = {mxCreateString("smile:motion"), mxCreateString("%s"),
                      mxCreateString(message)};
  mexCallMATLAB(0, nullptr, 3, words, "error");
}
