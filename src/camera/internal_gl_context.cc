// A context without a window, by EGL: first on a graphics card (platform `device`), then in Mesa
// without a window system (`surfaceless`), which draws in software. libepoxy loads libEGL at run
// time, so the program also starts on machines without it.

#include "camera/internal_gl_context.h"

#include <epoxy/egl.h>
#include <epoxy/gl.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <stdexcept>

namespace smile::camera::internal {
namespace {

[[noreturn]] void Fail(const std::string& call, const std::string& reason) {
  throw std::runtime_error(call + ": " + reason);
}

[[noreturn]] void FailEgl(const char* call) {
  char reason[32];
  std::snprintf(reason, sizeof reason, "EGL error 0x%04x", static_cast<unsigned>(eglGetError()));
  Fail(call, reason);
}

/// Throws unless EGL has a client extension. libepoxy aborts the program if a function is called
/// that the driver lacks.
void RequireClientExtension(const char* name) {
  if (!epoxy_has_egl_extension(EGL_NO_DISPLAY, name)) {
    Fail("eglQueryString", std::string(name) + " is missing");
  }
}

/// True if a list of words separated by blanks contains a word.
bool HasWord(const char* words, const char* word) {
  return words != nullptr &&
         (" " + std::string(words) + " ").find(" " + std::string(word) + " ") != std::string::npos;
}

/// Returns Mesa's display without window system, which draws in software if necessary.
EGLDisplay SurfacelessDisplay() {
  RequireClientExtension("EGL_MESA_platform_surfaceless");
  // Not eglGetPlatformDisplay: epoxy 1.5.10 cannot resolve it before there is a display.
  return eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
}

/// Returns the display of the first graphics card; software devices are skipped.
EGLDisplay FirstHardwareDisplay() {
  RequireClientExtension("EGL_EXT_platform_device");
  RequireClientExtension("EGL_EXT_device_base");
  std::array<EGLDeviceEXT, 16> devices;
  EGLint num_devices = 0;
  if (!eglQueryDevicesEXT(devices.size(), devices.data(), &num_devices)) {
    FailEgl("eglQueryDevicesEXT");
  }
  for (EGLint k = 0; k < num_devices; ++k) {
    // The software device works, too, but `surfaceless` covers that case with fewer requirements.
    if (HasWord(eglQueryDeviceStringEXT(devices[k], EGL_EXTENSIONS), "EGL_MESA_device_software")) {
      continue;
    }
    return eglGetPlatformDisplayEXT(EGL_PLATFORM_DEVICE_EXT, devices[k], nullptr);
  }
  Fail("eglQueryDevicesEXT", "no graphics card");
}

/// Makes a context and makes it current. The display is shared by the whole process and never
/// terminated; the context belongs to the caller.
EGLContext MakeContext(EGLDisplay display) {
  if (display == EGL_NO_DISPLAY) FailEgl("eglGetPlatformDisplayEXT");
  // eglInitialize() may be called again for a display that is in use; it then only returns the
  // version.
  EGLint major = 0, minor = 0;
  if (!eglInitialize(display, &major, &minor)) FailEgl("eglInitialize");
  // The context draws into framebuffers of its own, so it needs neither a surface nor a pixel
  // format.
  for (const char* needed : {"EGL_KHR_surfaceless_context", "EGL_KHR_no_config_context"}) {
    if (!epoxy_has_egl_extension(display, needed)) {
      Fail("eglInitialize", std::string(needed) + " is missing");
    }
  }
  if (!eglBindAPI(EGL_OPENGL_API)) FailEgl("eglBindAPI");
  const EGLint attributes[] = {EGL_CONTEXT_MAJOR_VERSION,
                               3,
                               EGL_CONTEXT_MINOR_VERSION,
                               3,
                               EGL_CONTEXT_OPENGL_PROFILE_MASK,
                               EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                               EGL_NONE};
  const EGLContext context =
      eglCreateContext(display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, attributes);
  if (context == EGL_NO_CONTEXT) FailEgl("eglCreateContext");
  if (!eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context)) {
    // Read before the next call, which resets it.
    const EGLint error = eglGetError();
    eglDestroyContext(display, context);
    Fail("eglMakeCurrent", "EGL error " + std::to_string(error));
  }
  return context;
}

struct Platform {
  const char* name;
  EGLDisplay (*find_display)();
};

constexpr Platform kPlatforms[] = {{"device", &FirstHardwareDisplay},
                                   {"surfaceless", &SurfacelessDisplay}};

}  // namespace

GlContext::GlContext() {
  if (!epoxy_has_egl()) Fail("EGL", "libEGL.so.1 is not installed (Debian: libegl1)");
  const char* wanted = std::getenv("SMILE_EGL_PLATFORM");
  std::string reasons;
  // Tries hardware first; the error names the reason of each attempt.
  for (const Platform& platform : kPlatforms) {
    if (wanted != nullptr && std::strcmp(wanted, platform.name) != 0) continue;
    try {
      display_ = platform.find_display();
      context_ = MakeContext(display_);
      return;
    } catch (const std::runtime_error& error) {
      reasons += std::string("\n  ") + platform.name + ": " + error.what();
    }
  }
  if (reasons.empty()) {
    Fail("SMILE_EGL_PLATFORM",
         "is \"" + std::string(wanted) + "\", expected device or surfaceless");
  }
  Fail("OpenGL 3.3", "cannot render without a screen:" + reasons);
}

GlContext::~GlContext() {
  if (eglGetCurrentContext() == context_) {
    eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
  }
  eglDestroyContext(display_, context_);
  // Releases EGL's state of this thread; another context of the thread is made current again before
  // it draws.
  eglReleaseThread();
}

void GlContext::MakeCurrent() {
  if (eglGetCurrentContext() == context_) return;
  if (!eglBindAPI(EGL_OPENGL_API)) FailEgl("eglBindAPI");
  if (!eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_)) {
    FailEgl("eglMakeCurrent");
  }
}

std::string GlContext::renderer_name() const {
  const GLubyte* name = glGetString(GL_RENDERER);
  return name == nullptr ? "unknown" : reinterpret_cast<const char*>(name);
}

}  // namespace smile::camera::internal
