#include "brain/brain_driver.h"

#include <stdexcept>
#include <utility>

#include "base/files.h"
#include "robot/robot_visuals.h"
#include "scene/units.h"

namespace smile::brain {
namespace {

Eigen::RowVector3d InUnits(const Vector3& p, const sim::Simulation& simulation) {
  return scene::ToFileUnits(p, simulation.scene().meters_per_unit).transpose();
}

LimbJoints AnglesOf(const robot::RobotBody& robot) {
  LimbJoints angles;
  for (int arm = 0; arm < kLimbCount; ++arm) {
    const std::vector<double> q = robot.ArmAngles(arm);
    for (int i = 0; i < kJointCount; ++i) angles(arm, i) = q[i];
  }
  return angles;
}

std::vector<double> RowOf(const LimbJoints& joints, int arm) {
  const Eigen::Matrix<double, 1, kJointCount> row = joints.row(arm);
  return {row.data(), row.data() + kJointCount};
}

/// The named points of the original: shoulders, elbows, wrists, and both ends of each finger.
std::map<std::string, Eigen::RowVector3d, std::less<>> TrackersOf(
    const sim::Simulation& simulation) {
  // Of the classic gripper: half the length and thickness of a finger [m].
  constexpr double kHalfLength = 0.075, kHalfThickness = 0.015;
  const robot::RobotBody& robot = *simulation.robot();
  const scene::FramePoses poses =
      robot::FramePosesOf(robot.model(), robot.base_pose(), robot.positions());
  std::map<std::string, Eigen::RowVector3d, std::less<>> trackers;
  for (int arm = 0; arm < kLimbCount; ++arm) {
    const std::string side = arm == 0 ? "l" : "r";
    const auto& joints = robot.model().arms[arm].joints;
    for (const auto& [name, index] : {std::pair("S1", 1), std::pair("E1", 3), std::pair("W1", 5)}) {
      trackers[side + "-" + name] = InUnits(poses[1 + joints[index]].translation(), simulation);
    }
    const double y = robot.GripperOpening(arm) / 2 + kHalfThickness;
    for (const auto& [finger, sign] : {std::pair("l", 1.0), std::pair("r", -1.0)}) {
      for (const auto& [end, z] : {std::pair("n", -kHalfLength), std::pair("f", kHalfLength)}) {
        trackers[side + "g-" + finger + end] =
            InUnits(robot.ToolPose(arm) * Vector3(0, sign * y, z), simulation);
      }
    }
  }
  return trackers;
}

}  // namespace

bool MayReadTrackers(const std::filesystem::path& brain) {
  constexpr std::size_t kMaxScriptBytes = 4u << 20;
  std::error_code error;
  if (!std::filesystem::is_directory(brain, error)) return true;
  for (const auto& entry : std::filesystem::directory_iterator(brain, error)) {
    if (entry.path().extension() != ".m" || !entry.is_regular_file(error)) continue;
    if (entry.file_size(error) > kMaxScriptBytes) return true;
    const std::string script = ReadFile(entry.path(), kMaxScriptBytes);
    if (script.find("trackerLoc") != std::string::npos) return true;
  }
  return false;
}

std::string_view ToString(BrainStatus status) {
  switch (status) {
    case BrainStatus::kRunning:
      return "running";
    case BrainStatus::kExited:
      return "exited";
    case BrainStatus::kFailed:
      return "failed";
  }
  return "";
}

BrainDriver::BrainDriver(BrainProcess* process, BrainDriverOptions options)
    : process_(process), options_(std::move(options)) {}

Aux BrainDriver::Describe(const sim::Simulation& simulation) const {
  const robot::RobotModel& model = simulation.robot()->model();
  Aux aux;
  for (int arm = 0; arm < kLimbCount; ++arm) {
    for (int i = 0; i < kJointCount; ++i) {
      const physics::LinkSpec& link = model.links[model.arms[arm].joints[i]];
      aux.min_joint_angles(arm, i) = link.lower;
      aux.max_joint_angles(arm, i) = link.upper;
    }
  }
  if (options_.eye != nullptr) {
    const CameraView view = EyeView(simulation, options_.eye->spec());
    aux.camera = CameraDescription{.width_px = view.intrinsics.width_px,
                                   .height_px = view.intrinsics.height_px,
                                   .fx = view.intrinsics.fx,
                                   .fy = view.intrinsics.fy,
                                   .cx = view.intrinsics.cx,
                                   .cy = view.intrinsics.cy};
    aux.camera->X_WC.topLeftCorner<3, 3>() = view.X_WC.rotation();
    aux.camera->X_WC.topRightCorner<3, 1>() =
        InUnits(view.X_WC.translation(), simulation).transpose();
  }
  if (!options_.demonstration.empty()) {
    aux.demonstration = std::filesystem::absolute(options_.demonstration).string();
    aux.attention = options_.attention;
  }
  return aux;
}

Sensor BrainDriver::Sense(const sim::Simulation& simulation) {
  const robot::RobotBody& robot = *simulation.robot();
  Sensor sensor{.time_elapsed = 1.0 / sim::kTicksPerSecond, .sim_time = simulation.seconds()};
  sensor.joint_angles = AnglesOf(robot);
  for (int arm = 0; arm < kLimbCount; ++arm) {
    sensor.end_effector_positions.row(arm) = InUnits(robot.ToolPose(arm).translation(), simulation);
    sensor.gripper_openings(arm) =
        scene::ToFileUnits(robot.GripperOpening(arm), simulation.scene().meters_per_unit);
  }
  if (options_.has_trackers) sensor.tracker_locations = TrackersOf(simulation);
  if (options_.eye != nullptr &&
      simulation.seconds() + 1e-9 >= static_cast<double>(num_images_) * options_.image_seconds) {
    sensor.rgb_vision = options_.eye->Look(simulation);
    ++num_images_;
  }
  return sensor;
}

BrainStatus BrainDriver::Start(sim::Simulation* simulation) {
  const robot::RobotBody* robot = simulation->robot();
  bool has_arms = robot != nullptr && robot->num_arms() == kLimbCount;
  for (int arm = 0; has_arms && arm < kLimbCount; ++arm) {
    has_arms = robot->model().arms[arm].joints.size() == kJointCount;
  }
  if (!has_arms) {
    throw std::invalid_argument("a brain drives a robot with two arms of seven joints each");
  }
  Show(options_.demonstration.empty() ? robot::Mood::kIdle : robot::Mood::kWatching, simulation);
  auto reply = process_->Init(Describe(*simulation));
  if (auto* error = std::get_if<BrainError>(&reply)) return Fail(std::move(*error), simulation);

  const auto& init = std::get<InitReply>(reply);
  if (init.init_joint_angles) {
    simulation->Apply(sim::JointAngles{.left = RowOf(*init.init_joint_angles, 0),
                                       .right = RowOf(*init.init_joint_angles, 1)});
  }
  if (options_.on_markers) {
    std::vector<Vector3> markers;
    for (Eigen::Index i = 0; i < init.draw_markers.rows(); ++i) {
      markers.push_back(scene::FromFileUnits(Vector3(init.draw_markers.row(i).transpose()),
                                             simulation->scene().meters_per_unit));
    }
    options_.on_markers(markers);
  }
  return status_;
}

BrainStatus BrainDriver::Drive(sim::Simulation* simulation) {
  Show(robot::Mood::kWorking, simulation);
  auto reply = process_->Step(Sense(*simulation));
  if (auto* error = std::get_if<BrainError>(&reply)) return Fail(std::move(*error), simulation);
  const auto& step = std::get<StepReply>(reply);
  Send(step.motor, simulation);
  if (step.exit) {
    status_ = BrainStatus::kExited;
    StopRobot(simulation);
    Show(robot::Mood::kDone, simulation);
  }
  return status_;
}

/// Only changes are sent: velocities stay in force, so the log holds one line for a long motion.
void BrainDriver::Send(const Motor& motor, sim::Simulation* simulation) {
  const double unit = simulation->scene().meters_per_unit;
  sim::JointVelocities velocities{
      .left = RowOf(motor.joint_velocities, 0),
      .right = RowOf(motor.joint_velocities, 1),
      .grippers = {{scene::FromFileUnits(motor.gripper_velocities[0], unit),
                    scene::FromFileUnits(motor.gripper_velocities[1], unit)}},
      .head = motor.head_velocity};
  if (motor.joint_angles) {
    // Angles go before velocities, as in the original.
    velocities.left = velocities.right = std::vector<double>(kJointCount, 0.0);
    const sim::JointAngles angles{.left = RowOf(*motor.joint_angles, 0),
                                  .right = RowOf(*motor.joint_angles, 1)};
    if (sent_angles_ != angles) simulation->Apply(angles);
    sent_angles_ = angles;
  } else {
    sent_angles_.reset();
  }
  if (sent_velocities_ != velocities) simulation->Apply(velocities);
  sent_velocities_ = velocities;
}

void BrainDriver::StopRobot(sim::Simulation* simulation) {
  const std::vector<double> still(kJointCount, 0.0);
  simulation->Apply(
      sim::JointVelocities{.left = still, .right = still, .grippers = {{0, 0}}, .head = 0.0});
}

void BrainDriver::Show(robot::Mood mood, sim::Simulation* simulation) {
  if (simulation->mood() != mood) simulation->Apply(sim::Face{.mood = mood});
}

BrainStatus BrainDriver::Fail(BrainError error, sim::Simulation* simulation) {
  status_ = BrainStatus::kFailed;
  error_ = std::move(error);
  StopRobot(simulation);
  Show(robot::Mood::kPuzzled, simulation);
  if (options_.on_markers) options_.on_markers({});
  return status_;
}

}  // namespace smile::brain
