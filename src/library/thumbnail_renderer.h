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

/// Thumbnail renderer: renders small pictures of scenes and recordings, with all objects from near
/// and without the robot. Must be used and destroyed in one thread.
class ThumbnailRenderer {
 public:
  static constexpr int kWidth = 320, kHeight = 240;  ///< [pixels]

  /// Returns the start of a scene as a PNG file.
  /// @throws InputError if the scene is invalid; std::runtime_error if rendering is unavailable.
  std::string RenderScene(const std::filesystem::path& file,
                          const scene_xml::SceneReaderOptions& reader);
  /// Returns the end of a recording, or of one of its segments, as a PNG file; nullopt if the
  /// recording has no such segment.
  /// @param stamp  state of its files; the recording is read again when the stamp differs.
  /// @throws as RenderScene().
  std::optional<std::string> RenderRecording(const std::filesystem::path& directory,
                                             const std::string& stamp,
                                             std::optional<std::size_t> segment);
  /// Returns the end of a recording through the robot's eye as a PNG file; without a robot, as
  /// RenderRecording() does.
  std::optional<std::string> RenderEye(const std::filesystem::path& directory,
                                       const std::string& stamp);

 private:
  /// The recording that was read last: its other segments are usually requested next.
  struct CachedRecording {
    std::filesystem::path directory;
    std::string stamp;
    Playback playback;
    std::vector<recording::Segment> segments;
  };

  /// Opens a recording, unless it is the last one.
  void Open(const std::filesystem::path& directory, const std::string& stamp);
  /// Returns the renderer, made in the worker thread, to which its OpenGL context belongs.
  camera::Renderer& renderer();
  std::string Render(const model::Model& model, const scene::VisualState& state);

  std::unique_ptr<camera::Renderer> renderer_;  ///< nullptr before the first use
  std::unique_ptr<CachedRecording> cached_;
};

}  // namespace smile::library
