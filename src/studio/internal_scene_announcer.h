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

/// Tells pages which scene they see, and which of its looks.
class SceneAnnouncer {
 public:
  /// Another model is shown from now on.
  /// @returns the message for all.
  Json Announce(const model::Model& model, const std::vector<int>& looks);
  /// The same for who comes later.
  Json Describe(const model::Model& model, const std::vector<int>& looks) const;
  /// nullopt if these are the looks that were told last.
  std::optional<Json> TellLooks(const std::vector<int>& looks);

  /// Counts up with each model; see library::View::scene.
  std::uint32_t number() const { return number_; }
  /// See Session::MeshBytes(). From any thread.
  std::optional<std::string> MeshBytes(std::uint32_t scene, std::size_t mesh) const;

 private:
  std::uint32_t number_ = 0;
  SceneMeshes meshes_;
  std::shared_ptr<const PageMeshes> present_;
  std::vector<int> told_looks_;
};

/// `{"t":"looks",…}`.
Json LooksMessage(const std::vector<int>& looks);

}  // namespace smile::studio
