#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "camera/renderer.h"
#include "record/trace.h"
#include "sim/eye.h"
#include "sim/simulation.h"

namespace smile::app {

/// What of a picture is wanted.
struct Channels {
  bool rgb = true, depth = false, id = false;
};

/// `rgb,depth,id` or some of them.
/// @throws std::invalid_argument saying what was found and expected.
Channels ParseChannels(const std::string& text);

/// How something is to be seen.
struct Shot {
  std::string camera = "nice";  ///< see FindView()
  sim::EyeSpec size{.width_px = 1280, .height_px = 720};
  Channels channels;
};

/// Takes pictures of recorded moments from anywhere, without physics. What the robot's eye saw, it
/// sees to the last bit.
class Photographer {
 public:
  /// @param stage  a simulation of the recording's scene and robot that need not run. Must outlive
  ///               this.
  /// @throws std::invalid_argument if there is no such camera.
  Photographer(const sim::Simulation& stage, Shot shot);

  /// The picture lasts until the next one.
  const Image& Take(const record::TraceTick& moment);

 private:
  const sim::Simulation& stage_;
  Shot shot_;
  std::optional<CameraView> fixed_view_;  ///< nullopt: the eye's
  camera::Renderer renderer_;
  Image image_;
};

/// Writes the channels of a picture beside one another: for `um.png`, `um.depth.png` and
/// `um.id.png`.
/// @returns what was written, color first.
std::vector<std::filesystem::path> WriteChannels(const std::filesystem::path& png,
                                                 const Image& image, const Channels& channels);

}  // namespace smile::app
