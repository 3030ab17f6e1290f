#include "sim/simulation.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "base/state_hash.h"
#include "sim/command_json.h"

namespace smile::sim {

Simulation::Simulation(std::shared_ptr<const model::Model> model)
    : start_model_(std::move(model)),
      model_(start_model_),
      physics_(physics::WorldConfig{.eases_close_fits = model_->scene().physics_version >= 2}),
      tabletop_(&physics_, model_),
      demonstrator_(&physics_, &tabletop_) {
  if (model_->robot() == nullptr) return;
  robot_ = std::make_unique<world::RobotBody>(&physics_, model_);
  follower_.emplace(robot_.get());
}

Simulation::Simulation(scene::SceneSpec scene, std::optional<RobotPlacement> robot)
    : Simulation(std::make_shared<const model::Model>(std::move(scene), std::move(robot))) {}

scene::VisualState Simulation::visual_state() const {
  return model_->VisualStateOf(tabletop_.scene_state(),
                               robot_ ? robot_->positions() : std::vector<double>(), mood_);
}

namespace {

bool ChangesWorld(const Command& command) {
  return !std::holds_alternative<Undo>(command) && !std::holds_alternative<Redo>(command) &&
         !std::holds_alternative<StartRecording>(command) &&
         !std::holds_alternative<FinishRecording>(command);
}

}  // namespace

std::optional<Refusal> Simulation::Apply(const Command& wanted) {
  const Command command = OnFileGrid(wanted, scene().meters_per_unit);
  std::optional<Refusal> refusal = Refuse(command);
  if (!refusal) refusal = ChangesWorld(command) ? Perform(command) : Carry(command);
  if (refusal) Tell({.kind = EventKind::kCommandRefused, .reason = *refusal});
  return refusal;
}

std::optional<Refusal> Simulation::Refuse(const Command& command) const {
  for (Listener* listener : listeners_) {
    if (auto refusal = listener->Refuse(*this, command)) return refusal;
  }
  if (std::holds_alternative<Undo>(command) && !history_.can_undo()) {
    return "there is nothing to undo";
  }
  if (std::holds_alternative<Redo>(command) && !history_.can_redo()) {
    return "there is nothing to do again";
  }
  const bool is_of_recording = std::holds_alternative<StartRecording>(command) ||
                               std::holds_alternative<FinishRecording>(command);
  if (is_of_recording && recording_control_ == nullptr) return "nobody records this simulation";
  return std::nullopt;
}

std::optional<Refusal> Simulation::Carry(const Command& command) {
  return std::visit([this](const auto& what) { return Carry(what); }, command);
}

std::optional<Refusal> Simulation::Carry(const Undo&) {
  const ActionId from = history_.current().id;
  PutBack(history_.Undo(Save()));
  for (Listener* listener : listeners_) listener->OnMove(*this, from, history_.current().id);
  return std::nullopt;
}

std::optional<Refusal> Simulation::Carry(const Redo&) {
  const ActionId from = history_.current().id;
  PutBack(*history_.Redo());
  for (Listener* listener : listeners_) listener->OnMove(*this, from, history_.current().id);
  return std::nullopt;
}

std::optional<Refusal> Simulation::Carry(const StartRecording& start) {
  return recording_control_->Start(*this, start);
}

std::optional<Refusal> Simulation::Carry(const FinishRecording&) {
  return recording_control_->Finish(*this);
}

std::optional<Refusal> Simulation::Perform(const Command& command) {
  if (const auto* grasp = std::get_if<Grasp>(&command)) ReleaseFor(*grasp);
  std::optional<SimulationState> before_action;
  if (IsAction(command)) before_action = Save();
  const auto held_by_grippers = HeldByGrippers();
  const bool is_of_bonds =
      std::holds_alternative<Fasten>(command) || std::holds_alternative<Loosen>(command);
  const bool changes_mechanisms = is_of_bonds || std::holds_alternative<Trigger>(command) ||
                                  std::holds_alternative<Destroy>(command) ||
                                  std::holds_alternative<Remove>(command) ||
                                  std::holds_alternative<Clear>(command);
  const world::TabletopState before =
      changes_mechanisms ? tabletop_.state() : world::TabletopState();
  const std::optional<HandName> hand = HandOf(command);
  const Before looked = LookBefore(command);
  auto refusal = Carry(command);
  if (refusal) return refusal;
  has_begun_ = true;
  if (before_action) history_.Begin(*std::move(before_action));
  history_.Add({.tick = tick_, .command = command});
  for (Listener* listener : listeners_) listener->OnCommand(*this, command);
  TellOfCommand(command, looked);
  TellOfBonds(before.bonds, is_of_bonds ? hand : std::nullopt);
  TellOfControls(before.controls);
  TellOfGrippers(held_by_grippers);
  return std::nullopt;
}

void Simulation::ReleaseFor(const Grasp& grasp) {
  const demonstrator::GraspPlan plan = demonstrator_.PlanGrasp(grasp.hand, grasp.object);
  if (plan.refusal) return;
  for (HandName hand : plan.to_release) (void)Apply(Release{.hand = hand});
}

std::optional<Refusal> Simulation::Carry(const Plane& plane) {
  demonstrator_.TurnPlane(plane.hand, plane.angle_deg);
  return std::nullopt;
}
std::optional<Refusal> Simulation::Carry(const Attend& attend) {
  return demonstrator_.Attend(attend.hand, attend.properties);
}
std::optional<Refusal> Simulation::Carry(const Grasp& grasp) {
  return demonstrator_.Grasp(grasp.hand, grasp.object, grasp.p_WQ);
}
std::optional<Refusal> Simulation::Carry(const MoveTo& move) {
  return demonstrator_.MoveTo(move.hand, move.p_WH, move.speed);
}
std::optional<Refusal> Simulation::Carry(const Rotate& rotate) {
  return demonstrator_.Rotate(rotate.hand, rotate.angles_deg);
}
std::optional<Refusal> Simulation::Carry(const Release& release) {
  return demonstrator_.Release(release.hand);
}

std::optional<Refusal> Simulation::Carry(const Destroy& destroy) {
  return demonstrator_.Destroy(destroy.hand);
}
std::optional<Refusal> Simulation::Carry(const Point& point) {
  return demonstrator_.PointAt(point.hand, point.part);
}
std::optional<Refusal> Simulation::Carry(const Trigger& trigger) {
  return demonstrator_.Trigger(trigger.hand, trigger.control, trigger.part);
}
std::optional<Refusal> Simulation::Carry(const Fasten& fasten) {
  return demonstrator_.Fasten(fasten.hand, fasten.object, fasten.p_WQ);
}
std::optional<Refusal> Simulation::Carry(const Loosen& loosen) {
  return demonstrator_.Loosen(loosen.hand, loosen.object, loosen.p_WQ);
}

void Simulation::Tick() {
  has_begun_ = true;
  const auto before = HeldByGrippers();
  std::vector<const world::Object*> fallen;
  if (follower_) follower_->BeforeTick(tick_);
  for (int step = 0; step < kStepsPerTick; ++step) {
    demonstrator_.BeforeStep();
    physics_.Step();
    if (robot_) robot_->AfterStep();
    std::ranges::copy(tabletop_.NoticeFallen(), std::back_inserter(fallen));
  }
  ++tick_;
  for (Listener* listener : listeners_) listener->OnTick(*this);
  TellOfGrippers(before);
  for (const world::Object* object : fallen) {
    Tell({.kind = EventKind::kFell, .object = object->id()});
  }
}

bool Simulation::is_still() const {
  constexpr double kSpeed = 0.002, kAngularSpeed = 0.02;
  for (const world::Object& object : tabletop_.objects()) {
    if (!tabletop_.IsPresent(object)) continue;
    const physics::Body& body = physics_.body(object.body);
    if (body.is_carried() || !body.is_awake()) continue;
    if (body.linear_velocity().norm() > kSpeed || body.angular_velocity().norm() > kAngularSpeed) {
      return false;
    }
  }
  return true;
}

std::uint64_t Simulation::state_hash() const {
  StateHash hash;
  hash.Add(tick_);
  hash.Add(physics_.state_hash());
  tabletop_.AddToHash(&hash);
  demonstrator_.AddToHash(&hash);
  if (robot_) {
    for (const world::GripperState& gripper : robot_->state().grippers) {
      hash.Add(gripper.opening_velocity);
      for (physics::JointId weld : gripper.welds) hash.Add(std::uint64_t{weld.value});
    }
    follower_->AddToHash(&hash);
  }
  return hash.value();
}

SimulationState Simulation::Save() const {
  return {.tick = tick_,
          .model = model_,
          .physics = physics_.Save(),
          .tabletop = tabletop_.state(),
          .demonstrator = demonstrator_.state(),
          .robot = robot_ ? robot_->state() : world::RobotBodyState(),
          .follower = follower_ ? follower_->state() : FollowerState(),
          .is_robot_shown = is_robot_shown_,
          .mood = mood_};
}

void Simulation::Restore(const SimulationState& state) {
  PutBack(state);
  has_begun_ = true;
  history_.Restart(tick_);
}

void Simulation::PutBack(const SimulationState& state) {
  physics_.Restore(state.physics);
  tabletop_.Restore(state.tabletop, state.model);
  model_ = state.model;
  demonstrator_.Restore(state.demonstrator);
  if (robot_) {
    robot_->Restore(state.robot);
    follower_->Restore(state.follower);
  }
  is_robot_shown_ = state.is_robot_shown;
  mood_ = state.mood;
  tick_ = state.tick;
}

}  // namespace smile::sim
