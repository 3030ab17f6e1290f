#include "scene_xml/internal_id_registry.h"

namespace smile::scene_xml {

std::string IdRegistry::Claim(const std::string& wanted) {
  const std::string base = wanted.empty() ? "obj" : wanted;
  std::string id = base;
  // The counter never goes back, so this ends: each number is tried once in a scene.
  while (!ClaimExactly(id)) id = base + "#" + std::to_string(next_number_++);
  return id;
}

}  // namespace smile::scene_xml
