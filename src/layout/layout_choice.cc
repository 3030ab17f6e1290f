#include "layout/layout_choice.h"

#include <utility>

#include "layout/layout.h"

namespace smile::layout {

scene::SceneSpec LaidOut(scene::SceneSpec scene, const LayoutChoice& choice,
                         const std::function<LayoutRegion(double object_height)>& region) {
  if (!choice.seed) return scene;
  const LayoutRegion place = region(HeightOfLooseObjects(scene));
  return RandomLayout(std::move(scene), *choice.seed, choice.level, place);
}

}  // namespace smile::layout
