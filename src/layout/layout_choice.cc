#include "layout/layout_choice.h"

#include <utility>

#include "layout/layout.h"

namespace smile::layout {

scene::SceneSpec LaidOut(scene::SceneSpec scene, const LayoutChoice& choice,
                         const std::function<LayoutRegion()>& region) {
  if (!choice.seed) return scene;
  return RandomLayout(std::move(scene), *choice.seed, choice.level, region());
}

}  // namespace smile::layout
