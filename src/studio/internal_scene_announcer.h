#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/json.h"
#include "model/model.h"
#include "studio/scene_meshes.h"

namespace smile::studio {

/// Scene announcer: makes the messages about the shown scene and its variants.
class SceneAnnouncer {
 public:
  /// Sets the shown model.
  /// @returns the message for all clients.
  Json Announce(const model::Model& model, const std::vector<int>& variants);
  /// Returns the same message, for new clients.
  Json Describe(const model::Model& model, const std::vector<int>& variants) const;
  /// Returns the message with these variants; nullopt if they were sent last.
  std::optional<Json> UpdateVariants(const std::vector<int>& variants);

  /// Counts up with each model; see library::DisplayedState::scene.
  std::uint32_t number() const { return number_; }
  /// See Session::MeshBytes(). From any thread.
  std::optional<std::string> MeshBytes(std::uint32_t scene, std::size_t mesh) const;

 private:
  std::uint32_t number_ = 0;
  SceneMeshes meshes_;
  std::shared_ptr<const page::PageMeshes> present_;
  std::vector<int> sent_variants_;
};

/// `{"t":"looks",…}`.
Json LooksMessage(const std::vector<int>& variants);

}  // namespace smile::studio
