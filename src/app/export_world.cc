#include "app/export_world.h"

#include <cstdio>
#include <memory>
#include <stdexcept>

#include "app/exit_code.h"
#include "app/open_recording.h"
#include "base/wording.h"
#include "interchange/world_formats.h"
#include "scene_xml/scene_reader.h"

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

int ExportWorld(const std::string& source, const std::string& format, const std::string& out,
                const WorldExport& options, const recording::TimeRange& range,
                std::optional<double> rate) {
  RequireOutsideOfRecordings(out);
  const bool is_recording = recording::IsRecording(source);
  const char* unused =
      is_recording
          ? "--after, --path and options of the robot are for scene files, found the recording "
          : "--from, --to-time and --rate are for recordings, found the scene file ";
  if (is_recording ? options != WorldExport() : range != recording::TimeRange() || rate) {
    throw std::invalid_argument(unused + Quoted(source));
  }
  if (is_recording) interchange::RequireAnimated(format, source);
  const interchange::ExportedScene scene =
      is_recording
          ? interchange::SceneOf(OpenAndReport(source), range, rate.value_or(sim::kTicksPerSecond))
          : interchange::SceneAfter(options.after,
                                    std::make_shared<const model::Model>(
                                        scene_xml::LoadScene(source, options.path.reader()),
                                        PlaceRobot(options.robot, options.path)));
  for (const std::string& words : WriteScene(scene, format, out)) {
    std::fprintf(stderr, "left out: %s\n", words.c_str());
  }
  std::printf("%s: %s, %zu bodies, %.2f s\n", out.c_str(), format.c_str(),
              scene.world.bodies.size(), scene.motion.seconds.back());
  return kDone;
}

}  // namespace smile::app
