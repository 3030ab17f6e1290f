#include "scene/joined.h"

#include <utility>
#include <vector>

#include "scene/control.h"

// Joining scenes, for objects that are added while a simulation runs: the second scene is appended
// to the first, so no index of the first changes. The caller has checked that units, table and ids
// are compatible.

namespace smile::scene {
namespace {

void AddIdsOf(const Part& part, std::set<std::string>* ids) {
  if (!part.id.empty()) ids->insert(part.id);
  if (const auto* composite = std::get_if<Composite>(&part.shape)) {
    for (const Part& child : composite->parts) AddIdsOf(child, ids);
    for (const GuestPoint& guest : composite->guests) ids->insert(guest.id);
    for (const HostPoint& host : composite->hosts) ids->insert(host.id);
  } else if (const auto* control = std::get_if<CustomControl>(&part.shape)) {
    // Parts of all states, also those that are not shown now.
    for (const CustomControl::State& state : control->states) {
      for (const Part& child : state.parts) AddIdsOf(child, ids);
    }
  }
}

}  // namespace

std::set<std::string> IdsOf(const SceneSpec& scene) {
  std::set<std::string> ids;
  for (const ObjectSpec& object : scene.objects) AddIdsOf(object.whole, &ids);
  for (const SliderSpec& slider : scene.sliders) {
    if (!slider.id.empty()) ids.insert(slider.id);
  }
  for (const ChainSpec& chain : scene.chains) ids.insert(chain.id);
  return ids;
}

SceneSpec Joined(SceneSpec scene, SceneSpec added) {
  // Mechanisms refer to objects by index, which is shifted.
  const std::size_t num_objects = scene.objects.size();
  for (ObjectSpec& object : added.objects) scene.objects.push_back(std::move(object));
  for (SliderSpec& slider : added.sliders) {
    slider.first_object += num_objects;
    scene.sliders.push_back(std::move(slider));
  }
  for (ChainSpec& chain : added.chains) {
    chain.first_object += num_objects;
    scene.chains.push_back(std::move(chain));
  }
  return scene;
}

SceneSpec AddedTo(const SceneSpec& scene, SceneSpec joined) {
  const auto erase_first = [](auto& list, std::size_t count) {
    list.erase(list.begin(), list.begin() + static_cast<std::ptrdiff_t>(count));
  };
  erase_first(joined.objects, scene.objects.size());
  erase_first(joined.sliders, scene.sliders.size());
  erase_first(joined.chains, scene.chains.size());
  for (SliderSpec& slider : joined.sliders) slider.first_object -= scene.objects.size();
  for (ChainSpec& chain : joined.chains) chain.first_object -= scene.objects.size();
  // The table belongs to the scene, with its colors, as do light and cameras.
  joined.table = {.x_span = joined.table.x_span,
                  .y_span = joined.table.y_span,
                  .thickness = joined.table.thickness};
  joined.lighting = {};
  joined.camera_offsets.clear();
  joined.cameras.clear();
  return joined;
}

}  // namespace smile::scene
