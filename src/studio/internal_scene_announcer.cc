#include "studio/internal_scene_announcer.h"

#include "studio/scene_message.h"

namespace smile::studio {

Json LooksMessage(const std::vector<int>& looks) { return {{"t", "looks"}, {"looks", looks}}; }

Json SceneAnnouncer::Announce(const model::Model& model, const std::vector<int>& looks) {
  // The meshes of the last scenes stay available under their numbers: a page may still load those
  // of the scene before.
  present_ = meshes_.Add(++number_, model.visual_model());
  sent_looks_ = looks;
  return Describe(model, looks);
}

Json SceneAnnouncer::Describe(const model::Model& model, const std::vector<int>& looks) const {
  return SceneMessage(number_, model, *present_, looks);
}

std::optional<Json> SceneAnnouncer::UpdateLooks(const std::vector<int>& looks) {
  if (looks == sent_looks_) return std::nullopt;
  sent_looks_ = looks;
  return LooksMessage(looks);
}

std::optional<std::string> SceneAnnouncer::MeshBytes(std::uint32_t scene, std::size_t mesh) const {
  const auto meshes = meshes_.Find(scene);
  return meshes ? meshes->Bytes(mesh) : std::nullopt;
}

}  // namespace smile::studio
