#include "task/neighbors.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "task/symmetry.h"

namespace smile::task {
namespace {

/// Greatest distance of the surfaces of neighbors: a fifth of a unit block [m].
constexpr double kNeighborGap = 0.02;
/// Greatest distance of surfaces that touch [m].
constexpr double kContact = 0.005;

const scene::ObjectSpec& Find(const std::vector<scene::ObjectSpec>& objects,
                              const std::string& id) {
  return *std::ranges::find(objects, id, &scene::ObjectSpec::id);
}

/// Returns the smallest turn about the vertical from the goal to where an object is, up to its
/// symmetry [rad]; 0 if none is to be seen, or it does not stand as it should.
double YawError(const scene::ObjectSpec& object, const RigidTransform& X_WGoal,
                const RigidTransform& X_WB) {
  double least = std::numbers::pi;
  const std::vector<double> yaws =
      SymmetryOf(object).YawsBetween(X_WGoal.rotation(), X_WB.rotation());
  for (const double yaw : yaws) {
    const double turn = std::remainder(yaw, 2 * std::numbers::pi);
    if (std::abs(turn) < std::abs(least)) least = turn;
  }
  return yaws.empty() ? 0 : least;
}

/// Returns the ids of the objects that a hand or gripper held at any time.
std::set<std::string> EverHeld(const Episode& episode) {
  std::set<std::string> held;
  for (const ContactEvent& contact : episode.contacts) {
    const sim::EventKind kind = contact.event.kind;
    if (kind == sim::EventKind::kGrasped || kind == sim::EventKind::kGripperHolds) {
      held.insert(contact.event.object);
    }
  }
  return held;
}

/// Returns the objects that touch one of those with these ids, without being one themselves.
std::vector<scene::ObjectSpec> TouchingFromOutside(const std::vector<scene::ObjectSpec>& objects,
                                                   const std::set<std::string>& ids) {
  std::set<std::size_t> touching;
  for (const auto& [a, b] : model::NearPairsOf(objects, kContact)) {
    const bool is_a = ids.contains(objects[a].id()), is_b = ids.contains(objects[b].id());
    if (is_a != is_b) touching.insert(is_a ? b : a);
  }
  std::vector<scene::ObjectSpec> found;
  for (const std::size_t i : touching) found.push_back(objects[i]);
  return found;
}

std::set<std::string> IdsOf(const std::vector<scene::ObjectSpec>& objects) {
  std::set<std::string> ids;
  for (const scene::ObjectSpec& object : objects) ids.insert(object.id());
  return ids;
}

}  // namespace

std::vector<Neighbors> NeighborsOf(const Structure& structure) {
  const auto rank = [&](const std::string& id) {
    const auto placed = std::ranges::find(structure.order, id);
    // What was never placed came first.
    return placed == structure.order.end() ? -1 : placed - structure.order.begin();
  };
  std::vector<Neighbors> neighbors;
  for (const auto& [a, b] : model::NearPairsOf(structure.objects, kNeighborGap)) {
    Neighbors pair{.object = structure.objects[a].id(), .other = structure.objects[b].id()};
    if (rank(pair.object) < rank(pair.other)) std::swap(pair.object, pair.other);
    neighbors.push_back(std::move(pair));
  }
  return neighbors;
}

std::vector<scene::ObjectSpec> BystandersOf(const Structure& structure,
                                            const Episode& demonstration) {
  return TouchingFromOutside(ObjectsAt(demonstration.scene, demonstration.end),
                             IdsOf(structure.objects));
}

std::vector<NeighborError> NeighborErrorsOf(const Structure& structure, const Episode& outcome,
                                            const Match& match, const ObjectPoses& goal) {
  const ObjectPoses poses = PosesAt(outcome.scene, outcome.end);
  struct Deviation {
    Vector3 shift;
    double yaw = 0;
  };
  const auto deviation_of = [&](const std::string& id) -> Deviation {
    const RigidTransform& X_WGoal = goal.at(id);
    const RigidTransform& X_WB = poses.at(match.at(id));
    return {X_WB.translation() - X_WGoal.translation(),
            YawError(Find(structure.objects, id), X_WGoal, X_WB)};
  };
  std::vector<NeighborError> errors;
  for (const Neighbors& pair : structure.neighbors) {
    const Deviation one = deviation_of(pair.object), other = deviation_of(pair.other);
    errors.push_back({.pair = pair,
                      .distance = (one.shift - other.shift).norm(),
                      .angle = std::abs(one.yaw - other.yaw)});
  }
  return errors;
}

std::vector<std::string> IntrudersOf(const Structure& structure, const Episode& outcome,
                                     const Match& match) {
  std::set<std::string> members;
  for (const scene::ObjectSpec& object : structure.objects) members.insert(match.at(object.id()));
  std::set<std::string> brought = EverHeld(outcome);
  // Where objects belong that only effects refer to, the effects say.
  for (const scene::ObjectSpec& other : structure.others) brought.erase(match.at(other.id()));
  std::vector<std::string> intruders;
  for (const scene::ObjectSpec& object :
       TouchingFromOutside(ObjectsAt(outcome.scene, outcome.end), members)) {
    const Appearance appearance = AppearanceOf(object);
    const bool may_touch = std::ranges::any_of(
        structure.bystanders,
        [&](const scene::ObjectSpec& one) { return AreAlike(AppearanceOf(one), appearance); });
    if (brought.contains(object.id()) && !may_touch) intruders.push_back(object.id());
  }
  return intruders;
}

}  // namespace smile::task
