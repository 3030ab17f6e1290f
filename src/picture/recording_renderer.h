#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "camera/renderer.h"
#include "model/eye.h"
#include "picture/seen_demonstrator.h"
#include "recording/trace.h"

namespace smile::picture {

using model::Channels;

/// Parses `rgb,depth,id` or some of them.
/// @throws std::invalid_argument saying what was found and expected.
Channels ParseChannels(const std::string& text);

/// Request for a picture: camera, size and channels.
struct RenderRequest {
  std::string camera = "nice";          ///< one of model::CameraNames(), or see FindView()
  std::string eye = model::kEyeCamera;  ///< camera for the name `eye`: that of the recording
  int width_px = 1280, height_px = 720;
  Channels channels;
};

/// Renderer of recorded ticks from any viewpoint, without physics. Pictures of the robot's cameras
/// are bit-identical to the recorded ones; the scene's cameras use the same style.
class RecordingRenderer {
 public:
  /// @param model         of the recording's scene and robot. Must outlive this.
  /// @param demonstrator  visible demonstrator; nullptr for none. Must outlive this.
  /// @throws std::invalid_argument if the camera does not exist.
  RecordingRenderer(const model::Model& model, RenderRequest request,
                    const SeenDemonstrator* demonstrator = nullptr);

  /// @param markers  points that views for people show as translucent balls [m].
  /// The picture lasts until the next one.
  const Image& Take(const recording::TraceTick& moment, const std::vector<Vector3>& markers = {});

 private:
  /// Returns the model of everything opaque.
  const scene::VisualModel& opaque_model() const;
  void Render(const scene::VisualModel& model, const model::ViewSample& sample,
              const Channels& channels, Image* image);
  void AddGhost(model::ViewSample sample, std::uint64_t tick);
  void AddMarkers(const model::ViewSample& sample, const std::vector<Vector3>& markers);
  /// Blends another model into the picture, half transparent. Depth and ids do not contain it.
  void Mix(const scene::VisualModel& model, const model::ViewSample& sample);

  const model::Model& model_;
  const SeenDemonstrator* demonstrator_;
  RenderRequest request_;
  model::EyeSpec eye_;
  std::optional<CameraView> view_for_people_;  ///< nullopt: the eye's
  camera::Renderer renderer_;
  Image image_, mixed_image_;
};

/// Writes the channels of a picture beside one another: for `um.png`, `um.depth.png` and
/// `um.id.png`.
/// @returns the files, color first.
std::vector<std::filesystem::path> WriteChannels(const std::filesystem::path& png,
                                                 const Image& image, const Channels& channels);

}  // namespace smile::picture
