#include "task/structure.h"

#include <algorithm>
#include <set>

#include "base/diagnostic.h"
#include "record/attention.h"

namespace smile::task {
namespace {

/// These, and everything beneath and around them down to the table.
std::set<std::string> WithSupports(std::set<std::string> ids,
                                   const std::vector<Relation>& relations) {
  for (bool has_grown = true; has_grown;) {
    has_grown = false;
    for (const Relation& relation : relations) {
      if (relation.support.empty() || !ids.contains(relation.object)) continue;
      has_grown = ids.insert(relation.support).second || has_grown;
    }
  }
  return ids;
}

}  // namespace

bool Structure::is_fixed() const {
  return std::ranges::any_of(objects, &scene::ObjectSpec::is_static);
}

std::vector<std::string> Structure::AttendedOf(const std::string& object) const {
  const auto told = attention.find(object);
  return told != attention.end() ? told->second : std::vector<std::string>();
}

Structure StructureOf(const record::Recording& demonstration) {
  const Course course = CourseOf(demonstration);
  Structure structure{.objects = ObjectsAt(course.scene, course.end),
                      .relations = {},
                      .order = PlacementsOf(course),
                      .effects = EffectsOf(course),
                      .others = {},
                      .attention = record::AttentionOf(demonstration)};
  structure.relations = RelationsOf(course.scene.table, structure.objects);

  const std::vector<std::string> touched = TouchedByHands(course);
  const std::set<std::string> members =
      WithSupports({touched.begin(), touched.end()}, structure.relations);
  std::set<std::string> concerned;
  for (const Effect& effect : structure.effects) {
    for (const std::string& id : ObjectsOf(effect)) concerned.insert(id);
  }
  for (const scene::ObjectSpec& object : structure.objects) {
    if (!members.contains(object.id()) && concerned.contains(object.id())) {
      structure.others.push_back(object);
    }
  }
  const auto is_missing = [&](const std::string& id) { return !members.contains(id); };
  std::erase_if(structure.objects, [&](const auto& object) { return is_missing(object.id()); });
  std::erase_if(structure.relations, [&](const auto& one) { return is_missing(one.object); });
  std::erase_if(structure.order, [&](const std::string& id) {
    return std::ranges::find(structure.objects, id, &scene::ObjectSpec::id) ==
           structure.objects.end();
  });
  if (structure.objects.empty() && structure.effects.empty()) {
    throw InputError({demonstration.directory.string(), 0, "",
                      "no hand moved anything in this recording that is still there, and nothing "
                      "else changed, so there is nothing to imitate"});
  }
  return structure;
}

}  // namespace smile::task
