#include "experiment/internal_chain_objects.h"

namespace smile::experiment::internal {

std::set<std::size_t> ChainObjects(const scene::SceneSpec& scene) {
  std::set<std::size_t> objects;
  for (const scene::ChainSpec& chain : scene.chains) {
    const std::size_t end = chain.first_object + 2 + chain.link_ids.size();
    for (std::size_t i = chain.first_object; i < end; ++i) objects.insert(i);
  }
  return objects;
}

}  // namespace smile::experiment::internal
