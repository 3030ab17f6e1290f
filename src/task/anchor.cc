#include "task/anchor.h"

#include <algorithm>
#include <limits>

#include "task/comparison.h"

namespace smile::task {
namespace {

/// Returns true if the objects of the structure were where they are, relative to each other, when
/// the demonstration began.
bool StoodFromTheStart(const Structure& structure, const Episode& demonstration) {
  const std::vector<scene::ObjectSpec> present =
      ObjectsAt(demonstration.scene, demonstration.begin);
  for (const scene::ObjectSpec& object : structure.objects) {
    if (std::ranges::find(present, object.id(), &scene::ObjectSpec::id) == present.end()) {
      return false;
    }
  }
  const StructureComparison comparison = CompareWith(structure, AtBegin(demonstration));
  return std::ranges::all_of(comparison.errors,
                             [](const auto& error) { return error.second.is_within(); });
}

/// Returns the object outside the structure that is nearest to a placed one, of those that nothing
/// moved; nullptr if there is none.
const scene::ObjectSpec* NearestThatStayed(const Structure& structure,
                                           const std::vector<scene::ObjectSpec>& at_begin,
                                           const std::vector<scene::ObjectSpec>& at_end) {
  const scene::ObjectSpec* nearest = nullptr;
  double least = std::numeric_limits<double>::infinity();
  for (const scene::ObjectSpec& object : at_end) {
    const auto is_it = [&](const scene::ObjectSpec& other) { return other.id() == object.id(); };
    const auto before = std::ranges::find_if(at_begin, is_it);
    if (before == at_begin.end() || std::ranges::any_of(structure.objects, is_it) ||
        HasMoved(before->pose_in_world(), object.pose_in_world())) {
      continue;
    }
    for (const scene::ObjectSpec& member : structure.objects) {
      const double distance =
          (member.pose_in_world().translation() - object.pose_in_world().translation()).norm();
      if (distance < least) {
        least = distance;
        nearest = &object;
      }
    }
  }
  return nearest;
}

}  // namespace

void FindAnchor(const Episode& demonstration, Structure* structure) {
  const bool has_placed = !structure->order.empty() && !structure->objects.empty();
  if (!has_placed || structure->is_fixed() || !StoodFromTheStart(*structure, demonstration)) return;
  const std::vector<scene::ObjectSpec> at_end = ObjectsAt(demonstration.scene, demonstration.end);
  const scene::ObjectSpec* landmark =
      NearestThatStayed(*structure, ObjectsAt(demonstration.scene, demonstration.begin), at_end);
  if (landmark == nullptr) {
    structure->anchor = Anchor::kTable;
    return;
  }
  structure->anchor = Anchor::kLandmark;
  structure->landmark = landmark->id();
  std::erase_if(structure->others, [&](const auto& other) { return other.id() == landmark->id(); });
  // In scene order, as all objects are.
  const auto rank = [&](const std::string& id) {
    return std::ranges::find(at_end, id, &scene::ObjectSpec::id) - at_end.begin();
  };
  const auto after = std::ranges::find_if(structure->objects, [&](const auto& object) {
    return rank(object.id()) > rank(landmark->id());
  });
  structure->objects.insert(after, *landmark);
}

}  // namespace smile::task
