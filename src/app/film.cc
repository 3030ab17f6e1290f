#include "app/film.h"

#include <numeric>

#include "app/interrupt.h"
#include "app/progress.h"
#include "app/viewpoint.h"
#include "camera/renderer.h"
#include "dataset/video_writer.h"
#include "robot/robot_visuals.h"

namespace smile::app {

std::vector<int> HiddenFrames(const record::TraceTick& moment, const sim::Simulation& simulation,
                              bool is_eye) {
  if (simulation.robot() == nullptr) return {};
  if (moment.is_robot_shown) {
    return is_eye ? sim::FramesHiddenFromEye(simulation) : std::vector<int>();
  }
  std::vector<int> frames(robot::NumVisualFrames(simulation.robot()->model()));
  std::iota(frames.begin(), frames.end(), simulation.first_robot_frame());
  return frames;
}

scene::VisualState VisualStateAt(const record::TraceTick& moment,
                                 const sim::Simulation& simulation) {
  scene::VisualState state;
  std::vector<bool> is_present;
  for (const record::TracePose& object : moment.objects) {
    state.poses.push_back(object.pose_in_world());
    is_present.push_back(object.is_present);
  }
  state.looks = simulation.tabletop().LooksAt(moment.controls, is_present);
  if (const robot::RobotBody* robot = simulation.robot()) {
    const auto robot_poses = robot::FramePosesOf(robot->model(), robot->base_pose(), moment.joints);
    state.poses.insert(state.poses.end(), robot_poses.begin(), robot_poses.end());
  }
  return state;
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
    renderer.Render(simulation.visual_model(), VisualStateAt(*moment, simulation),
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
