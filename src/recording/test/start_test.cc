// The start of a model is that of a simulation of it.

#include <gtest/gtest.h>

#include <filesystem>

#include "base/files.h"
#include "recording/view_sample.h"
#include "scene_xml/scene_reader.h"
#include "sim/test/everything_scene.h"

namespace smile::recording {
namespace {

void ExpectSameStart(const scene::SceneSpec& scene) {
  const auto model = std::make_shared<const model::Model>(scene);
  const sim::Simulation simulation(model);
  const TraceTick start = StartOf(*model), observed = Observe(simulation);
  EXPECT_EQ(start.controls, observed.controls) << scene.name;
  EXPECT_EQ(start.bonds, observed.bonds) << scene.name;
  ASSERT_EQ(start.objects.size(), observed.objects.size()) << scene.name;
  for (model::ObjectIndex object : model->objects()) {
    const PoseGap gap = GapBetween(start.objects[object], observed.objects[object]);
    EXPECT_LT(gap.size(), 1e-6) << scene.name << ": " << model->id(object);
  }
  EXPECT_EQ(VisualStateAt(start, *model).variants, simulation.visual_state().variants)
      << scene.name;
}

TEST(Start, OfAModelIsThatOfASimulationOfIt) {
  ExpectSameStart(sim::EverythingScene::Make());
  int num_scenes = 0;
  for (const auto& entry : std::filesystem::directory_iterator(DataFile("scenes"))) {
    if (entry.path().extension() != ".xml") continue;
    const scene_xml::SceneReading reading = scene_xml::ReadScene(entry.path());
    if (!reading.scene) continue;  // a template without a table of its own
    ExpectSameStart(*reading.scene);
    ++num_scenes;
  }
  EXPECT_GT(num_scenes, 5);
}

}  // namespace
}  // namespace smile::recording
