#pragma once

#include "camera/renderer.h"

namespace smile::python {

/// Returns the renderer of this thread: an OpenGL context belongs to the thread that made it, but
/// any thread of Python may use a simulation.
camera::Renderer& RendererOfThread();

}  // namespace smile::python
