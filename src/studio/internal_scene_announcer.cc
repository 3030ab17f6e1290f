#include "studio/internal_scene_announcer.h"

#include "page/scene_message.h"

namespace smile::studio {

Json LooksMessage(const std::vector<int>& variants) {
  return {{"t", "looks"}, {"looks", variants}};
}

Json SceneAnnouncer::Announce(const model::Model& model, const std::vector<int>& variants) {
  // The meshes of the last scenes stay available under their numbers: a page may still load those
  // of the scene before.
  present_ = meshes_.Add(++number_, model.visual_model());
  sent_variants_ = variants;
  return Describe(model, variants);
}

Json SceneAnnouncer::Describe(const model::Model& model, const std::vector<int>& variants) const {
  return page::SceneMessage(number_, model, *present_, variants);
}

std::optional<Json> SceneAnnouncer::UpdateVariants(const std::vector<int>& variants) {
  if (variants == sent_variants_) return std::nullopt;
  sent_variants_ = variants;
  return LooksMessage(variants);
}

std::optional<std::string> SceneAnnouncer::MeshBytes(std::uint32_t scene, std::size_t mesh) const {
  const auto meshes = meshes_.Find(scene);
  return meshes ? meshes->Bytes(mesh) : std::nullopt;
}

}  // namespace smile::studio
