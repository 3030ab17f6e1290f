#include "task/goals.h"

#include <algorithm>
#include <set>
#include <stdexcept>

#include "base/wording.h"
#include "task/structure_json.h"

namespace smile::task {
namespace {

std::set<std::string> CheckedIds(const std::vector<std::string>& ids,
                                 const std::vector<Goal>& goals) {
  std::vector<std::string_view> known;
  for (const Goal& goal : goals) known.push_back(goal.id);
  for (const std::string& id : ids) {
    if (std::ranges::find(known, id) != known.end()) continue;
    throw std::invalid_argument("goals: found " + Quoted(id) + ", expected " + OneOf(known) +
                                DidYouMean(id, known));
  }
  std::set<std::string> checked(ids.begin(), ids.end());
  if (checked.size() < goals.size()) return checked;
  throw std::invalid_argument("goals: none is left, expected at least one of " + OneOf(known));
}

/// Removes the places of objects. They remain known, since effects may refer to them.
void RemovePlaces(const std::set<std::string>& ids, Structure* structure) {
  for (const scene::ObjectSpec& object : structure->objects) {
    if (!ids.contains(object.id())) continue;
    structure->bystanders.push_back(object);
    structure->others.push_back(object);
  }
  const auto is_removed = [&](const std::string& id) { return ids.contains(id); };
  std::erase_if(structure->objects, [&](const auto& object) { return is_removed(object.id()); });
  std::erase_if(structure->relations, [&](const Relation& relation) {
    return is_removed(relation.object) || is_removed(relation.support);
  });
  std::erase_if(structure->order, is_removed);
  // A foundation that carries nothing any more is none.
  std::erase_if(structure->foundations, [&](const std::string& id) {
    const auto is_on_it = [&](const Relation& relation) { return relation.support == id; };
    return std::ranges::none_of(structure->relations, is_on_it);
  });
  std::erase_if(structure->neighbors, [&](const Neighbors& pair) {
    return is_removed(pair.object) || is_removed(pair.other);
  });
  if (is_removed(structure->landmark)) {
    structure->landmark.clear();
    structure->anchor = Anchor::kNone;
  }
}

}  // namespace

std::vector<Goal> GoalsOf(const Structure& structure, double meters_per_unit) {
  std::vector<Goal> goals;
  for (const scene::ObjectSpec& object : structure.objects) {
    if (object.is_static()) continue;
    goals.push_back({object.id(), PlaceWordsOf(object.id(), structure.relations)});
  }
  for (const Effect& effect : structure.effects) {
    const texts::UserMessage words = WordsOf(effect, meters_per_unit);
    // Two effects in the same words count together.
    const Goal goal{words, words, /*is_place=*/false};
    if (std::ranges::find(goals, goal) == goals.end()) goals.push_back(goal);
  }
  return goals;
}

Structure WithoutGoals(Structure structure, const std::vector<std::string>& ids,
                       double meters_per_unit) {
  const std::set<std::string> removed = CheckedIds(ids, GoalsOf(structure, meters_per_unit));
  if (removed.empty()) return structure;
  RemovePlaces(removed, &structure);
  std::erase_if(structure.effects, [&](const Effect& effect) {
    return removed.contains(WordsOf(effect, meters_per_unit));
  });
  return structure;
}

}  // namespace smile::task
