#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <mutex>

#include "studio/page_meshes.h"

namespace smile::studio {

/// The meshes of the scenes that pages may still ask for. Any thread may.
class SceneMeshes {
 public:
  std::shared_ptr<const PageMeshes> Add(std::uint32_t scene, const scene::VisualModel& model) {
    auto meshes = std::make_shared<const PageMeshes>(model);
    const std::lock_guard lock(mutex_);
    of_scene_[scene] = meshes;
    while (of_scene_.size() > kMaxScenes) of_scene_.erase(of_scene_.begin());
    return meshes;
  }
  /// nullptr of a scene that was forgotten or never was. Shared, since whoever asks may still read
  /// when the scene is gone.
  std::shared_ptr<const PageMeshes> Find(std::uint32_t scene) const {
    const std::lock_guard lock(mutex_);
    const auto found = of_scene_.find(scene);
    return found == of_scene_.end() ? nullptr : found->second;
  }

 private:
  static constexpr std::size_t kMaxScenes = 4;

  mutable std::mutex mutex_;
  std::map<std::uint32_t, std::shared_ptr<const PageMeshes>> of_scene_;
};

}  // namespace smile::studio
