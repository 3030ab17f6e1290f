#include "sim/add.h"

#include <stdexcept>

#include "layout/presets.h"
#include "scene/joined.h"
#include "scene_xml/scene_writer.h"
#include "sim/internal_command_fields.h"
#include "sim/spawning.h"

// `add` is a question: it names a ready-made set of objects and a seed, and the answer is the
// `spawn` command with their XML and places. The log contains only the answer, so that presets may
// change without changing old recordings.

namespace smile::sim {

using texts::Say;
namespace {

/// Returns the present table, objects and ids.
layout::PlacementContext PlacementContextOf(const Simulation& simulation) {
  const scene::SceneSpec& scene = simulation.scene();
  layout::PlacementContext context{.meters_per_unit = scene.meters_per_unit,
                                   .table = scene.table,
                                   .taken = {},
                                   .ids = scene::IdsOf(scene)};
  for (const world::Object& object : simulation.tabletop().objects()) {
    // Ids of removed objects stay taken, their places do not.
    if (!simulation.tabletop().IsPresent(object)) continue;
    const physics::Body& body = simulation.physics().body(object.body);
    context.taken.push_back(scene::BoundsOf(body.spec().solids, body.pose_in_world()));
  }
  return context;
}

/// Returns the objects at a given place, without a search: the simulation refuses them if there is
/// no room.
std::optional<Spawn> SpawnAt(const Add& add, const layout::PlacementContext& context,
                             Refusal* refusal) {
  try {
    return Spawn{
        .xml = scene_xml::WriteScene(layout::MakePreset(add.preset, context, add.seed, *add.p_WQ))};
  } catch (const std::invalid_argument& error) {
    *refusal = error.what();
    return std::nullopt;
  }
}

}  // namespace

bool IsAdd(const Json& json) {
  return json.is_object() && json.contains("do") && json.at("do") == Add::kName.name;
}

Add ParseAdd(const Json& json, double meters_per_unit) {
  return ReadFields<Add>(json, meters_per_unit);
}

std::optional<Spawn> SpawnOf(const Add& add, const Simulation& simulation, Refusal* refusal) {
  // A place that is free of objects may still be taken by the robot: try other seeds. The constant
  // between seeds (2^64 divided by the golden ratio) spreads them well.
  constexpr std::uint64_t kMaxTries = 20, kBetweenSeeds = 0x9E3779B97F4A7C15;
  const layout::PlacementContext context = PlacementContextOf(simulation);
  if (add.p_WQ) return SpawnAt(add, context, refusal);
  for (std::uint64_t i = 0; i < kMaxTries; ++i) {
    std::optional<scene::SceneSpec> scene;
    try {
      scene = layout::MakePreset(add.preset, context, add.seed + i * kBetweenSeeds);
    } catch (const std::invalid_argument& error) {
      *refusal = error.what();
      return std::nullopt;
    }
    if (!scene) {
      *refusal = Say("objects.noPlace");
      return std::nullopt;
    }
    Spawn spawn{.xml = scene_xml::WriteScene(*scene)};
    // The layout knows only boxes of objects; the physics knows the robot and exact shapes.
    const auto grown = GrownModel(simulation.model(), spawn, refusal);
    if (grown == nullptr) return std::nullopt;
    if (!RefuseOverlap(*grown, simulation.tabletop(), simulation.physics())) return spawn;
  }
  *refusal = Say("objects.armsInTheWay");
  return std::nullopt;
}

}  // namespace smile::sim
