#include "task_episode.h"

#include <stdexcept>

#include "task/imitation_result.h"

namespace smile::python {
namespace {

constexpr std::size_t kPoseNumbers = 7, kVelocityNumbers = 6;
constexpr const char* kPoseNames[] = {"x", "y", "z", "qw", "qx", "qy", "qz"};
constexpr const char* kVelocityNames[] = {"vx", "vy", "vz", "wx", "wy", "wz"};

void AppendPose(const RigidTransform& X, std::vector<double>* out) {
  out->resize(out->size() + kPoseNumbers);
  WritePose(X, out->data() + out->size() - kPoseNumbers);
}

std::shared_ptr<const model::Model> ModelOf(Handle* handle) {
  const Handle::Use use(handle);
  return use->shared_model();
}

}  // namespace

TaskEpisode::TaskEpisode(Handle* handle, std::shared_ptr<const task::GoalSpace> space,
                         ControlOptions options, const std::vector<std::string>& objects)
    : handle_(*handle),
      model_(ModelOf(handle)),
      space_(std::move(space)),
      control_(model_, std::move(options)),
      comparer_(space_.get()) {
  task::RequireSomethingToDo(space_->structure(), model_->scene());
  for (const std::string& id : objects) {
    const auto index = model_->FindObject(id);
    if (!index) throw std::invalid_argument("the scene has no object " + id);
    objects_.push_back(*index);
  }
  observer_ = handle_.Observe();
  const Handle::Use use(&handle_);
  desired_ = space_->Desired(handle_.EpisodeOf(observer_));
}

std::size_t TaskEpisode::num_robot_numbers() const {
  std::size_t count = 0;
  for (const int arm : control_.arms()) {
    count +=
        2 * model_->robot()->arms[static_cast<std::size_t>(arm)].joints.size() + 1 + kPoseNumbers;
  }
  return count;
}

std::vector<std::string> TaskEpisode::observation_names() const {
  std::vector<std::string> names;
  for (const int index : control_.arms()) {
    const robot::Arm& arm = model_->robot()->arms[static_cast<std::size_t>(index)];
    for (const char* what : {".q", ".velocity"}) {
      for (const int joint : arm.joints) {
        names.push_back(arm.name + "." +
                        model_->robot()->links[static_cast<std::size_t>(joint)].joint_name + what);
      }
    }
    names.push_back(arm.name + ".gripper");
    for (const char* name : kPoseNames) names.push_back(arm.name + ".tool." + name);
  }
  for (const model::ObjectIndex object : objects_) {
    const std::string id = model_->id(object) + ".";
    for (const char* name : kPoseNames) names.push_back(id + name);
    for (const char* name : kVelocityNames) names.push_back(id + name);
    names.push_back(id + "present");
  }
  for (const model::ControlIndex i : model_->controls()) {
    names.push_back(model_->control(i).id() + ".state");
  }
  for (const model::HostIndex i : model_->hosts()) {
    names.push_back(model_->host(i).point->id + ".tightness");
  }
  return names;
}

StepResult TaskEpisode::Now() {
  const Handle::Use use(&handle_);
  return Measure(*use);
}

StepResult TaskEpisode::Step(std::span<const double> action) {
  const Handle::Use use(&handle_);
  auto refusal = control_.Perform(action, &*use);
  StepResult result = Measure(*use);
  result.refusal = std::move(refusal);
  return result;
}

StepResult TaskEpisode::Measure(const sim::Simulation& simulation) {
  StepResult result;
  AppendRobot(simulation, &result.observation);
  AppendObjects(simulation, &result.observation);
  AppendMechanisms(simulation, &result.observation);
  result.achieved = space_->Achieved(handle_.EpisodeOf(observer_));
  result.desired = desired_;
  result.score = comparer_.Compare(result.achieved, desired_);
  return result;
}

void TaskEpisode::AppendRobot(const sim::Simulation& simulation, std::vector<double>* out) const {
  const world::RobotBody& robot = *simulation.robot();
  for (const int arm : control_.arms()) {
    for (const std::vector<double>& values : {robot.ArmAngles(arm), robot.ArmVelocities(arm)}) {
      out->insert(out->end(), values.begin(), values.end());
    }
    out->push_back(robot.GripperOpening(arm));
    AppendPose(robot.ToolPose(arm), out);
  }
}

void TaskEpisode::AppendObjects(const sim::Simulation& simulation, std::vector<double>* out) const {
  const world::Tabletop& tabletop = simulation.tabletop();
  for (const model::ObjectIndex index : objects_) {
    const world::Object& object = tabletop.objects()[index];
    if (!tabletop.IsPresent(object)) {
      out->resize(out->size() + kPoseNumbers + kVelocityNumbers + 1, 0);
      continue;
    }
    const physics::Body& body = simulation.physics().body(object.body);
    AppendPose(body.pose_in_world(), out);
    for (const Vector3& v : {Vector3(body.linear_velocity()), Vector3(body.angular_velocity())}) {
      out->insert(out->end(), v.begin(), v.end());
    }
    out->push_back(1);
  }
}

void TaskEpisode::AppendMechanisms(const sim::Simulation& simulation,
                                   std::vector<double>* out) const {
  const world::Tabletop& tabletop = simulation.tabletop();
  for (const model::ControlIndex i : model_->controls()) {
    out->push_back(tabletop.controls().states()[i].state);
  }
  for (const model::HostIndex i : model_->hosts()) {
    out->push_back(tabletop.bonds().states()[i].tightness);
  }
}

}  // namespace smile::python
