#include "picture/recording_renderer.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "base/files.h"
#include "robot/urdf_reader.h"
#include "scene_xml/scene_reader.h"

namespace smile::picture {
namespace {

/// Pixels that show one of the scene's objects: their ids follow those of background and table.
std::ptrdiff_t NumObjectPixels(const sim::Simulation& simulation, const RenderRequest& request) {
  const std::size_t num_objects = simulation.scene().objects.size();
  RecordingRenderer renderer(simulation.model(), request);
  return std::ranges::count_if(renderer.Take(recording::Observe(simulation)).ids,
                               [&](auto id) { return id >= 2 && id < 2 + num_objects; });
}

TEST(RecordingRenderer, TheRobotDoesNotHideWhatIsClose) {
  constexpr double kHidden = 0.15;  // at most, of all pixels of objects
  const robot::RobotReading baxter = robot::LoadRobot(DataFile("robots/baxter.urdf"));
  const RenderRequest request{
      .camera = "close", .width_px = 160, .height_px = 100, .channels = {.rgb = false, .id = true}};
  for (const char* name : {"um_robot", "row_robot", "box_robot", "tower"}) {
    const scene::SceneSpec scene =
        scene_xml::LoadScene(DataFile(std::string("scenes/") + name + ".xml"));
    const auto without = static_cast<double>(NumObjectPixels(sim::Simulation(scene), request));
    const sim::Simulation with_robot(
        scene, sim::RobotPlacement{
                   .model = baxter.model, .gripper = baxter.gripper, .files = baxter.files});
    ASSERT_GT(without, 500) << name;
    EXPECT_GT(static_cast<double>(NumObjectPixels(with_robot, request)), (1 - kHidden) * without)
        << name;
  }
}

}  // namespace
}  // namespace smile::picture
