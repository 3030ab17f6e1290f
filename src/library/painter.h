#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "camera/renderer.h"
#include "library/playback.h"
#include "recording/recording_history.h"
#include "scene_xml/scene_reader.h"

namespace smile::library {

/// Small pictures of scenes and recordings for people to choose from: all objects from near,
/// without the robot. Belongs to one thread, which also ends it.
class Painter {
 public:
  static constexpr int kWidth = 320, kHeight = 240;  ///< [pixels]

  /// A PNG, as all below.
  /// @throws InputError if the scene is wrong; std::runtime_error if nothing can draw here. So do
  ///         all below.
  std::string PaintScene(const std::filesystem::path& file,
                         const scene_xml::SceneReaderOptions& reader);
  /// How a recording ends, or one of its segments; nullopt if it has no such segment.
  /// @param stamp  another one tells that it is to be read anew.
  std::optional<std::string> PaintRecording(const std::filesystem::path& directory,
                                            const std::string& stamp,
                                            std::optional<std::size_t> segment);

 private:
  /// What was looked at last: mostly its other segments are wanted next.
  struct Exhibit {
    std::filesystem::path directory;
    std::string stamp;
    Playback playback;
    std::vector<recording::Segment> segments;
  };

  std::string Paint(const model::Model& model, const scene::VisualState& state);

  std::unique_ptr<camera::Renderer> renderer_;  ///< nullptr until it is needed
  std::unique_ptr<Exhibit> exhibit_;
};

}  // namespace smile::library
