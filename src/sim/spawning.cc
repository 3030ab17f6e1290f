#include "sim/spawning.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>
#include <utility>

#include "base/wording.h"
#include "scene/controls_of.h"
#include "scene/joined.h"
#include "scene/units.h"
#include "texts/lists.h"
#include "world/refusal_names.h"

// Adding objects makes a larger model: the present one with the new objects appended, so that no
// index changes. Everything is checked on copies first: text, ids, limits, and room at the places
// of the new objects.

namespace smile::sim {
namespace {

using texts::Say;
using world::Refusal;

/// Returns a list of names for a message, shortened after ten.
Refusal Listed(std::vector<Refusal> names) {
  constexpr std::size_t kMaxListed = 10;
  if (names.size() <= kMaxListed) return texts::AllOf(names);
  const std::size_t num_more = names.size() - kMaxListed;
  names.resize(kMaxListed);
  return Say("lists.andMore", {{"list", texts::EachOf(names)}, {"number", num_more}});
}

/// Returns true if a text's table is compatible: the default of scene files, or the same as the
/// scene's.
bool IsOfTable(const scene::TableSpec& found, const scene::SceneSpec& scene) {
  constexpr double kSame = 1e-9;
  const auto is_span = [&](double span, double own, double units) {
    return std::abs(span - own) < kSame ||
           std::abs(span - scene::FromFileUnits(units, scene.meters_per_unit)) < kSame;
  };
  return is_span(found.x_span, scene.table.x_span, 20) &&
         is_span(found.y_span, scene.table.y_span, 12);
}

/// Returns the reason why a parsed scene cannot be added to another.
std::optional<Refusal> RefuseToAdd(const scene::SceneSpec& added, const scene::SceneSpec& scene) {
  if (added.meters_per_unit != scene.meters_per_unit) {
    return "the objects to add have " + NumberText(added.meters_per_unit) +
           " meters per unit, expected those of the scene, " + NumberText(scene.meters_per_unit);
  }
  if (!IsOfTable(added.table, scene)) return "the objects to add have a table of another size";
  if (!added.cameras.empty()) return "a camera cannot be added";
  if (!added.camera_offsets.empty()) return "an offset of a camera cannot be added";
  if (added.lighting != scene::Lighting()) return "a lighting cannot be added";
  if (added.objects.empty()) return "there is no object to add";
  // Ids of destroyed objects stay in the scene, so they are refused, too.
  const std::set<std::string> known = scene::IdsOf(scene), ids = scene::IdsOf(added);
  std::vector<std::string> taken;
  std::ranges::set_intersection(known, ids, std::back_inserter(taken));
  if (!taken.empty()) {
    return Say("objects.idsAreTaken", {{"ids", Listed({taken.begin(), taken.end()})}});
  }
  if (scene.objects.size() + added.objects.size() > kMaxObjects) {
    return Say("objects.tooMany", {{"limit", kMaxObjects}});
  }
  return std::nullopt;
}

}  // namespace

scene_xml::SceneReading ReadCommandScene(std::string_view xml, const std::string& name) {
  // Without search folders it cannot name files.
  return scene_xml::ReadSceneText(xml, name, {.search_roots = {}, .limits = kCommandSceneLimits});
}

std::optional<scene::SceneSpec> WithSpawned(const scene::SceneSpec& scene, const Spawn& spawn,
                                            Refusal* refusal) {
  if (spawn.xml.size() > kMaxSceneText) {
    *refusal = "the objects to add are longer than 1 MiB";
    return std::nullopt;
  }
  const scene_xml::SceneReading reading = ReadCommandScene(spawn.xml, "added");
  if (!reading.scene) {
    *refusal = "the objects to add are not a scene: " + ToString(reading.diagnostics.front());
    return std::nullopt;
  }
  if (auto why = RefuseToAdd(*reading.scene, scene)) {
    *refusal = *std::move(why);
    return std::nullopt;
  }
  return scene::Joined(scene, *reading.scene);
}

std::shared_ptr<const model::Model> GrownModel(const model::Model& model, const Spawn& spawn,
                                               Refusal* refusal) {
  auto scene = WithSpawned(model.scene(), spawn, refusal);
  if (!scene) return nullptr;
  return std::make_shared<const model::Model>(model, *std::move(scene));
}

std::optional<Refusal> RefuseOverlap(const model::Model& grown, const world::Tabletop& tabletop,
                                     const physics::World& world) {
  // New objects at their initial places, with their controls in their initial states.
  const model::SceneState& start = grown.initial_state();
  for (std::size_t i = tabletop.objects().size(); i < grown.objects().size(); ++i) {
    const model::ObjectIndex object(i);
    // Only the solids of the visible variants: a control's other states are not there.
    const std::vector<scene::Solid> solids = scene::SolidsWith(
        grown.VariantsOf(object, start.controls), scene::SolidsOf(grown.object(object).whole));
    const physics::Overlaps overlaps = world.OverlapsOf(solids, *start.X_WB[i], kTouching);
    std::vector<Refusal> blockers;
    for (physics::BodyId body : overlaps.bodies) {
      // Overlap with the table or floor is allowed, as in scene files: they push the object out.
      const world::Object* blocker = tabletop.Find(body);
      if (blocker != nullptr) blockers.push_back(world::ObjectName(blocker->id()));
    }
    if (overlaps.with_articulation) blockers.push_back(world::RobotName());
    if (blockers.empty()) continue;
    const std::size_t num_blockers = blockers.size();
    return Say("objects.noRoom", {{"object", grown.id(object)},
                                  {"blockers", Listed(std::move(blockers))},
                                  {"number", num_blockers}});
  }
  return std::nullopt;
}

}  // namespace smile::sim
