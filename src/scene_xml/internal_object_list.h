#pragma once

#include <string>
#include <utility>
#include <vector>

#include "scene/scene_spec.h"
#include "scene_xml/internal_reading.h"
#include "scene_xml/scene_limits.h"

namespace smile::scene_xml {

/// The objects of a scene and where they were written. A small file can ask for many: a chain has a
/// thousand links.
class ObjectList {
 public:
  ObjectList(const SceneLimits& limits, scene::SceneSpec* scene, Findings* findings)
      : limits_(limits), scene_(*scene), findings_(*findings) {}

  /// False when there is no room for so many more; the first time, that is a finding.
  [[nodiscard]] bool HasRoomFor(std::size_t count, const Place& place) {
    if (scene_.objects.size() + count <= static_cast<std::size_t>(limits_.max_objects)) return true;
    if (!std::exchange(is_full_, true)) {
      findings_.Add(place, "",
                    "found more than " + std::to_string(limits_.max_objects) +
                        " objects, links of chains among them, expected fewer");
    }
    return false;
  }

  void Add(scene::ObjectSpec object, const Place& place) {
    scene_.objects.push_back(std::move(object));
    places_.push_back(place);
  }

  scene::SceneSpec& scene() { return scene_; }
  const std::vector<Place>& places() const { return places_; }

 private:
  const SceneLimits& limits_;
  scene::SceneSpec& scene_;
  Findings& findings_;
  std::vector<Place> places_;
  bool is_full_ = false;
};

}  // namespace smile::scene_xml
