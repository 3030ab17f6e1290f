#include "robot_brain.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "experiment/brain_setup.h"
#include "scene/units.h"
#include "thread_renderer.h"

namespace smile::python {
namespace {

/// Lines that wait to be printed; a flood of them is cut.
constexpr std::size_t kMaxLines = 1000;
/// What a brain reads in place of the id of a held object.
constexpr const char* kUnknownObject = "unknown";

/// Returns the table and the robot without objects: the real ones are elsewhere, and nothing here
/// may be pushed or grasped.
std::shared_ptr<const model::Model> WithoutObjects(const model::Model& model) {
  if (model.robot() == nullptr) throw std::invalid_argument("there is no robot, expected one");
  scene::SceneSpec bare = model.scene();
  bare.objects.clear();
  bare.sliders.clear();
  bare.chains.clear();
  return std::make_shared<const model::Model>(model, std::move(bare));
}

std::vector<scene::Solid> TableOf(const scene::TableSpec& table) {
  return {{.shape = scene::Block{{table.x_span, table.y_span, table.thickness}},
           .X_BS = RigidTransform(Vector3(0, 0, -table.thickness / 2))}};
}

brain::BrainError Impossible(brain::BrainError::Phase phase, std::string message) {
  return {.phase = phase, .message = std::move(message)};
}

/// @throws std::invalid_argument if there are not so many numbers, or one is not finite.
void RequireNumbers(const std::string& what, const std::vector<double>& numbers,
                    std::size_t count) {
  if (numbers.size() != count) {
    throw std::invalid_argument(what + " has " + std::to_string(numbers.size()) +
                                " numbers, expected " + std::to_string(count));
  }
  if (!std::ranges::all_of(numbers, [](double number) { return std::isfinite(number); })) {
    throw std::invalid_argument(what + " has a number that is not finite, expected finite ones");
  }
}

}  // namespace

RobotBrain::RobotBrain(const model::Model& model, const std::filesystem::path& brain,
                       const RobotBrainOptions& options)
    : camera_(options.camera),
      demonstration_eye_(model::EyeSpec{}, &RendererOfThread),
      stand_in_(WithoutObjects(model)),
      probe_(robot::MakeArticulationSpec(*model.robot(), model.robot_base_pose()),
             TableOf(model.scene().table)),
      commanded_(sim::StillVelocities(*model.robot())),
      driver_(DriverOptions(brain, options)),
      thread_(brain, ProcessOptions(options.timeout), nullptr) {
  stand_in_.AddListener(this);
}

RobotBrain::~RobotBrain() { thread_.Leave(); }

brain::BrainDriverOptions RobotBrain::DriverOptions(const std::filesystem::path& brain,
                                                    const RobotBrainOptions& options) {
  brain::BrainDriverOptions driver =
      experiment::DriverOptionsFor(brain, options.demonstration, &demonstration_eye_);
  driver.eye = nullptr;
  if (camera_) {
    eye_.size = {.width_px = camera_->description.width_px,
                 .height_px = camera_->description.height_px};
    eye_.look = options.look;
    driver.eye = &eye_;
  }
  driver.on_note = [this](const sim::Note& note) { AddLine(note.word + ": " + note.text); };
  return driver;
}

brain::BrainOptions RobotBrain::ProcessOptions(double timeout) {
  brain::BrainOptions options = brain::WithTimeout(timeout);
  options.on_output = [this](std::string_view line) { AddLine(line); };
  return options;
}

void RobotBrain::Sense(std::vector<MeasuredArm> arms) {
  const world::RobotBody& robot = *stand_in_.robot();
  if (arms.size() != robot.model().arms.size()) {
    throw std::invalid_argument(std::to_string(arms.size()) + " arms, expected " +
                                std::to_string(robot.model().arms.size()));
  }
  sim::JointAngles joints;
  sim::JointVelocities openings;
  for (std::size_t k = 0; k < arms.size(); ++k) {
    const robot::Arm& arm = robot.model().arms[k];
    RequireNumbers(arm.name + ": positions", arms[k].joints, arm.joints.size());
    RequireNumbers(arm.name + ": velocities", arms[k].velocities, arm.joints.size());
    joints.arms[arm.name] = arms[k].joints;
    if (!arms[k].opening) continue;
    RequireNumbers(arm.name + ": opening", {*arms[k].opening}, 1);
    // The fingers follow within a tick: named points of the robot lie on them.
    openings.grippers[arm.name] =
        (*arms[k].opening - robot.GripperOpening(static_cast<int>(k))) * sim::kTicksPerSecond;
  }
  is_ours_ = true;
  stand_in_.Apply(joints);
  stand_in_.Apply(openings);
  is_ours_ = false;
  measured_ = std::move(arms);
}

bool RobotBrain::Ask() {
  std::optional<brain::BrainQuestion> question = driver_.NextQuestion(&stand_in_);
  if (!question) return false;
  if (auto* aux = std::get_if<brain::Aux>(&*question)) Correct(aux);
  if (auto* sensor = std::get_if<brain::Sensor>(&*question)) Correct(sensor);
  thread_.Submit(std::move(*question));
  return true;
}

bool RobotBrain::Take(double seconds) {
  std::optional<brain::BrainAnswer> answer =
      thread_.WaitForAnswer(std::chrono::nanoseconds(std::llround(1e9 * seconds)));
  if (!answer) return false;
  std::optional<brain::BrainError> impossible;
  if (const auto* init = std::get_if<brain::InitReply>(&*answer)) {
    impossible = WhyImpossible(*init);
    initial_joints_ = init->init_joints;
  }
  if (const auto* step = std::get_if<brain::StepReply>(&*answer)) impossible = WhyImpossible(*step);
  if (impossible) answer = std::move(*impossible);
  driver_.Take(std::move(*answer), &stand_in_);
  return true;
}

void RobotBrain::Correct(brain::Aux* aux) const {
  if (camera_) aux->camera = camera_->description;
  // Those of the robot and the scene are not connected: a brain that asks for one is refused.
  aux->camera_names.clear();
}

void RobotBrain::Correct(brain::Sensor* sensor) const {
  const double unit = stand_in_.scene().meters_per_unit;
  for (std::size_t k = 0; k < measured_.size(); ++k) {
    brain::ArmSensor& arm = sensor->arms[k];
    arm.joints = measured_[k].joints;
    arm.velocities = measured_[k].velocities;
    if (measured_[k].opening) arm.gripper = scene::ToFileUnits(*measured_[k].opening, unit);
    arm.held_object = measured_[k].holds ? kUnknownObject : "";
  }
  if (sensor->demo_cue) return;  // with a picture of the demonstration
  for (brain::CameraPicture& picture : sensor->pictures) {
    picture.camera = camera_->description;
  }
}

std::optional<brain::BrainError> RobotBrain::WhyImpossible(const brain::InitReply& reply) const {
  const sim::Channels& channels = reply.pictures.channels;
  if (!camera_) return std::nullopt;
  if (channels.depth && !camera_->has_depth) {
    return Impossible(brain::BrainError::Phase::kInit,
                      "aux.channels asks for depth, but the camera has none");
  }
  if (channels.id) {
    return Impossible(brain::BrainError::Phase::kInit,
                      "aux.channels asks for segmentation, which no real camera has");
  }
  return std::nullopt;
}

std::optional<brain::BrainError> RobotBrain::WhyImpossible(const brain::StepReply& reply) const {
  for (const brain::Motor& motor : reply.motors) {
    for (std::size_t k = 0; k < motor.arms.size(); ++k) {
      if (!motor.arms[k].joints) continue;
      return Impossible(brain::BrainError::Phase::kCallback,
                        "motor puts the " + stand_in_.robot()->model().arms[k].name +
                            " arm at joint angles at once, which no real arm can: expected "
                            "velocities");
    }
    if (motor.head_velocity.value_or(0) != 0) {
      return Impossible(brain::BrainError::Phase::kCallback,
                        "motor.headVelocity moves the head, which is not connected: expected 0");
    }
  }
  return std::nullopt;
}

std::optional<std::vector<double>> RobotBrain::InitialJoints(int arm) const {
  const auto index = static_cast<std::size_t>(arm);
  return index < initial_joints_.size() ? initial_joints_[index] : std::nullopt;
}

std::vector<double> RobotBrain::Velocities(int arm) const {
  return commanded_.arms.at(stand_in_.robot()->model().arms.at(static_cast<std::size_t>(arm)).name);
}

double RobotBrain::OpeningRate(int arm) const {
  const auto found = commanded_.grippers.find(
      stand_in_.robot()->model().arms.at(static_cast<std::size_t>(arm)).name);
  return found == commanded_.grippers.end() ? 0 : found->second;
}

std::optional<std::string> RobotBrain::Touch(const std::vector<std::vector<double>>& joints) {
  const robot::RobotModel& model = stand_in_.robot()->model();
  std::vector<double> q = stand_in_.robot()->positions();
  for (std::size_t k = 0; k < model.arms.size(); ++k) {
    const std::vector<int>& columns = model.arms[k].joints;
    RequireNumbers(model.arms[k].name + ": positions", joints.at(k), columns.size());
    for (std::size_t i = 0; i < columns.size(); ++i) q[columns[i]] = joints[k][i];
  }
  const auto overlap = probe_.FirstOverlap(q);
  if (!overlap) return std::nullopt;
  const auto name = [&](int link) -> std::string {
    if (link == motion::kEnvironment) return "the table";
    return link < 0 ? "its base" : model.links[link].name;
  };
  return name(overlap->link) + " would touch " + name(overlap->other);
}

std::vector<std::string> RobotBrain::TakeLines() {
  const std::lock_guard lock(mutex_);
  return std::exchange(lines_, {});
}

void RobotBrain::AddLine(std::string_view line) {
  const std::lock_guard lock(mutex_);
  if (lines_.size() < kMaxLines) lines_.emplace_back(line);
}

void RobotBrain::OnCommand(const sim::Simulation& /*simulation*/, const sim::Command& command) {
  const auto* velocities = std::get_if<sim::JointVelocities>(&command);
  if (velocities == nullptr || is_ours_) return;
  for (const auto& [name, numbers] : velocities->arms) commanded_.arms[name] = numbers;
  for (const auto& [name, rate] : velocities->grippers) commanded_.grippers[name] = rate;
}

}  // namespace smile::python
