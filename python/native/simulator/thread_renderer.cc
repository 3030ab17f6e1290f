#include "thread_renderer.h"

namespace smile::python {

camera::Renderer& RendererOfThread() {
  thread_local camera::Renderer renderer;
  return renderer;
}

}  // namespace smile::python
