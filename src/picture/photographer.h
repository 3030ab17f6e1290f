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

/// `rgb,depth,id` or some of them.
/// @throws std::invalid_argument saying what was found and expected.
Channels ParseChannels(const std::string& text);

/// How something is to be seen.
struct Shot {
  std::string camera = "nice";          ///< one of model::CameraNames(), or see FindView()
  std::string eye = model::kEyeCamera;  ///< which camera is meant by `eye`: a recording has its own
  int width_px = 1280, height_px = 720;
  Channels channels;
};

/// Takes pictures of recorded moments from anywhere, without physics. What the robot's cameras saw,
/// it sees to the last bit; the scene's see as they do.
class Photographer {
 public:
  /// @param model         of the recording's scene and robot. Must outlive this.
  /// @param demonstrator  who is to be seen; nullptr for nobody. Must outlive this.
  /// @throws std::invalid_argument if there is no such camera.
  Photographer(const model::Model& model, Shot shot,
               const SeenDemonstrator* demonstrator = nullptr);

  /// @param markers  points that views for people show as translucent balls [m].
  /// The picture lasts until the next one.
  const Image& Take(const recording::TraceTick& moment, const std::vector<Vector3>& markers = {});

 private:
  /// All that hides what is behind it.
  const scene::VisualModel& opaque_model() const;
  void Render(const scene::VisualModel& model, const model::Sight& sight, const Channels& channels,
              Image* image);
  void AddGhost(model::Sight sight, std::uint64_t tick);
  void AddMarkers(const model::Sight& sight, const std::vector<Vector3>& markers);
  /// Half of what is seen is of another model, half what is behind it. Depth and ids are without.
  void Mix(const scene::VisualModel& model, const model::Sight& sight);

  const model::Model& model_;
  const SeenDemonstrator* demonstrator_;
  Shot shot_;
  model::EyeSpec eye_;
  std::optional<CameraView> view_for_people_;  ///< nullopt: the eye's
  camera::Renderer renderer_;
  Image image_, mixed_image_;
};

/// Writes the channels of a picture beside one another: for `um.png`, `um.depth.png` and
/// `um.id.png`.
/// @returns what was written, color first.
std::vector<std::filesystem::path> WriteChannels(const std::filesystem::path& png,
                                                 const Image& image, const Channels& channels);

}  // namespace smile::picture
