#include "picture/photographer.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "base/files.h"
#include "robot/urdf_reader.h"
#include "scene_xml/scene_reader.h"

namespace smile::picture {
namespace {

/// Pixels that show one of the scene's objects: their ids follow those of background and table.
std::ptrdiff_t NumObjectPixels(const sim::Simulation& simulation, const Shot& shot) {
  const std::size_t num_objects = simulation.scene().objects.size();
  Photographer photographer(simulation.model(), shot);
  return std::ranges::count_if(photographer.Take(recording::Observe(simulation)).ids,
                               [&](auto id) { return id >= 2 && id < 2 + num_objects; });
}

TEST(Photographer, TheRobotDoesNotHideWhatIsClose) {
  constexpr double kHidden = 0.15;  // at most, of all pixels of objects
  const robot::RobotReading baxter = robot::LoadRobot(DataFile("robots/baxter.urdf"));
  const Shot shot{
      .camera = "close", .width_px = 160, .height_px = 100, .channels = {.rgb = false, .id = true}};
  for (const char* name : {"um_robot", "row_robot", "box_robot", "tower"}) {
    const scene::SceneSpec scene =
        scene_xml::LoadScene(DataFile(std::string("scenes/") + name + ".xml"));
    const auto without = static_cast<double>(NumObjectPixels(sim::Simulation(scene), shot));
    const sim::Simulation with_robot(
        scene, sim::RobotPlacement{
                   .model = baxter.model, .gripper = baxter.gripper, .files = baxter.files});
    ASSERT_GT(without, 500) << name;
    EXPECT_GT(static_cast<double>(NumObjectPixels(with_robot, shot)), (1 - kHidden) * without)
        << name;
  }
}

}  // namespace
}  // namespace smile::picture
