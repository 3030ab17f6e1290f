#include "brain/brain_driver.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "base/files.h"
#include "brain/brain_messages.h"
#include "motion/channels.h"
#include "robot/robot_visuals.h"
#include "scene/bounds.h"
#include "scene/solid.h"
#include "scene/units.h"

namespace smile::brain {
namespace {

Eigen::RowVector3d InUnits(const Vector3& p, const sim::Simulation& simulation) {
  return scene::ToFileUnits(p, simulation.scene().meters_per_unit).transpose();
}

/// Returns a pose as a 4x4 matrix with its translation in units.
Eigen::Matrix4d MatrixInUnits(const RigidTransform& X_WF, const sim::Simulation& simulation) {
  Eigen::Matrix4d matrix = Eigen::Matrix4d::Identity();
  matrix.topLeftCorner<3, 3>() = X_WF.rotation();
  matrix.topRightCorner<3, 1>() = InUnits(X_WF.translation(), simulation).transpose();
  return matrix;
}

/// Returns the pinhole parameters [px] and the pose of a camera, with its position in units.
CameraDescription DescribeCamera(const CameraView& view, const sim::Simulation& simulation) {
  return {.width_px = view.intrinsics.width_px,
          .height_px = view.intrinsics.height_px,
          .fx = view.intrinsics.fx,
          .fy = view.intrinsics.fy,
          .cx = view.intrinsics.cx,
          .cy = view.intrinsics.cy,
          .X_WC = MatrixInUnits(view.X_WC, simulation)};
}

/// Returns a copy of the requested channels, with depth in units.
Image InUnits(const Image& image, const sim::Channels& channels, double meters_per_unit) {
  Image copy{.width_px = image.width_px, .height_px = image.height_px};
  if (channels.rgb) copy.color = image.color;
  if (channels.depth) copy.depth = image.depth;
  if (channels.id) copy.ids = image.ids;
  for (float& depth : copy.depth) {
    depth = static_cast<float>(scene::ToFileUnits(static_cast<double>(depth), meters_per_unit));
  }
  return copy;
}

/// Returns the object that a gripper holds; the first one if it holds several, empty if none.
std::string HeldObject(const sim::Simulation& simulation, int arm) {
  const std::vector<physics::BodyId> bodies = simulation.robot()->HeldBodies(arm);
  return bodies.empty() ? "" : simulation.tabletop().Find(bodies.front())->id();
}

/// Throws std::invalid_argument unless the robot has arms. Checked before the first question only:
/// a model is immutable, so the arms cannot change during a run.
void RequireArms(const sim::Simulation& simulation) {
  const world::RobotBody* robot = simulation.robot();
  if (robot == nullptr || robot->num_arms() == 0) {
    throw std::invalid_argument(
        "a brain drives the arms of a robot, and this simulation has none; arms are named in the "
        "robot's side file");
  }
}

/// Returns true for two arms of seven joints, whose trackers the original has.
bool IsClassic(const robot::RobotModel& model) {
  return model.arms.size() == kLimbCount && std::ranges::all_of(model.arms, [](const auto& arm) {
           return arm.joints.size() == kJointCount;
         });
}

/// Returns the constant data of an arm.
ArmDescription DescribeArm(const robot::RobotModel& model, const robot::Arm& arm,
                           const sim::Simulation& simulation) {
  const robot::Frame& tool = model.frames[arm.tool];
  ArmDescription description{.name = arm.name, .X_LG = MatrixInUnits(tool.X_LF, simulation)};
  for (const int joint : arm.joints) {
    const scene::LinkSpec& link = model.links[joint];
    description.joint_names.push_back(link.joint_name);
    description.min_joints.push_back(link.lower);
    description.max_joints.push_back(link.upper);
    description.max_velocities.push_back(link.max_velocity);
  }
  const motion::TrajectoryChannel* gripper = nullptr;
  const std::vector<motion::TrajectoryChannel> channels = motion::ChannelsOf(model);
  if (arm.gripper) gripper = motion::FindChannel(channels, arm.name + "_gripper");
  if (gripper != nullptr) {
    const double unit = simulation.scene().meters_per_unit;
    description.gripper = {scene::ToFileUnits(gripper->limits.lower, unit),
                           scene::ToFileUnits(gripper->limits.upper, unit)};
  }
  return description;
}

/// Returns the named points of the original: shoulders, elbows, wrists, and both ends of each
/// finger [units].
std::map<std::string, Eigen::RowVector3d, std::less<>> TrackersOf(
    const sim::Simulation& simulation) {
  // Half the length and thickness of a finger of the classic gripper [m].
  constexpr double kHalfLength = 0.075, kHalfThickness = 0.015;
  const world::RobotBody& robot = *simulation.robot();
  const scene::FramePoses poses =
      robot::FramePosesOf(robot.model(), robot.base_pose(), robot.positions());
  std::map<std::string, Eigen::RowVector3d, std::less<>> trackers;
  for (int arm = 0; arm < kLimbCount; ++arm) {
    const std::string side = arm == 0 ? "l" : "r";
    const auto& joints = robot.model().arms[arm].joints;
    // An arm's joints are S0, S1, E0, E1, W0, W1, W2: these three carry the shoulder, elbow and
    // wrist.
    for (const auto& [name, index] : {std::pair("S1", 1), std::pair("E1", 3), std::pair("W1", 5)}) {
      // Frame 0 of a robot is its base; link i has frame i + 1.
      trackers[side + "-" + name] = InUnits(poses[1 + joints[index]].translation(), simulation);
    }
    // The opening is the free width between the pads; the finger's axis lies half a thickness
    // beyond it, on the y axis of the tool. The fingers extend along its z axis.
    const double y = robot.GripperOpening(arm) / 2 + kHalfThickness;
    // Names as in `lg-rf`: left gripper, right finger, far end (`n` is the end near the wrist).
    // Scripts of 2015 read them, so both places and names are part of the interface.
    for (const auto& [finger, sign] : {std::pair("l", 1.0), std::pair("r", -1.0)}) {
      for (const auto& [end, z] : {std::pair("n", -kHalfLength), std::pair("f", kHalfLength)}) {
        trackers[side + "g-" + finger + end] =
            InUnits(robot.ToolPose(arm) * Vector3(0, sign * y, z), simulation);
      }
    }
  }
  return trackers;
}

/// Returns the objects of the scene; objects that are added later are not described.
std::vector<ObjectDescription> DescribeObjects(const sim::Simulation& simulation) {
  const double unit = simulation.scene().meters_per_unit;
  std::vector<ObjectDescription> objects;
  for (const scene::ObjectSpec& object : simulation.scene().objects) {
    const std::vector<scene::Solid> solids = scene::SolidsOf(object.whole);
    const Vector3 size = scene::BoundsOf(solids, RigidTransform()).size();
    const Color color = solids.empty() ? object.whole.color : solids.front().color;
    objects.push_back({.id = object.id(),
                       .size = scene::ToFileUnits(size, unit).transpose(),
                       .color = {color.red, color.green, color.blue}});
  }
  return objects;
}

/// Returns the poses of the first objects.
std::vector<Eigen::Matrix4d> PosesOf(std::size_t count, const sim::Simulation& simulation) {
  const std::vector<world::Object>& objects = simulation.tabletop().objects();
  std::vector<Eigen::Matrix4d> poses(count, Eigen::Matrix4d::Constant(std::nan("")));
  for (std::size_t k = 0; k < std::min(count, objects.size()); ++k) {
    if (const auto X_WB = simulation.tabletop().PoseOf(objects[k])) {
      poses[k] = MatrixInUnits(*X_WB, simulation);
    }
  }
  return poses;
}

}  // namespace

MayRead WhatMayBeRead(const std::filesystem::path& brain) {
  constexpr std::uintmax_t kMaxScriptBytes = 4u << 20;
  constexpr int kMaxEntries = 10'000;
  std::error_code error, of_listing;
  // Python files and executables are not searched: there, these values cost little.
  if (!std::filesystem::is_directory(brain, error)) return {};
  MayRead read{.trackers = false, .arms = false};
  int num_entries = 0;
  // A brain may have its scripts in subfolders. What cannot be searched may read everything.
  for (std::filesystem::recursive_directory_iterator it(brain, of_listing), end; it != end;
       it.increment(of_listing)) {
    if (++num_entries > kMaxEntries) return {};
    if (it->path().extension() != ".m" || !it->is_regular_file(error)) continue;
    if (it->file_size(error) > kMaxScriptBytes) return {};
    const std::string script = ReadFile(it->path(), kMaxScriptBytes);
    if (script.find("trackerLoc") != std::string::npos) read.trackers = true;
    if (script.find(".arms") != std::string::npos) read.arms = true;
  }
  return of_listing ? MayRead() : read;
}

std::string_view ToString(BrainStatus status) {
  switch (status) {
    case BrainStatus::kStarting:
      return "starting";
    case BrainStatus::kRunning:
      return "running";
    case BrainStatus::kExited:
      return "exited";
    case BrainStatus::kFailed:
      return "failed";
  }
  return "";
}

// Lock-step: the simulation stands still while the brain computes, so that the speed of neither the
// machine nor the script affects the run.
BrainStatus BrainDriver::Drive(BrainProcess* process, sim::Simulation* simulation) {
  const std::optional<BrainQuestion> question = NextQuestion(simulation);
  return question ? Take(process->Answer(*question), simulation) : status_;
}

std::optional<BrainQuestion> BrainDriver::NextQuestion(sim::Simulation* simulation) {
  if (status_ == BrainStatus::kStarting) {
    RequireArms(*simulation);
    Show(options_.demonstration.empty() ? robot::FaceExpression::kIdle
                                        : robot::FaceExpression::kWatching,
         simulation);
    return Describe(*simulation);
  }
  // While the brain watches, it gets frames of the demonstration in place of the robot's view.
  if (frame_) return SenseDemonstration(*simulation);
  if (ContinueChunk(simulation)) return std::nullopt;
  if (!image_start_tick_) image_start_tick_ = simulation->tick();
  Show(robot::FaceExpression::kWorking, simulation);
  return Sense(*simulation);
}

BrainStatus BrainDriver::Take(BrainAnswer answer, sim::Simulation* simulation) {
  // The variant holds exactly one alternative, so exactly one of these functions runs. Commands
  // that they apply are logged with the present tick, before the tick that follows.
  if (const auto* init = std::get_if<InitReply>(&answer)) Begin(*init, simulation);
  if (const auto* step = std::get_if<StepReply>(&answer)) MakeStep(*step, simulation);
  if (auto* error = std::get_if<BrainError>(&answer)) Fail(std::move(*error), simulation);
  return status_;
}

// The classic variables say the same of a classic robot.
bool BrainDriver::SendsArms(const robot::RobotModel& model) const {
  return options_.may_read.arms || !IsClassic(model);
}

// Everything here is constant during a run, except for the pose of the camera, which each picture
// repeats. Angles and velocities are in SI units, lengths in units.
Aux BrainDriver::Describe(const sim::Simulation& simulation) const {
  const robot::RobotModel& model = simulation.robot()->model();
  Aux aux;
  for (const robot::Arm& arm : model.arms) {
    aux.arms.push_back(DescribeArm(model, arm, simulation));
  }
  aux.sends_arms = SendsArms(model);
  aux.meters_per_unit = simulation.scene().meters_per_unit;
  aux.X_WBase = MatrixInUnits(simulation.robot()->base_pose(), simulation);
  const scene::TableSpec& table = simulation.scene().table;
  aux.table_size = Eigen::RowVector2d(table.x_span, table.y_span) / aux.meters_per_unit;
  aux.robot_files = simulation.model().robot_placement()->files;
  aux.robot_gripper = simulation.model().robot_placement()->gripper;
  if (options_.eye != nullptr) {
    // Without an eye, a brain receives no names of cameras, so it can request none of them.
    aux.camera = DescribeCamera(EyeView(simulation, options_.eye->spec()), simulation);
    aux.camera_names = CameraNames(simulation.model());
  }
  if (!options_.demonstration.empty()) {
    aux.demonstration = std::filesystem::absolute(options_.demonstration).string();
    aux.attention = options_.attention;
    aux.plan = options_.plan;
  }
  aux.variation = options_.variation;
  if (options_.gives_poses) aux.objects = DescribeObjects(simulation);
  return aux;
}

// Everything but pictures: lengths in units, angles in rad, times in seconds.
Sensor BrainDriver::SenseBody(const sim::Simulation& simulation) {
  const world::RobotBody& robot = *simulation.robot();
  Sensor sensor{.time_elapsed = SecondsSinceStep(simulation), .sim_time = simulation.seconds()};
  last_step_tick_ = simulation.tick();
  for (int arm = 0; arm < robot.num_arms(); ++arm) {
    ArmSensor& sensed =
        sensor.arms.emplace_back(ArmSensor{.joints = robot.ArmAngles(arm),
                                           .velocities = robot.ArmVelocities(arm),
                                           .X_WG = MatrixInUnits(robot.ToolPose(arm), simulation),
                                           .held_object = HeldObject(simulation, arm)});
    if (!robot.model().arms[arm].gripper) continue;
    sensed.gripper =
        scene::ToFileUnits(robot.GripperOpening(arm), simulation.scene().meters_per_unit);
  }
  sensor.sends_arms = SendsArms(robot.model());
  if (options_.may_read.trackers && IsClassic(robot.model())) {
    sensor.tracker_locations = TrackersOf(simulation);
  }
  sensor.head_angle = robot.HeadAngle();
  return sensor;
}

Sensor BrainDriver::Sense(const sim::Simulation& simulation) {
  Sensor sensor = SenseBody(simulation);
  if (TakePictureTurn(simulation)) AddPictures(simulation, &sensor);
  AddNoise(options_.noise, simulation.tick(), &sensor);
  if (options_.gives_poses) sensor.object_poses = PosesOf(num_described_objects_, simulation);
  return sensor;
}

// The demonstration advances in simulated time, not step by step: a frame is due at the tick at
// which it was recorded, counted from the end of init. A brain that measures `timeElapsed` thereby
// sees the pace of the demonstrator, and between two frames the simulation ticks without a
// question.
std::optional<Sensor> BrainDriver::SenseDemonstration(const sim::Simulation& simulation) {
  const std::uint64_t tick = simulation.tick();
  if (tick < begin_tick_)
    return std::nullopt;  // an undo went back before the start; continues from there
  watched_ticks_ = tick - begin_tick_ + 1;
  if (tick < begin_tick_ + frame_->tick) return std::nullopt;
  Sensor sensor = SenseBody(simulation);
  sensor.demo_cue = true;
  AddNoise(options_.noise, tick, &sensor);
  // The recorded picture, without noise.
  sensor.pictures.push_back(
      {.camera = DescribeCamera(frame_->view, simulation), .image = frame_->image});
  return sensor;
}

double BrainDriver::SecondsSinceStep(const sim::Simulation& simulation) const {
  // After an undo the clock may show an earlier time than at the previous step.
  const bool is_later = last_step_tick_ && simulation.tick() > *last_step_tick_;
  return sim::SecondsOf(is_later ? simulation.tick() - *last_step_tick_ : 1);
}

bool BrainDriver::ContinueChunk(sim::Simulation* simulation) {
  if (!chunk_) return false;
  const std::uint64_t tick = simulation->tick();
  // A caller may ask twice before a tick.
  const bool follows = tick == chunk_->last_tick || tick == chunk_->last_tick + 1;
  if (!follows || tick >= chunk_->end_tick) {
    chunk_.reset();
    return false;
  }
  chunk_->last_tick = tick;
  const std::size_t index = tick - chunk_->first_tick;
  if (index < chunk_->motors.size()) Send(chunk_->motors[index], simulation);
  return true;
}

void BrainDriver::TakeNextFrame(sim::Simulation* simulation) {
  try {
    frame_ = options_.frames();
    // Recordings come from outside: an oversized frame must fail here with a reason, before it is
    // encoded.
    if (frame_ && frame_->image.color.size() > kMaxPictureBytes) {
      throw std::runtime_error("its pictures are too large for a message, expected at most " +
                               std::to_string(kMaxPictureBytes >> 20) + " MiB");
    }
  } catch (const std::exception& error) {
    frame_.reset();
    Fail({.phase = BrainError::Phase::kCallback,
          .message = std::string("the demonstration cannot be shown: ") + error.what()},
         simulation);
  }
  // The source may hold a whole recording and a renderer in memory; the brain is done watching.
  if (!frame_) options_.frames = nullptr;
}

// The schedule counts periods from its start instead of adding them to the last picture: errors do
// not accumulate, and a period of 0 makes each step due. A step gets one picture, however many
// periods have passed since the previous step.
bool BrainDriver::TakePictureTurn(const sim::Simulation& simulation) {
  if (options_.eye == nullptr || wishes_.channels == sim::Channels{.rgb = false}) return false;
  const double period = wishes_.image_seconds.value_or(options_.image_seconds);
  // The tolerance absorbs rounding, so that a picture due exactly now is not late by a tick.
  const double seconds =
      simulation.seconds() - sim::SecondsOf(image_start_tick_.value_or(0)) + 1e-9;
  if (seconds < num_image_periods_ * period) return false;
  // Periods up to a tick are due in each step.
  if (period > sim::SecondsOf(1)) num_image_periods_ = std::floor(seconds / period) + 1;
  return true;
}

void BrainDriver::ChangeImagePeriod(double seconds, const sim::Simulation& simulation) {
  if (seconds == wishes_.image_seconds) return;
  wishes_.image_seconds = seconds;
  // While the brain watches, its own schedule has not started.
  if (!image_start_tick_) return;
  image_start_tick_ = simulation.tick();
  num_image_periods_ = 1;
}

// Pictures hold meters and world poses of the model; they become units here, at the boundary, and
// only for the channels that the brain requested: others would cost time and bandwidth.
void BrainDriver::AddPictures(const sim::Simulation& simulation, Sensor* sensor) {
  const scene::VisualModel& model = simulation.model().visual_model();
  const auto add = [&](const sim::EyeSpec& spec, const std::string& name) {
    sim::ViewSample sample = ViewSampleOf(simulation, spec);
    sample.channels = wishes_.channels;
    const Image& image = options_.eye->Draw(model, sample);
    sensor->pictures.push_back(
        {.camera = DescribeCamera(sample.view, simulation),
         .image = InUnits(image, wishes_.channels, simulation.scene().meters_per_unit),
         .name = name});
  };
  // The eye comes first, since brain_values.h promises this order.
  sim::EyeSpec spec = options_.eye->spec();
  add(spec, "");
  for (const std::string& camera : wishes_.cameras) {
    // The same eye renders all cameras; only the name of the camera differs.
    spec.camera = camera;
    add(spec, camera);
  }
  if (wishes_.channels.id) {
    // Id 0 is the background, so names begin with that of id 1.
    sensor->segment_names.assign(model.object_names.begin() + 1, model.object_names.end());
  }
}

void BrainDriver::Begin(const InitReply& reply, sim::Simulation* simulation) {
  status_ = BrainStatus::kRunning;
  sim::JointAngles angles;
  const std::vector<robot::Arm>& arms = simulation->robot()->model().arms;
  for (std::size_t k = 0; k < reply.init_joints.size(); ++k) {
    if (reply.init_joints[k]) angles.arms[arms[k].name] = *reply.init_joints[k];
  }
  if (!angles.arms.empty()) simulation->Apply(angles);
  wishes_ = reply.pictures;
  ShowMarkers(reply.draw_markers, simulation);
  PassOn(reply.notes);
  begin_tick_ = simulation->tick();
  num_described_objects_ = simulation->scene().objects.size();
  if (reply.watch) TakeNextFrame(simulation);
}

void BrainDriver::ShowMarkers(const Points& markers, sim::Simulation* simulation) {
  // Without this, each step would add an empty command to the log.
  if (markers.rows() == 0 && !has_markers_) return;
  sim::Markers shown;
  for (Eigen::Index i = 0; i < markers.rows(); ++i) {
    shown.points_in_world.push_back(scene::FromFileUnits(Vector3(markers.row(i).transpose()),
                                                         simulation->scene().meters_per_unit));
  }
  has_markers_ = markers.rows() > 0;
  simulation->Apply(shown);
}

void BrainDriver::PassOn(const std::vector<sim::Note>& notes) const {
  if (!options_.on_note) return;
  for (const sim::Note& note : notes) options_.on_note(note);
}

void BrainDriver::MakeStep(const StepReply& reply, sim::Simulation* simulation) {
  if (reply.draw_markers) ShowMarkers(*reply.draw_markers, simulation);
  if (reply.image_seconds) ChangeImagePeriod(*reply.image_seconds, *simulation);
  if (reply.cameras) wishes_.cameras = *reply.cameras;
  PassOn(reply.notes);
  const bool is_watching = frame_.has_value();
  if (!is_watching) {
    Send(reply.motors.front(), simulation);
    const std::uint64_t tick = simulation->tick();
    chunk_ = Chunk{.motors = reply.motors,
                   .first_tick = tick,
                   .end_tick = tick + static_cast<std::uint64_t>(reply.ticks),
                   .last_tick = tick};
  }
  // While watching, each reply asks for the next frame, and motor values are ignored.
  if (!reply.exit) {
    if (is_watching) TakeNextFrame(simulation);
    return;
  }
  // `exit` also ends a demonstration that has frames left. The final motor values of an acting
  // brain were applied above, but must not remain in effect: nothing would ever change them.
  frame_.reset();
  chunk_.reset();
  status_ = BrainStatus::kExited;
  claim_ = reply.claim;
  StopRobot(simulation);
  Show(robot::FaceExpression::kDone, simulation);
}

/// Applies a brain's motor command. Only changes are applied: velocities stay in effect, so a long
/// motion is one line of the log. Converts gripper velocities from units/s to m/s; joints are in
/// radians on both sides.
void BrainDriver::Send(const Motor& motor, sim::Simulation* simulation) {
  const robot::RobotModel& model = simulation->robot()->model();
  const double unit = simulation->scene().meters_per_unit;
  sim::JointVelocities velocities = sim::StillVelocities(model);
  velocities.head = motor.head_velocity;
  sim::JointAngles angles;
  for (std::size_t k = 0; k < motor.arms.size(); ++k) {
    const ArmMotor& commanded = motor.arms[k];
    const robot::Arm& arm = model.arms[k];
    if (arm.gripper) {
      velocities.grippers[arm.name] = scene::FromFileUnits(commanded.gripper_velocity, unit);
    }
    // Angles take precedence over velocities, as in the original. The joints then hold these
    // angles: velocities still in effect would move them on.
    if (commanded.joints) {
      angles.arms[arm.name] = *commanded.joints;
    } else {
      velocities.arms[arm.name] = commanded.velocities;
    }
  }
  if (angles.arms.empty()) {
    sent_angles_.reset();
  } else {
    if (sent_angles_ != angles) simulation->Apply(angles);
    sent_angles_ = std::move(angles);
  }
  if (sent_velocities_ != velocities) simulation->Apply(velocities);
  sent_velocities_ = std::move(velocities);
}

void BrainDriver::StopRobot(sim::Simulation* simulation) {
  simulation->Apply(sim::StillVelocities(simulation->robot()->model()));
}

void BrainDriver::Show(robot::FaceExpression face_expression, sim::Simulation* simulation) {
  if (simulation->face_expression() != face_expression)
    simulation->Apply(sim::Face{.face_expression = face_expression});
}

void BrainDriver::Fail(BrainError error, sim::Simulation* simulation) {
  // A failed run stays usable: the robot stops, people see its face, and markers of the brain,
  // which could no longer remove them, disappear.
  status_ = BrainStatus::kFailed;
  error_ = std::move(error);
  StopRobot(simulation);
  Show(robot::FaceExpression::kPuzzled, simulation);
  ShowMarkers(Points(0, 3), simulation);
}

}  // namespace smile::brain
