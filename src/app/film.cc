#include "app/film.h"

#include "app/interrupt.h"
#include "app/progress.h"
#include "app/viewpoint.h"
#include "camera/renderer.h"
#include "dataset/video_writer.h"
#include "record/sight.h"
#include "record/trace_reader.h"

namespace smile::app {

std::vector<int> HiddenFrames(const record::TraceTick& moment, const sim::Simulation& simulation,
                              bool is_eye) {
  if (!is_eye && moment.is_robot_shown) return {};
  return sim::FramesHiddenFromEye(simulation, moment.is_robot_shown);
}

void Film(const record::Recording& recording, const std::filesystem::path& mp4,
          const FilmOptions& options) {
  const sim::Simulation simulation(recording.scene, recording.robot);
  const bool is_eye = options.camera == "eye";
  camera::Renderer renderer;
  dataset::VideoWriter video(mp4, options.size.width_px, options.size.height_px,
                             options.frames_per_second);
  record::TraceReader trace(recording);
  ProgressLine progress(options.progress);
  Image image;
  while (const auto moment = trace.Next()) {
    if (IsInterrupted()) break;
    const double seconds = static_cast<double>(moment->tick) / sim::kTicksPerSecond;
    const double due = video.num_frames() * options.speed / options.frames_per_second;
    if (seconds + 1e-9 < due) continue;
    renderer.Render(simulation.visual_model(), record::VisualStateAt(*moment, simulation),
                    FindView(options.camera, simulation, moment->joints, options.size),
                    {.look = is_eye ? camera::Look::kRobotEye : camera::Look::kPresentation,
                     .excluded_frames = HiddenFrames(*moment, simulation, is_eye)},
                    &image);
    // A rate above the ticks' shows a moment more than once.
    while (video.num_frames() * options.speed / options.frames_per_second <= seconds + 1e-9 &&
           !IsInterrupted()) {
      video.Add(image);
    }
    progress.Show(seconds, 0);
  }
  video.Finish();
}

std::optional<record::TraceTick> LastMoment(const record::Recording& recording) {
  record::TraceReader trace(recording);
  std::optional<record::TraceTick> last;
  while (auto moment = trace.Next()) last = std::move(moment);
  return last;
}

}  // namespace smile::app
