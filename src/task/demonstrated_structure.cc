#include "task/demonstrated_structure.h"

#include <algorithm>
#include <set>

#include "base/diagnostic.h"
#include "recording/attention.h"
#include "task/anchor.h"
#include "task/comparison.h"
#include "task/neighbors.h"
#include "task/rules.h"

namespace smile::task {
namespace {

/// Limit on the objects of a task: the time for a comparison grows faster than the square of their
/// number.
constexpr std::size_t kMaxObjects = 500;

[[noreturn]] void Fail(const recording::Recording& demonstration, const std::string& message) {
  throw InputError({demonstration.directory.string(), 0, "", message});
}

/// Pair (object, other): if the object is part of a structure, the other one is as well.
using Belonging = std::pair<std::string, std::string>;

/// Returns what hands put around objects that stayed where they were.
std::vector<Surrounding> SurroundingsIn(const Episode& episode, const Structure& structure) {
  const std::vector<scene::ObjectSpec> before = ObjectsAt(episode.scene, episode.begin);
  std::vector<const scene::ObjectSpec*> stayed;
  for (const scene::ObjectSpec& object : structure.objects) {
    const auto start = std::ranges::find(before, object.id(), &scene::ObjectSpec::id);
    if (start != before.end() && !HasMoved(start->pose_in_world(), object.pose_in_world())) {
      stayed.push_back(&object);
    }
  }
  std::vector<Surrounding> surroundings;
  for (const scene::ObjectSpec& outer : structure.objects) {
    if (std::ranges::find(structure.order, outer.id()) == structure.order.end()) continue;
    for (const scene::ObjectSpec* inner : stayed) {
      if (inner != &outer && model::IsAround(outer, *inner)) {
        surroundings.push_back({outer.id(), inner->id()});
      }
    }
  }
  return surroundings;
}

/// Returns the loose objects of a structure that stood on the table, were not moved and carry
/// others.
std::vector<std::string> FoundationsOf(const Episode& episode, const Structure& structure) {
  const ObjectPoses before = PosesAt(episode.scene, episode.begin);
  const auto is_on_table = [](const Relation& it) { return it.support.empty(); };
  std::vector<std::string> foundations;
  for (const scene::ObjectSpec& object : structure.objects) {
    const std::string& id = object.id();
    const auto is_its = [&](const Relation& it) { return it.object == id && is_on_table(it); };
    const auto is_carried = [&](const Relation& it) { return it.support == id; };
    const auto is_around = [&](const Surrounding& it) { return it.inner == id; };
    if (object.is_static() || HasMoved(before.at(id), object.pose_in_world()) ||
        std::ranges::none_of(structure.relations, is_its)) {
      continue;
    }
    if (std::ranges::any_of(structure.relations, is_carried) ||
        std::ranges::any_of(structure.around, is_around)) {
      foundations.push_back(id);
    }
  }
  return foundations;
}

/// Returns true if an object that was placed is in place already when the demonstration begins:
/// with foundations that may be turned by themselves, a move around a round plate is none.
bool IsSomethingPlacedAlready(const Structure& structure, const Episode& episode) {
  const StructureComparison comparison = CompareWith(structure, AtBegin(episode));
  return std::ranges::any_of(
      structure.order, [&](const std::string& id) { return comparison.errors.at(id).is_within(); });
}

/// Returns the pairs of objects that belong together. A support or container belongs to what it
/// carries, but not the reverse: other objects on the same plank may be unrelated. What stayed
/// belongs to what was put around it. Sliders and bonds connect both ways.
std::vector<Belonging> BelongingsIn(const Episode& episode, const Structure& structure) {
  std::vector<Belonging> belongings;
  const auto add_both = [&](const std::string& a, const std::string& b) {
    belongings.emplace_back(a, b);
    belongings.emplace_back(b, a);
  };
  for (const Relation& relation : structure.relations) {
    if (!relation.support.empty()) belongings.emplace_back(relation.object, relation.support);
  }
  for (const Surrounding& it : structure.around) belongings.emplace_back(it.object, it.inner);
  for (const scene::SliderSpec& slider : episode.scene.sliders) {
    add_both(episode.scene.objects[slider.first_object].id(),
             episode.scene.objects[slider.first_object + 1].id());
  }
  for (const BondEffect& bond : BondsAt(episode.scene, episode.end)) {
    add_both(bond.guest_object, bond.host_object);
  }
  return belongings;
}

/// Returns the ids and everything that belongs to them, directly or not (transitive closure).
std::set<std::string> WithBelongings(std::set<std::string> ids,
                                     const std::vector<Belonging>& belongings) {
  for (bool has_grown = true; has_grown;) {
    has_grown = false;
    for (const auto& [object, other] : belongings) {
      if (ids.contains(object)) has_grown = ids.insert(other).second || has_grown;
    }
  }
  return ids;
}

/// Returns the objects that any effect refers to.
std::set<std::string> ConcernedBy(const std::vector<Effect>& effects) {
  std::set<std::string> concerned;
  for (const Effect& effect : effects) {
    for (const std::string& id : ObjectsOf(effect)) concerned.insert(id);
  }
  return concerned;
}

/// Returns the objects that were removed from the table.
std::set<std::string> RemovedBy(const std::vector<Effect>& effects) {
  std::set<std::string> removed;
  for (const Effect& effect : effects) {
    if (const auto* gone = std::get_if<DestroyedEffect>(&effect)) removed.insert(gone->object);
  }
  return removed;
}

/// Throws if nothing was achieved, or if the structure is too large to compare.
void RequireATask(const Structure& structure, const recording::Recording& demonstration) {
  if (structure.objects.empty() && structure.effects.empty()) {
    Fail(demonstration,
         "contains nothing to imitate: no hand moved an object that remains at the end, and "
         "nothing else changed");
  }
  const std::size_t count = structure.objects.size() + structure.others.size();
  if (count > kMaxObjects) {
    Fail(demonstration, std::to_string(count) + " objects are part of the task, " +
                            "expected at most " + std::to_string(kMaxObjects));
  }
}

}  // namespace

Structure StructureOf(const recording::Recording& demonstration) {
  const Episode episode = EpisodeOf(demonstration);
  Structure structure{.objects = ObjectsAt(episode.scene, episode.end),
                      .relations = {},
                      .around = {},
                      .order = PlacementsOf(episode),
                      .effects = EffectsOf(episode),
                      .others = {},
                      .fallen = FallenObjects(episode),
                      .attention = recording::AttentionOf(demonstration)};
  structure.relations = model::RelationsOf(episode.scene, structure.objects);
  structure.around = SurroundingsIn(episode, structure);

  // The structure consists of what hands touched and what belongs to it.
  const std::vector<std::string> touched = TouchedByHands(episode);
  std::set<std::string> members =
      WithBelongings({touched.begin(), touched.end()}, BelongingsIn(episode, structure));
  const std::set<std::string> concerned = ConcernedBy(structure.effects);
  // What was removed from the table has no place, wherever it lies; its last pose there stands for
  // its looks.
  const std::set<std::string> removed = RemovedBy(structure.effects);
  for (const std::string& id : removed) members.erase(id);
  for (const scene::ObjectSpec& object : ObjectsAt(episode.scene, episode.begin)) {
    const bool is_gone = std::ranges::find(structure.objects, object.id(),
                                           &scene::ObjectSpec::id) == structure.objects.end();
    if (is_gone && removed.contains(object.id())) structure.others.push_back(object);
  }
  // Objects outside the structure whose state matters need a counterpart, but no place.
  for (const scene::ObjectSpec& object : structure.objects) {
    if (!members.contains(object.id()) && concerned.contains(object.id())) {
      structure.others.push_back(object);
    }
  }
  // All lists started with the objects of the whole scene; what is not a member of the structure is
  // removed.
  std::erase_if(structure.objects,
                [&](const auto& object) { return !members.contains(object.id()); });
  std::erase_if(structure.order, [&](const std::string& id) { return !structure.Contains(id); });
  RequireATask(structure, demonstration);
  FindAnchor(episode, &structure);
  std::erase_if(structure.relations,
                [&](const Relation& relation) { return !structure.Contains(relation.object); });
  std::erase_if(structure.around,
                [&](const Surrounding& it) { return !structure.Contains(it.object); });
  structure.neighbors = NeighborsOf(structure);
  if (structure.anchor == Anchor::kNone) structure.foundations = FoundationsOf(episode, structure);
  if (!structure.foundations.empty() && IsSomethingPlacedAlready(structure, episode)) {
    structure.foundations.clear();
  }
  structure.bystanders = BystandersOf(structure, episode);
  structure.support_rules = SupportRulesOf(structure.attention, episode);
  return structure;
}

}  // namespace smile::task
