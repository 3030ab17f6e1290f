#include "app/export_world.h"

#include <cmath>
#include <cstdio>
#include <memory>
#include <stdexcept>

#include "app/exit_code.h"
#include "app/open_recording.h"
#include "base/wording.h"
#include "interchange/world_formats.h"
#include "scene_xml/scene_reader.h"
#include "sim/running_model.h"

namespace smile::app {

void AddWorldExportOptions(CLI::App* command, WorldExport* options) {
  CLI::Option_group* group = command->add_option_group("Other simulators");
  AddPathOption(group, &options->path);
  AddRobotOptions(group, /*may_be_absent=*/true, &options->robot);
  group
      ->add_option("--after", options->after,
                   "seconds of simulated time between the start of the scene and what is exported; "
                   "strings come down then")
      ->capture_default_str()
      ->check(NumberBetween(0, 3600));
}

namespace {

interchange::ExportedScene SceneOfFile(const std::string& scene, const WorldExport& options) {
  sim::RunningModel running(std::make_shared<const model::Model>(
      scene_xml::LoadScene(scene, options.path.reader()), PlaceRobot(options.robot, options.path)));
  for (long tick = std::lround(options.after * sim::kTicksPerSecond); tick > 0; --tick) {
    running.Tick();
  }
  return interchange::SceneOf(running);
}

interchange::ExportedScene SceneOfRecording(const std::string& demo, const std::string& format,
                                            const WorldExport& options,
                                            const recording::TimeRange& range, double rate) {
  if (!interchange::IsAnimated(format)) {
    throw std::invalid_argument(format + " is of a scene file, found the recording " +
                                Quoted(demo));
  }
  if (options != WorldExport()) {
    throw std::invalid_argument(
        "--after, --path and options of the robot are for scene files, found the recording " +
        Quoted(demo));
  }
  return interchange::SceneOf(OpenAndReport(demo), range, rate);
}

}  // namespace

int ExportWorld(const std::string& source, const std::string& format, const std::string& out,
                const WorldExport& options, const recording::TimeRange& range, double rate) {
  RequireOutsideOfRecordings(out);
  const interchange::ExportedScene scene =
      recording::IsRecording(source) ? SceneOfRecording(source, format, options, range, rate)
                                     : SceneOfFile(source, options);
  for (const std::string& words : WriteScene(scene, format, out)) {
    std::fprintf(stderr, "left out: %s\n", words.c_str());
  }
  std::printf("%s: %s, %zu bodies, %.2f s\n", out.c_str(), format.c_str(),
              scene.world.bodies.size(), scene.motion.seconds.back());
  return kDone;
}

}  // namespace smile::app
