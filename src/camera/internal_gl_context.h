#pragma once

#include <string>

namespace smile::camera::internal {

/// An OpenGL 3.3 core context without window or screen, current on the thread that makes it.
///
/// Takes the first graphics card there is, else Mesa's software renderer. The environment variable
/// SMILE_EGL_PLATFORM = `device` or `surfaceless` allows only the one or the other.
class GlContext {
 public:
  /// @throws std::runtime_error naming for each way tried the EGL call and its reason.
  GlContext();
  ~GlContext();
  GlContext(const GlContext&) = delete;
  GlContext& operator=(const GlContext&) = delete;

  /// Several contexts may take turns on one thread.
  void MakeCurrent();
  /// What draws, for example `llvmpipe (LLVM 15.0.6, 256 bits)`.
  std::string renderer_name() const;

 private:
  void* display_ = nullptr;  // an EGLDisplay, an EGLContext
  void* context_ = nullptr;
};

}  // namespace smile::camera::internal
