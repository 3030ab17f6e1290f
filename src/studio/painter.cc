#include "studio/painter.h"

#include "image/png.h"
#include "picture/viewpoint.h"
#include "record/time_range.h"
#include "sim/eye.h"

namespace smile::studio {

std::string Painter::PaintScene(const std::filesystem::path& file,
                                const scene_xml::SceneReaderOptions& reader) {
  const sim::Simulation stage(scene_xml::LoadScene(file, reader));
  return Paint(stage, stage.visual_model(), stage.visual_state());
}

std::optional<std::string> Painter::PaintRecording(const std::filesystem::path& directory,
                                                   const std::string& stamp,
                                                   std::optional<std::size_t> segment) {
  if (!exhibit_ || exhibit_->directory != directory || exhibit_->stamp != stamp) {
    exhibit_ = std::unique_ptr<Exhibit>(new Exhibit{.directory = directory,
                                                    .stamp = stamp,
                                                    .playback = Playback("", directory),
                                                    .segments = {}});
    const record::Recording& recording = exhibit_->playback.recording();
    exhibit_->segments = SegmentsOf(recording, record::HistoryOf(recording));
  }
  Playback& playback = exhibit_->playback;
  if (segment && *segment >= exhibit_->segments.size()) return std::nullopt;
  playback.Seek(segment ? SecondsInto(playback.recording(), exhibit_->segments[*segment].end)
                        : playback.length());
  const View view = playback.view();
  return Paint(playback.stage(), *view.model, view.state);
}

std::string Painter::Paint(const sim::Simulation& stage, const scene::VisualModel& model,
                           const scene::VisualState& state) {
  if (!renderer_) renderer_ = std::make_unique<camera::Renderer>();
  const CameraView view = picture::FindView(
      "close", stage.scene(), sim::EyeSpec{.width_px = kWidth, .height_px = kHeight}, {});
  camera::RenderOptions options{.look = camera::Look::kPresentation};
  const int first_robot_frame = stage.first_robot_frame();
  for (int frame = first_robot_frame; first_robot_frame > 0 && frame < model.num_frames; ++frame) {
    options.excluded_frames.push_back(frame);
  }
  return EncodePng(renderer_->Render(model, state, view, options));
}

}  // namespace smile::studio
