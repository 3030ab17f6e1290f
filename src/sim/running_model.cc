#include "sim/running_model.h"

#include <algorithm>
#include <iterator>
#include <string>
#include <utility>

#include "base/state_hash.h"
#include "sim/displacing.h"
#include "sim/spawning.h"
#include "sim/tick.h"

// The state of a simulation between commands and ticks: physics, objects, hands, robot. Each
// command is executed completely or refused without any change; which kinds the robot carries out
// is decided at compile time, by the overloads of SimulatedRobot::Execute().

namespace smile::sim {

using texts::Say;
namespace {

/// Returns the rules of a version of the physics. Rules that came later apply only to scenes of
/// their version: recordings keep the version with which they were made, and replay exactly.
physics::WorldConfig RulesOf(int physics_version) {
  return {.eases_close_fits = physics_version >= 2,
          .has_close_bounds = physics_version >= 3,
          .sums_hashes = physics_version >= 3,
          .has_firm_contacts = physics_version >= 5,
          .moves_free_trees = physics_version >= 5,
          .finds_loads = physics_version >= 6};
}

}  // namespace

RunningModel::RunningModel(std::shared_ptr<const model::Model> model)
    : start_model_(std::move(model)),
      model_(start_model_),
      physics_(RulesOf(model_->scene().physics_version)),
      tabletop_(&physics_, model_),
      demonstrator_(&physics_, &tabletop_) {
  if (model_->robot() != nullptr) robot_.emplace(&physics_, model_);
}

std::optional<Refusal> RunningModel::Execute(const Command& command) {
  return std::visit(
      [this]<class What>(const What& what) -> std::optional<Refusal> {
        // Commands are dispatched by overload: to the robot, to the robot with the tick, or to
        // this.
        constexpr bool kIsForRobot = requires(SimulatedRobot robot) { robot.Execute(what); };
        constexpr bool kMovesRobot = requires(SimulatedRobot robot) { robot.Execute(what, 0); };
        if constexpr (kIsForRobot || kMovesRobot) {
          if (!robot_) return Say("robot.isMissing");
        }
        if constexpr (kIsForRobot) return robot_->Execute(what);
        if constexpr (kMovesRobot) return robot_->Execute(what, tick_);
        if constexpr (requires { this->ExecuteOne(what); }) return ExecuteOne(what);
        return std::nullopt;
      },
      command);
}

std::optional<Refusal> RunningModel::ExecuteOne(const Grasp& grasp) {
  return demonstrator_.Grasp(grasp.hand, grasp.object, grasp.p_WQ);
}
std::optional<Refusal> RunningModel::ExecuteOne(const MoveTo& move) {
  return demonstrator_.MoveTo(move.hand, move.p_WH, move.speed);
}
std::optional<Refusal> RunningModel::ExecuteOne(const Plane& plane) {
  demonstrator_.TurnPlane(plane.hand, plane.angle_deg);
  return std::nullopt;
}
std::optional<Refusal> RunningModel::ExecuteOne(const Attend& attend) {
  return demonstrator_.Attend(attend.hand, attend.properties);
}
std::optional<Refusal> RunningModel::ExecuteOne(const Rotate& rotate) {
  return demonstrator_.Rotate(rotate.hand, rotate.angles_deg);
}
std::optional<Refusal> RunningModel::ExecuteOne(const Release& release) {
  return demonstrator_.Release(release.hand);
}
std::optional<Refusal> RunningModel::ExecuteOne(const Destroy& destroy) {
  return demonstrator_.Destroy(destroy.hand);
}
std::optional<Refusal> RunningModel::ExecuteOne(const Point& point) {
  return demonstrator_.PointAt(point.hand, point.part);
}
std::optional<Refusal> RunningModel::ExecuteOne(const Trigger& trigger) {
  return demonstrator_.Trigger(trigger.hand, trigger.control, trigger.part);
}
std::optional<Refusal> RunningModel::ExecuteOne(const Fasten& fasten) {
  return demonstrator_.Fasten(fasten.hand, fasten.object, fasten.p_WQ);
}
std::optional<Refusal> RunningModel::ExecuteOne(const Loosen& loosen) {
  return demonstrator_.Loosen(loosen.hand, loosen.object, loosen.p_WQ);
}

std::optional<Refusal> RunningModel::ExecuteOne(const Use& use) {
  return demonstrator_.Use(use.hand, use.loosens, &last_use_);
}

std::optional<Refusal> RunningModel::ExecuteOne(const Markers& markers) {
  if (markers.points_in_world.size() <= kMaxMarkers) return std::nullopt;
  return "there are more than " + std::to_string(kMaxMarkers) + " markers";
}

std::optional<Refusal> RunningModel::ExecuteOne(const Spawn& spawn) {
  Refusal refusal;
  // All checks come before the first change.
  auto grown = GrownModel(*model_, spawn, &refusal);
  if (grown == nullptr) return refusal;
  if (auto overlap = RefuseOverlap(*grown, tabletop_, physics_)) return overlap;
  model_ = std::move(grown);
  tabletop_.Grow(model_);
  return std::nullopt;
}

std::optional<Refusal> RunningModel::ExecuteOne(const Remove& remove) {
  const world::Object* object = tabletop_.Find(remove.object);
  // RefuseToReach() distinguishes the reasons, such as an unknown id.
  if (object == nullptr) return tabletop_.RefuseToReach(remove.object);
  return demonstrator_.Remove(*object);
}

std::optional<Refusal> RunningModel::ExecuteOne(const Displace& displace) {
  return DisplaceObjects(displace, tabletop_, &physics_);
}

std::optional<Refusal> RunningModel::ExecuteOne(const Clear&) {
  // Held objects and everything connected with them stay.
  // Two passes: which objects stay is known only when all held ones have been visited.
  std::vector<physics::BodyId> kept;
  std::vector<const world::Object*> taken;
  for (const world::Object& object : tabletop_.objects()) {
    if (!tabletop_.IsPresent(object) || !physics_.body(object.body).is_carried()) continue;
    // An assembly is what joints connect: a held object must not lose what is fastened to it.
    for (physics::BodyId member : physics_.Assembly(object.body)) kept.push_back(member);
  }
  for (const world::Object& object : tabletop_.objects()) {
    const bool is_kept = std::ranges::find(kept, object.body) != kept.end();
    if (tabletop_.IsPresent(object) && !is_kept) taken.push_back(&object);
  }
  // Refused, since an action without an effect could be undone without an effect.
  if (taken.empty()) return Say("objects.nothingToClear");
  // Nothing is refused here: held objects are not among them.
  for (const world::Object* object : taken) {
    if (auto refusal = demonstrator_.Remove(*object)) return refusal;
  }
  return std::nullopt;
}

TickReport RunningModel::Tick() {
  TickReport report;
  if (robot_) robot_->BeforeTick(tick_);
  for (int step = 0; step < kStepsPerTick; ++step) {
    // Hands act in each physics step, the robot's targets change once per tick.
    demonstrator_.BeforeStep();
    physics_.Step();
    if (robot_) robot_->AfterStep();
    // In each step, as an object that bounces may touch the floor for less than a tick.
    std::ranges::copy(tabletop_.NoticeFallen(), std::back_inserter(report.fallen));
    tabletop_.NoticePushes();
  }
  report.presses = tabletop_.PressControls(SecondsOf(1));
  if (tabletop_.has_tools()) report.uses = tabletop_.UseTools(Holders(), &report.refusals);
  ++tick_;
  return report;
}

std::vector<world::Holder> RunningModel::Holders() const {
  std::vector<world::Holder> holders;
  for (const demonstrator::HandName name : demonstrator::kHandNames) {
    const demonstrator::Hand& hand = demonstrator_.hand(name);
    if (hand.is_holding()) holders.push_back({.body = hand.held});
  }
  for (int arm = 0; robot_ && arm < robot_->body().num_arms(); ++arm) {
    for (const physics::BodyId body : robot_->body().HeldBodies(arm)) {
      const bool is_closing = robot_->body().state().grippers[arm].opening_velocity < 0;
      holders.push_back({.body = body, .arm = arm, .is_squeezing = is_closing});
    }
  }
  return holders;
}

std::vector<world::ToolUse> RunningModel::PossibleUses() const {
  if (!tabletop_.has_tools()) return {};
  return tabletop_.PossibleUses(Holders());
}

std::vector<std::vector<physics::BodyId>> RunningModel::HeldByGrippers() const {
  std::vector<std::vector<physics::BodyId>> held;
  for (int arm = 0; robot_ && arm < robot_->body().num_arms(); ++arm) {
    held.push_back(robot_->body().HeldBodies(arm));
  }
  return held;
}

bool RunningModel::is_still() const {
  // [m/s, rad/s]
  constexpr double kSpeed = 0.002, kAngularSpeed = 0.02;
  for (const physics::BodyId id : physics_.awake_bodies()) {
    const physics::Body& body = physics_.body(id);
    // Held objects may move: the question is whether the rest has come to rest.
    if (body.is_carried()) continue;
    if (body.linear_velocity().norm() > kSpeed || body.angular_velocity().norm() > kAngularSpeed) {
      return false;
    }
  }
  return true;
}

std::optional<model::Support> RunningModel::SupportOf(model::ObjectIndex index) const {
  std::vector<std::optional<RigidTransform>> X_WBs;
  for (const world::Object& object : tabletop_.objects()) {
    X_WBs.push_back(tabletop_.PoseOf(object));
  }
  return model::SupportOf(model_->scene(), X_WBs, index);
}

std::uint64_t RunningModel::state_hash() const {
  StateHash hash;
  // Appearance (robot shown, face) is not hashed: it has no effect on the future.
  hash.Add(tick_);
  hash.Add(physics_.state_hash());
  tabletop_.AddToHash(&hash);
  demonstrator_.AddToHash(&hash);
  if (robot_) robot_->AddToHash(&hash);
  return hash.value();
}

SimulationState RunningModel::Save() const {
  return {.tick = tick_,
          .start_model = start_model_,
          .model = model_,
          .physics = physics_.Save(),
          .tabletop = tabletop_.state(),
          .demonstrator = demonstrator_.state(),
          .robot = robot_ ? robot_->Save() : SimulatedRobotState()};
}

void RunningModel::Restore(const SimulationState& state) {
  // Physics first: the tabletop refers to its bodies.
  physics_.Restore(state.physics);
  tabletop_.Restore(state.tabletop, state.model);
  model_ = state.model;
  demonstrator_.Restore(state.demonstrator);
  if (robot_) robot_->Restore(state.robot);
  tick_ = state.tick;
}

}  // namespace smile::sim
