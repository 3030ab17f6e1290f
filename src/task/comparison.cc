#include "task/comparison.h"

#include <algorithm>
#include <set>

#include "task/mirror.h"
#include "task/neighbors.h"
#include "task/placing.h"

namespace smile::task {
namespace {

const scene::ObjectSpec& ObjectIn(const scene::SceneSpec& scene, const std::string& id) {
  return *std::ranges::find(scene.objects, id, &scene::ObjectSpec::id);
}

/// Returns the ids of the demonstration for ids of the scene; objects without a counterpart are
/// left out.
std::vector<std::string> InDemoIds(const std::vector<std::string>& scene_ids, const Match& match) {
  std::vector<std::string> ids;
  for (const std::string& scene_id : scene_ids) {
    const auto part =
        std::ranges::find_if(match, [&](const auto& pair) { return pair.second == scene_id; });
    if (part != match.end()) ids.push_back(part->first);
  }
  return ids;
}

/// Returns the order of placements in terms of the demonstration. Only objects of the structure
/// count; objects that ended within tolerance without a placement did not need one.
Order CompareOrder(const Structure& structure, const Episode& outcome,
                   const StructureComparison& comparison) {
  std::vector<std::string> done = InDemoIds(PlacementsOf(outcome), comparison.match);
  std::erase_if(done, [&](const std::string& id) { return !comparison.errors.contains(id); });
  std::set<std::string> in_place;
  for (const auto& [id, error] : comparison.errors) {
    if (error.is_within()) in_place.insert(id);
  }
  return OrderOf(structure.order, std::move(done), in_place);
}

/// True when the effect puts an object into a container, and the object is still held there.
bool IsPutInsideStillHeld(const Effect& effect, const std::set<std::string>& held,
                          const Match& match) {
  const auto* container = std::get_if<ContainerEffect>(&effect);
  return container != nullptr && container->is_inside && held.contains(match.at(container->object));
}

/// Chooses which of equal objects were to be removed: those that are not on the table at the end.
void MatchRemoved(const Structure& structure, const Episode& outcome, Match* match) {
  std::set<std::string> taken;
  for (const scene::ObjectSpec& other : structure.others) taken.insert(match->at(other.id()));
  for (const Effect& effect : structure.effects) {
    const auto* gone = std::get_if<DestroyedEffect>(&effect);
    if (gone == nullptr || IsRemoved(outcome, match->at(gone->object))) continue;
    const Appearance appearance =
        AppearanceOf(*std::ranges::find(structure.others, gone->object, &scene::ObjectSpec::id));
    for (const scene::ObjectSpec& object : outcome.scene.objects) {
      if (taken.contains(object.id()) || !IsRemoved(outcome, object.id()) ||
          !AreAlike(appearance, AppearanceOf(object), structure.AttendedOf(gone->object))) {
        continue;
      }
      match->at(gone->object) = object.id();
      taken.insert(object.id());
      break;
    }
  }
}

/// True if the object of an orientation is turned as it should be, wherever it is.
bool IsOriented(const OrientedEffect& oriented, const StructureComparison& comparison) {
  const auto error = comparison.errors.find(oriented.object);
  return error == comparison.errors.end() || error->second.angle <= kAngleTolerance;
}

/// True if an effect that is achieved by itself does not count because of its object's pose: held
/// in a container, or not turned.
bool IsRefuted(const Effect& effect, const std::set<std::string>& held,
               const StructureComparison& comparison) {
  const auto* oriented = std::get_if<OrientedEffect>(&effect);
  return IsPutInsideStillHeld(effect, held, comparison.match) ||
         (oriented != nullptr && !IsOriented(*oriented, comparison));
}

}  // namespace

ObjectError StructureComparison::mean_error() const {
  ObjectError mean;
  const auto count = static_cast<double>(errors.size());
  for (const auto& [id, error] : errors) {
    mean.distance += error.distance / count;
    mean.angle += error.angle / count;
  }
  return mean;
}

StructureComparison ComparePoses(const Structure& structure, const Episode& outcome, Match match,
                                 const std::set<std::string>& held) {
  const ObjectPoses poses = PosesAt(outcome.scene, outcome.end);
  StructureComparison comparison{.match = std::move(match),
                                 .goal = {},
                                 .errors = {},
                                 .neighbors = {},
                                 .intruders = {},
                                 .turn = {},
                                 .order = {},
                                 .broken_rules = {},
                                 .achieved = {}};
  // Motion and match are optimized together; the match by appearance alone is the start, and stays
  // for objects that only effects refer to.
  const std::vector<Structure> parts = PartsOf(structure);
  for (const Structure& part : parts) {
    const Placing placing = FindPlacing(part, outcome, comparison.match);
    // Several parts may each be turned otherwise.
    const bool has_turn = parts.size() == 1 && !part.objects.empty() && part.is_free();
    if (has_turn) comparison.turn = placing.turn;
    for (const scene::ObjectSpec& object : part.objects) {
      comparison.match[object.id()] = placing.match.at(object.id());
      comparison.goal[object.id()] = placing.motion * object.pose_in_world();
    }
  }
  for (const scene::ObjectSpec& object : structure.objects) {
    const std::string& id = object.id();
    const std::string& counterpart = comparison.match.at(id);
    comparison.errors[id] = ErrorOf(object, comparison.goal[id],
                                    ObjectIn(outcome.scene, counterpart), poses.at(counterpart));
    comparison.errors[id].is_held = held.contains(counterpart);
  }
  comparison.neighbors = NeighborErrorsOf(structure, outcome, comparison.match, comparison.goal);
  for (const NeighborError& error : comparison.neighbors) {
    // Of two objects in their places, the one that was to be placed later must fit the other.
    if (!error.is_within()) comparison.errors[error.pair.object].is_apart = true;
  }
  return comparison;
}

double ScoreOf(const std::map<std::string, ObjectError>& errors, const std::vector<bool>& achieved,
               std::size_t num_faults) {
  const auto num_right =
      std::ranges::count_if(errors, [](const auto& error) { return error.second.is_within(); }) +
      std::ranges::count(achieved, true);
  return static_cast<double>(num_right) /
         static_cast<double>(errors.size() + achieved.size() + num_faults);
}

StructureComparison CompareWith(const Structure& structure, const Episode& outcome) {
  Match match = MatchObjects(structure, outcome.scene);
  MatchRemoved(structure, outcome, &match);
  const std::set<std::string> held = HeldInTheEnd(outcome);
  StructureComparison comparison = ComparePoses(structure, outcome, std::move(match), held);
  comparison.intruders = IntrudersOf(structure, outcome, comparison.match);
  // Order and effects refer to the match that was found.
  comparison.order = CompareOrder(structure, outcome, comparison);
  comparison.broken_rules = RuleBreaksOf(structure, outcome, comparison.match, comparison.order);
  const auto counterpart = [&](const std::string& id) { return comparison.match.at(id); };
  comparison.achieved = AreAchieved(structure.effects, outcome, counterpart, kTolerance);
  for (std::size_t i = 0; i < structure.effects.size(); ++i) {
    if (IsRefuted(structure.effects[i], held, comparison)) comparison.achieved[i] = false;
  }
  comparison.score = ScoreOf(comparison.errors, comparison.achieved, comparison.num_faults());
  if (comparison.turn && comparison.is_achieved()) {
    comparison.is_mirrored = IsMirrored(structure, outcome, comparison.match, *comparison.turn);
  }
  return comparison;
}

}  // namespace smile::task
