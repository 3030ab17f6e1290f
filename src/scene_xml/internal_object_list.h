#pragma once

#include <string>
#include <utility>
#include <vector>

#include "scene/scene_spec.h"
#include "scene_xml/internal_reading_context.h"
#include "scene_xml/scene_limits.h"

namespace smile::scene_xml {

/// Objects of a scene with their places in the files. The number is limited: a small file can
/// request many, as a chain has up to a thousand links.
class ObjectList {
 public:
  ObjectList(const SceneLimits& limits, scene::SceneSpec* scene, Findings* findings)
      : limits_(limits), scene_(*scene), findings_(*findings) {}

  /// Returns false if `count` more objects exceed the limit; the first time, with a finding.
  [[nodiscard]] bool HasRoomFor(std::size_t count, const SourceLocation& place) {
    if (scene_.objects.size() + count <= static_cast<std::size_t>(limits_.max_objects)) return true;
    if (!std::exchange(is_full_, true)) {
      findings_.Add(place, "",
                    "found more than " + std::to_string(limits_.max_objects) +
                        " objects, links of chains among them, expected fewer");
    }
    return false;
  }

  void Add(scene::ObjectSpec object, const SourceLocation& place) {
    scene_.objects.push_back(std::move(object));
    places_.push_back(place);
  }

  scene::SceneSpec& scene() { return scene_; }
  const std::vector<SourceLocation>& places() const { return places_; }

 private:
  const SceneLimits& limits_;
  scene::SceneSpec& scene_;
  Findings& findings_;
  std::vector<SourceLocation> places_;
  bool is_full_ = false;
};

}  // namespace smile::scene_xml
