#pragma once

#include <string>

namespace smile::camera::internal {

/// OpenGL 3.3 core context without window or screen, current on the thread that makes it.
///
/// Uses the first graphics card, otherwise Mesa's software renderer. The environment variable
/// SMILE_EGL_PLATFORM = `device` or `surfaceless` allows only one of them.
class GlContext {
 public:
  /// @throws std::runtime_error with the EGL call and its reason for each attempt.
  GlContext();
  ~GlContext();
  GlContext(const GlContext&) = delete;
  GlContext& operator=(const GlContext&) = delete;

  /// Makes the context current; several contexts may alternate on one thread.
  void MakeCurrent();
  /// Returns the name of the renderer, for example `llvmpipe (LLVM 15.0.6, 256 bits)`.
  std::string renderer_name() const;

 private:
  void* display_ = nullptr;  // an EGLDisplay, an EGLContext
  void* context_ = nullptr;
};

}  // namespace smile::camera::internal
