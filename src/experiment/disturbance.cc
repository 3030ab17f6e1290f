#include "experiment/disturbance.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "experiment/internal_chain_objects.h"
#include "experiment/internal_draw.h"
#include "math/angles.h"
#include "model/relations.h"
#include "scene/units.h"

namespace smile::experiment {
namespace {

constexpr sim::HandName kPushHand = sim::HandName::kLeft;
constexpr double kPushSpeed = 0.3;     ///< of the hand [m/s]
constexpr double kMaxPushSeconds = 2;  ///< of the motion, should the object be stuck
/// Ticks between two looks for a loose object.
constexpr std::uint64_t kLookTicks = 15;
constexpr double kMostDisturbedSeconds = 86400, kMostDisturbedUnits = 1e6;

Json PositionJson(const Vector3& p, const sim::Simulation& simulation) {
  const Vector3 units = scene::ToFileUnits(p, simulation.scene().meters_per_unit);
  return {units.x(), units.y(), units.z()};
}

/// Returns the objects that are part of chains or sliders.
std::set<std::size_t> JoinedObjects(const scene::SceneSpec& scene) {
  std::set<std::size_t> joined = internal::ChainObjects(scene);
  for (const scene::SliderSpec& slider : scene.sliders) {
    joined.insert({slider.first_object, slider.first_object + 1});
  }
  return joined;
}

bool IsHeld(const world::Object& object, const sim::Simulation& simulation) {
  for (const sim::HandName name : {sim::HandName::kLeft, sim::HandName::kRight}) {
    if (simulation.demonstrator().hand(name).held == object.body) return true;
  }
  const world::RobotBody* robot = simulation.robot();
  if (robot == nullptr) return false;
  for (int arm = 0; arm < robot->num_arms(); ++arm) {
    const auto held = robot->HeldBodies(arm);
    if (std::ranges::find(held, object.body) != held.end()) return true;
  }
  // Grasps by friction attach nothing.
  return robot->IsTouching({object.body});
}

/// Returns the loose objects, in the order of the scene.
std::vector<const world::Object*> LooseObjects(const sim::Simulation& simulation) {
  const world::Tabletop& tabletop = simulation.tabletop();
  const std::set<std::size_t> joined = JoinedObjects(simulation.scene());
  std::set<std::string> supports;
  std::vector<const world::Object*> standing, loose;
  for (const world::Object& object : tabletop.objects()) {
    if (!tabletop.IsPresent(object)) continue;
    const auto support = simulation.SupportOf(object.index);
    if (support && support->is_near()) supports.insert(support->object);
    const bool stands = support && support->object.empty() && support->is_near();
    const bool is_free = !simulation.model().object(object.index).is_static() &&
                         !joined.contains(object.index) && !tabletop.RefuseToReach(object);
    if (stands && is_free && !IsHeld(object, simulation)) standing.push_back(&object);
  }
  for (const world::Object* object : standing) {
    if (!supports.contains(object->id())) loose.push_back(object);
  }
  return loose;
}

}  // namespace

std::optional<Disturbance> DrawDisturbance(const DisturbanceChoices& choices, std::uint64_t seed) {
  if (internal::Draw({0, 1}, "disturbed", seed) >= choices.fraction) return std::nullopt;
  // Rounding must not lead to 1.
  const double choice = internal::Draw({0, 1}, "disturbed object", seed);
  return Disturbance{.seconds = internal::Draw(choices.seconds, "disturbed after", seed),
                     .choice = std::min(choice, 0.999999),
                     .direction_deg = internal::Draw({0, 360}, "disturbed towards", seed),
                     .distance = internal::Draw(choices.distance, "disturbed by", seed)};
}

Json ToJson(const DisturbanceChoices& choices) {
  return {{"fraction", choices.fraction},
          {"seconds", {choices.seconds.low, choices.seconds.high}},
          {"distance", {choices.distance.low, choices.distance.high}}};
}

Json ToJson(const Disturbance& disturbance) {
  return {{"seconds", disturbance.seconds},
          {"choice", disturbance.choice},
          {"direction_deg", disturbance.direction_deg},
          {"distance", disturbance.distance}};
}

Disturbance DisturbanceIn(const JsonNode& node) {
  Disturbance disturbance;
  disturbance.seconds = node.Member("seconds").Number(0, kMostDisturbedSeconds);
  disturbance.choice = node.Member("choice").Number(0, 0.999999);
  disturbance.direction_deg = node.Member("direction_deg").Number(-360, 360);
  disturbance.distance = node.Member("distance").Number(0, kMostDisturbedUnits);
  return disturbance;
}

void Disturber::Advance(std::uint64_t acting_ticks, sim::Simulation* simulation) {
  const auto start =
      static_cast<std::uint64_t>(std::llround(disturbance_.seconds * sim::kTicksPerSecond));
  if (phase_ == Phase::kWaiting && acting_ticks >= start &&
      (acting_ticks - start) % kLookTicks == 0 && TakeObject(simulation)) {
    phase_ = Phase::kMoving;
  } else if (phase_ == Phase::kMoving && (simulation->demonstrator().has_arrived(kPushHand) ||
                                          simulation->tick() >= last_tick_)) {
    simulation->Apply(sim::Release{.hand = kPushHand});
    phase_ = Phase::kOver;
  }
}

bool Disturber::TakeObject(sim::Simulation* simulation) {
  const std::vector<const world::Object*> loose = LooseObjects(*simulation);
  if (loose.empty()) return false;
  const world::Object& object =
      *loose[static_cast<std::size_t>(disturbance_.choice * static_cast<double>(loose.size()))];
  const Vector3 from = simulation->tabletop().PoseOf(object)->translation();
  if (simulation->Apply(sim::Grasp{.hand = kPushHand, .object = object.id(), .p_WQ = {}}))
    return false;
  const double angle = DegreesToRadians(disturbance_.direction_deg);
  const double unit = simulation->scene().meters_per_unit;
  // Computed in units, in which the log has it: a replay moves to the same bits.
  const Vector3 to =
      scene::FromFileUnits(scene::ToFileUnits(from, unit) +
                               disturbance_.distance * Vector3(std::cos(angle), std::sin(angle), 0),
                           unit);
  simulation->Apply(sim::MoveTo{.hand = kPushHand, .p_WH = to, .speed = kPushSpeed});
  last_tick_ = simulation->tick() +
               static_cast<std::uint64_t>(std::llround(kMaxPushSeconds * sim::kTicksPerSecond));
  done_ = {{"tick", simulation->tick()},
           {"object", object.id()},
           {"from", PositionJson(from, *simulation)},
           {"to", PositionJson(to, *simulation)}};
  return true;
}

}  // namespace smile::experiment
