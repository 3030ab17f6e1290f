// The motion of a recorded robot as arrays: channels, tools, and what its grippers were commanded.

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <limits>

#include "arrays.h"
#include "bindings.h"
#include "motion/channels.h"
#include "recording/recording.h"
#include "robot/kinematics.h"

namespace smile::python {
namespace {

using recording::Recording;
using TickArray = py::array_t<std::uint64_t, py::array::c_style | py::array::forcecast>;

const robot::RobotModel& RobotOf(const Recording& recording) {
  if (!recording.robot()) throw std::invalid_argument("the recording has no robot");
  return recording.robot()->model;
}

/// Configurations, one row each, of a robot.
struct Configurations {
  const Array& q;

  Configurations(const robot::RobotModel& model, const Array& rows) : q(rows) {
    if (rows.ndim() != 2 || rows.shape(1) != model.num_joints()) {
      throw std::invalid_argument("joints has shape " + ShapeText(rows) + ", expected (n, " +
                                  std::to_string(model.num_joints()) + ")");
    }
  }
  py::ssize_t size() const { return q.shape(0); }
  std::span<const double> operator[](py::ssize_t row) const {
    return {q.data(row, 0), static_cast<std::size_t>(q.shape(1))};
  }
};

/// [(name, arm of the gripper or None, slides, lower, upper)]
py::list ChannelsOf(const Recording& recording) {
  const robot::RobotModel& model = RobotOf(recording);
  py::list channels;
  for (const motion::TrajectoryChannel& channel : motion::ChannelsOf(model)) {
    const py::object arm = channel.is_gripper()
                               ? py::object(py::str(model.arms[channel.gripper_of].name))
                               : py::object(py::none());
    channels.append(py::make_tuple(channel.name, arm, channel.limits.slides, channel.limits.lower,
                                   channel.limits.upper));
  }
  return channels;
}

/// (n, channels): positions of the channels [rad or m].
Array PositionsOf(const Recording& recording, const Array& joints) {
  const robot::RobotModel& model = RobotOf(recording);
  const Configurations rows(model, joints);
  const std::vector<motion::TrajectoryChannel> channels = motion::ChannelsOf(model);
  Array positions({rows.size(), static_cast<py::ssize_t>(channels.size())});
  double* out = positions.mutable_data();
  for (py::ssize_t row = 0; row < rows.size(); ++row) {
    for (const motion::TrajectoryChannel& channel : channels) {
      *out++ = PositionOf(channel, model, rows[row]);
    }
  }
  return positions;
}

/// (n, arms, 7): poses of the tools in the world.
Array ToolPosesOf(const Recording& recording, const Array& joints) {
  const robot::RobotModel& model = RobotOf(recording);
  const Configurations rows(model, joints);
  Array poses({rows.size(), static_cast<py::ssize_t>(model.arms.size()), py::ssize_t{7}});
  double* out = poses.mutable_data();
  for (py::ssize_t row = 0; row < rows.size(); ++row) {
    for (const robot::Arm& arm : model.arms) {
      WritePose(FramePose(model, recording.model->robot_base_pose(), rows[row], arm.tool), out);
      out += 7;
    }
  }
  return poses;
}

/// Rates of the openings that are in effect, by the index of the arm; NaN where a gripper follows
/// a pose or a trajectory.
class GripperRates {
 public:
  explicit GripperRates(const robot::RobotModel& model)
      : model_(model), rates_(model.arms.size(), 0) {}

  void Apply(const sim::Command& command) {
    if (const auto* velocities = std::get_if<sim::JointVelocities>(&command)) {
      for (const auto& [name, rate] : velocities->grippers) Set(name, rate);
    } else if (const auto* move = std::get_if<sim::MoveGripper>(&command)) {
      Set(move->arm, move->velocity);
    } else if (std::holds_alternative<sim::TakePose>(command) ||
               std::holds_alternative<sim::FollowTrajectory>(command)) {
      std::ranges::fill(rates_, std::numeric_limits<double>::quiet_NaN());
    }
  }
  const std::vector<double>& rates() const { return rates_; }

 private:
  /// `left` and `right` are the first and the second arm of robots that name them otherwise.
  void Set(const std::string& name, double rate) {
    for (std::size_t arm = 0; arm < rates_.size(); ++arm) {
      const bool is_named = name == model_.arms[arm].name || name == "all" ||
                            (arm == 0 && (name == "left" || name == "both")) ||
                            (arm == 1 && (name == "right" || name == "both"));
      if (is_named) rates_[arm] = rate;
    }
  }

  const robot::RobotModel& model_;
  std::vector<double> rates_;
};

/// (n, arms): commanded rates of the openings during the tick after each of `ticks` [m/s].
Array GripperRatesOf(const Recording& recording, const TickArray& ticks) {
  const robot::RobotModel& model = RobotOf(recording);
  GripperRates now(model);
  Array rates({ticks.size(), static_cast<py::ssize_t>(model.arms.size())});
  double* out = rates.mutable_data();
  std::size_t next = 0;
  for (py::ssize_t row = 0; row < ticks.size(); ++row) {
    while (next < recording.commands.size() && recording.commands[next].tick <= ticks.data()[row]) {
      now.Apply(recording.commands[next++].command);
    }
    out = std::ranges::copy(now.rates(), out).out;
  }
  return rates;
}

/// Ticks after which joints were set at once, without motion.
std::vector<std::uint64_t> JumpTicksOf(const Recording& recording) {
  std::vector<std::uint64_t> ticks;
  for (const recording::LoggedCommand& logged : recording.commands) {
    if (std::holds_alternative<sim::JointAngles>(logged.command)) ticks.push_back(logged.tick);
  }
  return ticks;
}

}  // namespace

void BindRobotMotion(py::module_& m) {
  m.def("channels_of", &ChannelsOf);
  m.def("channel_positions", &PositionsOf);
  m.def("tool_poses", &ToolPosesOf);
  m.def("gripper_rates", &GripperRatesOf);
  m.def("jump_ticks", &JumpTicksOf);
  m.def("arm_names_of", [](const Recording& recording) {
    std::vector<std::string> names;
    for (const robot::Arm& arm : RobotOf(recording).arms) names.push_back(arm.name);
    return names;
  });
}

}  // namespace smile::python
