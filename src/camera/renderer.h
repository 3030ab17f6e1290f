#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "image/image.h"
#include "math/camera_projection.h"
#include "math/color.h"
#include "scene/visual_model.h"

namespace smile::camera {

/// Lighting of a picture.
enum class RenderStyle {
  /// For computer vision: black background, no shadows, no gloss. Each face of a block has one
  /// color: that of the scene file on top, darker with the same hue at the sides.
  kRobotEye,
  /// For people: light background, soft shadows, gloss, smooth edges.
  kPresentation,
};

/// Content of a picture.
struct RenderOptions {
  bool color = true;
  bool depth = false;
  bool ids = false;
  RenderStyle style = RenderStyle::kRobotEye;
  std::optional<Color> background;   ///< in place of that of the style
  std::vector<int> excluded_frames;  ///< nothing fixed to these is drawn or casts a shadow
};

/// Renderer of a scene without window or screen: a simulated camera.
///
/// Depth and ids belong to the center of their pixel, in either style; ids are never mixed. The
/// same input gives the same bytes on one machine, in any renderer and process; graphics cards
/// differ among themselves by rounding.
///
/// Uses the graphics card if there is one, otherwise software; the environment variable
/// SMILE_EGL_PLATFORM = `device` or `surfaceless` allows only one of them. Belongs to the thread
/// that made it: that thread makes all calls and destroys it.
class Renderer {
 public:
  /// @throws std::runtime_error with the call and the reason if nothing can draw here.
  Renderer();
  ~Renderer();
  Renderer(const Renderer&) = delete;
  Renderer& operator=(const Renderer&) = delete;

  /// @param state  of the model: one pose for each of its frames, one variant for each of its
  /// choices.
  /// @throws std::invalid_argument if poses or variants are not that many, a frame or choice does
  /// not
  ///         exist, or the camera is impossible (see CameraIntrinsics; sizes are 1 to 8192).
  /// @throws std::runtime_error if the graphics card fails, for example because memory is
  ///         exhausted.
  Image Render(const scene::VisualModel& model, const scene::VisualState& state,
               const CameraView& view, const RenderOptions& options = {});

  /// Renders into an image of the caller, whose memory is reused.
  void Render(const scene::VisualModel& model, const scene::VisualState& state,
              const CameraView& view, const RenderOptions& options, Image* image);

  /// Returns the name of the renderer, for example `llvmpipe (LLVM 15.0.6, 256 bits)`.
  std::string device_name() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace smile::camera
