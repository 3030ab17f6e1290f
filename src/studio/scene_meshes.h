#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <mutex>

#include "page/page_meshes.h"

namespace smile::studio {

/// Meshes of the last scenes, which pages may still request. Thread-safe.
class SceneMeshes {
 public:
  std::shared_ptr<const page::PageMeshes> Add(std::uint32_t scene,
                                              const scene::VisualModel& model) {
    auto meshes = std::make_shared<const page::PageMeshes>(model);
    const std::lock_guard lock(mutex_);
    of_scene_[scene] = meshes;
    while (of_scene_.size() > kMaxScenes) of_scene_.erase(of_scene_.begin());
    return meshes;
  }
  /// Returns the meshes of a scene; nullptr if it is forgotten or never existed. Shared, since a
  /// reader may still use it when the scene is replaced.
  std::shared_ptr<const page::PageMeshes> Find(std::uint32_t scene) const {
    const std::lock_guard lock(mutex_);
    const auto found = of_scene_.find(scene);
    return found == of_scene_.end() ? nullptr : found->second;
  }

 private:
  static constexpr std::size_t kMaxScenes = 4;

  mutable std::mutex mutex_;
  std::map<std::uint32_t, std::shared_ptr<const page::PageMeshes>> of_scene_;
};

}  // namespace smile::studio
