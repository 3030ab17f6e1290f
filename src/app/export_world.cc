#include "app/export_world.h"

#include <cmath>
#include <cstdio>
#include <memory>

#include "app/exit_code.h"
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

int ExportWorld(const std::string& scene, const std::string& format, const std::string& out,
                const WorldExport& options) {
  const auto model = std::make_shared<const model::Model>(
      scene_xml::LoadScene(scene, options.path.reader()), PlaceRobot(options.robot, options.path));
  sim::RunningModel running(model);
  for (long tick = std::lround(options.after * sim::kTicksPerSecond); tick > 0; --tick) {
    running.Tick();
  }
  for (const std::string& words : WriteWorld(interchange::WorldOf(running), format, out)) {
    std::fprintf(stderr, "left out: %s\n", words.c_str());
  }
  std::printf("%s: %s, %zu objects\n", out.c_str(), format.c_str(), model->objects().size());
  return kDone;
}

}  // namespace smile::app
