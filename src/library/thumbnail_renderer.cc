#include "library/thumbnail_renderer.h"

#include "image/png.h"
#include "model/eye.h"
#include "picture/rendered_eye.h"
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
  Open(directory, stamp);
  if (cached_->segments.empty()) {
    cached_->segments = OnPath(recording::HistoryOf(cached_->playback.recording()));
  }
  Playback& playback = cached_->playback;
  if (segment && *segment >= cached_->segments.size()) return std::nullopt;
  playback.Seek(segment ? SecondsInto(playback.recording(), cached_->segments[*segment].end.tick)
                        : playback.length());
  return Render(playback.model(), playback.view().state);
}

std::optional<std::string> ThumbnailRenderer::RenderEye(const std::filesystem::path& directory,
                                                        const std::string& stamp) {
  Open(directory, stamp);
  Playback& playback = cached_->playback;
  if (!playback.recording().robot()) return RenderRecording(directory, stamp, std::nullopt);
  playback.Seek(playback.length());
  const model::EyeSpec spec{
      .width_px = kWidth, .height_px = kHeight, .camera = playback.recording().info.eye_camera};
  picture::RenderedEye eye(spec, [this]() -> camera::Renderer& { return renderer(); });
  const model::Model& model = playback.model();
  return EncodePng(
      eye.Draw(model.visual_model(), recording::ViewSampleAt(playback.moment(), model, spec)));
}

void ThumbnailRenderer::Open(const std::filesystem::path& directory, const std::string& stamp) {
  // A page requests the pictures of all segments of one recording in a row.
  if (cached_ && cached_->directory == directory && cached_->stamp == stamp) return;
  cached_ = std::unique_ptr<CachedRecording>(new CachedRecording{
      .directory = directory, .stamp = stamp, .playback = Playback("", directory), .segments = {}});
}

camera::Renderer& ThumbnailRenderer::renderer() {
  if (!renderer_) renderer_ = std::make_unique<camera::Renderer>();
  return *renderer_;
}

std::string ThumbnailRenderer::Render(const model::Model& model, const scene::VisualState& state) {
  // Frames the objects from near. The robot is left out: it would hide small scenes or shrink them.
  const CameraView view = picture::FindView(
      "close", model.scene(), model::EyeSpec{.width_px = kWidth, .height_px = kHeight}, {});
  camera::RenderOptions options{.style = camera::RenderStyle::kPresentation};
  for (model::FrameIndex frame : model.robot_frames()) {
    options.excluded_frames.push_back(static_cast<int>(frame));
  }
  return EncodePng(renderer().Render(model.visual_model(), state, view, options));
}

}  // namespace smile::library
