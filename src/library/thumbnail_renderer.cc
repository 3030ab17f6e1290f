#include "library/thumbnail_renderer.h"

#include "image/png.h"
#include "model/eye.h"
#include "picture/viewpoint.h"
#include "recording/time_range.h"
#include "recording/view_sample.h"

namespace smile::library {

std::string ThumbnailRenderer::RenderScene(const std::filesystem::path& file,
                                           const scene_xml::SceneReaderOptions& reader) {
  const model::Model model(scene_xml::LoadScene(file, reader));
  // The objects as the file places them, without a simulation.
  return Render(model, recording::VisualStateAt(recording::StartOf(model), model));
}

std::optional<std::string> ThumbnailRenderer::RenderRecording(
    const std::filesystem::path& directory, const std::string& stamp,
    std::optional<std::size_t> segment) {
  // A page requests the pictures of all segments of one recording in a row.
  if (!cached_ || cached_->directory != directory || cached_->stamp != stamp) {
    cached_ =
        std::unique_ptr<CachedRecording>(new CachedRecording{.directory = directory,
                                                             .stamp = stamp,
                                                             .playback = Playback("", directory),
                                                             .segments = {}});
    const recording::Recording& recording = cached_->playback.recording();
    cached_->segments = OnPath(recording::HistoryOf(recording));
  }
  Playback& playback = cached_->playback;
  if (segment && *segment >= cached_->segments.size()) return std::nullopt;
  playback.Seek(segment ? SecondsInto(playback.recording(), cached_->segments[*segment].end.tick)
                        : playback.length());
  return Render(playback.model(), playback.view().state);
}

std::string ThumbnailRenderer::Render(const model::Model& model, const scene::VisualState& state) {
  // Made in the worker thread, to which its OpenGL context belongs.
  if (!renderer_) renderer_ = std::make_unique<camera::Renderer>();
  // Frames the objects from near. The robot is left out: it would hide small scenes or shrink them.
  const CameraView view = picture::FindView(
      "close", model.scene(), model::EyeSpec{.width_px = kWidth, .height_px = kHeight}, {});
  camera::RenderOptions options{.style = camera::RenderStyle::kPresentation};
  for (model::FrameIndex frame : model.robot_frames()) {
    options.excluded_frames.push_back(static_cast<int>(frame));
  }
  return EncodePng(renderer_->Render(model.visual_model(), state, view, options));
}

}  // namespace smile::library
