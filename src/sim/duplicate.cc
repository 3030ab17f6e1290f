#include "sim/duplicate.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <utility>
#include <variant>

#include "scene/bounds.h"
#include "scene/controls_of.h"
#include "scene/joined.h"
#include "scene/parts.h"
#include "scene_xml/scene_writer.h"
#include "sim/displacing.h"
#include "sim/internal_command_fields.h"
#include "sim/spawning.h"

// `duplicate` is a question, as `add` is: the answer is the `spawn` command with the copies as a
// scene. Objects with mechanisms refer to others by id, and are refused.

namespace smile::sim {

using texts::Say;
namespace {

/// Space between objects and their copies [m].
constexpr double kBetweenCopies = 0.01;

/// Returns `red_2`, or the next free number, for `red` as for `red_1`.
std::string CopyId(const std::string& id, std::set<std::string>* ids) {
  const std::size_t stem = id.find_last_not_of("0123456789");
  const bool is_numbered = stem != std::string::npos && stem > 0 && id[stem] == '_';
  const std::string word = is_numbered ? id.substr(0, stem) : id;
  for (int number = 2;; ++number) {
    std::string copy = word + "_" + std::to_string(number);
    if (ids->insert(copy).second) return copy;
  }
}

/// Gives a part and everything in it new ids.
void Rename(scene::Part* part, std::set<std::string>* ids) {
  if (!part->id.empty()) part->id = CopyId(part->id, ids);
  auto* composite = std::get_if<scene::Composite>(&part->shape);
  if (composite == nullptr) return;
  for (scene::Part& child : composite->parts) Rename(&child, ids);
}

/// Returns true for an object that no part of the scene refers to, and that needs no file.
bool IsPlain(const scene::SceneSpec& scene, std::size_t index) {
  bool is_plain = scene::ControlsOf(scene.objects[index].whole).empty();
  scene::ForEachPart(scene.objects[index].whole, [&is_plain](const scene::Part& part) {
    const auto* composite = std::get_if<scene::Composite>(&part.shape);
    const bool has_bonds =
        composite != nullptr && !(composite->guests.empty() && composite->hosts.empty());
    is_plain = is_plain && !has_bonds && !std::holds_alternative<scene::Custom>(part.shape);
  });
  for (const scene::SliderSpec& slider : scene.sliders) {
    is_plain = is_plain && index != slider.first_object && index != slider.first_object + 1;
  }
  for (const scene::ChainSpec& chain : scene.chains) {
    const std::size_t end = chain.first_object + 2 + chain.link_ids.size();
    is_plain = is_plain && (index < chain.first_object || index >= end);
  }
  return is_plain;
}

/// Returns the reason why objects cannot be copied.
std::optional<Refusal> RefuseToCopy(const std::vector<std::string>& objects,
                                    const Simulation& simulation) {
  if (auto refusal = RefuseRepeated(objects)) return refusal;
  for (const std::string& id : objects) {
    const world::Object* object = simulation.tabletop().Find(id);
    if (object == nullptr) return simulation.tabletop().RefuseToReach(id);
    if (IsPlain(simulation.scene(), object->index)) continue;
    return Say("objects.cannotBeCopied", {{"object", id}});
  }
  return std::nullopt;
}

/// Returns the copies at the places of the objects, as a scene.
scene::SceneSpec CopiesOf(const std::vector<std::string>& objects, const Simulation& simulation) {
  const scene::SceneSpec& scene = simulation.scene();
  scene::SceneSpec copies{
      .name = "copies", .meters_per_unit = scene.meters_per_unit, .table = scene.table};
  std::set<std::string> ids = scene::IdsOf(scene);
  for (const std::string& id : objects) {
    const world::Object& object = *simulation.tabletop().Find(id);
    scene::ObjectSpec copy = *object.spec;
    copy.whole.X_PE = simulation.physics().body(object.body).pose_in_world();
    Rename(&copy.whole, &ids);
    copies.objects.push_back(std::move(copy));
  }
  return copies;
}

scene::Bounds BoundsOf(const scene::SceneSpec& scene) {
  scene::Bounds bounds;
  for (const scene::ObjectSpec& object : scene.objects) {
    bounds.Add(scene::BoundsOf(scene::SolidsOf(object.whole), object.pose_in_world()));
  }
  return bounds;
}

Spawn SpawnAt(scene::SceneSpec copies, const Vector3& by) {
  for (scene::ObjectSpec& object : copies.objects) {
    object.whole.X_PE = RigidTransform(by) * object.whole.X_PE;
  }
  return {.xml = scene_xml::WriteScene(copies)};
}

/// Returns true if the bounds stay over the table after a horizontal displacement.
bool IsOverTable(const scene::Bounds& bounds, const Vector3& by, const scene::TableSpec& table) {
  const Vector3 low = bounds.low + by, high = bounds.high + by;
  return low.x() >= -table.x_span / 2 && high.x() <= table.x_span / 2 &&
         low.y() >= -table.y_span / 2 && high.y() <= table.y_span / 2;
}

/// Returns horizontal ways to places beside the bounds, the nearest first.
std::vector<Vector3> WaysBeside(const scene::Bounds& bounds) {
  constexpr int kRings = 6;
  constexpr std::array<std::array<int, 2>, 8> kDirections{
      {{1, 0}, {-1, 0}, {0, 1}, {0, -1}, {1, 1}, {-1, 1}, {1, -1}, {-1, -1}}};
  const Vector3 size = bounds.high - bounds.low;
  std::vector<Vector3> ways;
  for (int ring = 1; ring <= kRings; ++ring) {
    for (const auto& [x, y] : kDirections) {
      ways.emplace_back(ring * x * (size.x() + kBetweenCopies),
                        ring * y * (size.y() + kBetweenCopies), 0);
    }
  }
  return ways;
}

}  // namespace

bool IsDuplicate(const Json& json) {
  return json.is_object() && json.contains("do") && json.at("do") == Duplicate::kName.name;
}

Duplicate ParseDuplicate(const Json& json, double meters_per_unit) {
  return ReadFields<Duplicate>(json, meters_per_unit);
}

std::optional<Spawn> SpawnOf(const Duplicate& duplicate, const Simulation& simulation,
                             Refusal* refusal) {
  if (auto reason = RefuseToCopy(duplicate.objects, simulation)) {
    *refusal = *std::move(reason);
    return std::nullopt;
  }
  const scene::SceneSpec copies = CopiesOf(duplicate.objects, simulation);
  if (duplicate.by) return SpawnAt(copies, *duplicate.by);
  const scene::Bounds bounds = BoundsOf(copies);
  for (const Vector3& by : WaysBeside(bounds)) {
    if (!IsOverTable(bounds, by, simulation.scene().table)) continue;
    Spawn spawn = SpawnAt(copies, by);
    const auto grown = GrownModel(simulation.model(), spawn, refusal);
    if (grown == nullptr) return std::nullopt;
    if (!RefuseOverlap(*grown, simulation.tabletop(), simulation.physics())) return spawn;
  }
  *refusal = Say("objects.noPlaceBeside");
  return std::nullopt;
}

}  // namespace smile::sim
