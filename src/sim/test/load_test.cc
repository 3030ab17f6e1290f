// From one scene into another, and back.

#include <filesystem>

#include "base/diagnostic.h"
#include "scene_xml/scene_writer.h"
#include "sim/command_json.h"
#include "sim/script.h"
#include "simulation_fixture.h"

namespace smile::sim {
namespace {

Load LoadOf(scene::SceneSpec scene) {
  return {std::make_shared<const scene::SceneSpec>(std::move(scene))};
}

class LoadTest : public SimulationFixture {
 protected:
  static scene::SceneSpec OtherScene() {
    return {.name = "other", .objects = {BlockAt("a", {0.2, 0, 0.5}), BlockAt("x", {0, 0, 0.05})}};
  }
};

TEST_F(LoadTest, ALoadedSceneRunsLikeAFirstScene) {
  const auto simulation = MakeSimulation({BlockAt("a", {0, 0, 0.05})}, /*with_robot=*/true);
  ASSERT_EQ(simulation->Apply(Grasp{.hand = HandName::kLeft, .object = "a"}), std::nullopt);
  ASSERT_EQ(simulation->Apply(JointVelocities{.arms = {{"left", {0.3, 0, 0, 0, 0, 0, 0}}}}),
            std::nullopt);
  TickSeconds(*simulation, 0.3);
  ASSERT_EQ(simulation->Apply(LoadOf(OtherScene())), std::nullopt);
  Simulation fresh(OtherScene(), RobotPlacement{.model = Baxter()});
  EXPECT_EQ(simulation->tick(), 0u);
  EXPECT_EQ(simulation->state_hash(), fresh.state_hash());
  for (Simulation* one : {simulation.get(), &fresh}) {
    ASSERT_EQ(one->Apply(Grasp{.hand = HandName::kAny, .object = "x"}), std::nullopt);
    TickSeconds(*one, 0.5);
  }
  EXPECT_EQ(simulation->state_hash(), fresh.state_hash());
  EXPECT_EQ(simulation->history().CommandsDone(), fresh.history().CommandsDone());
  EXPECT_EQ(simulation->start_model()->scene(), OtherScene());
}

TEST_F(LoadTest, UndoLeadsBackIntoTheSceneThatWasLeftAndRedoIntoTheOther) {
  const auto simulation = MakeSimulation({BlockAt("a", {0, 0, 0.4})}, /*with_robot=*/true);
  const auto twin = MakeSimulation({BlockAt("a", {0, 0, 0.4})}, /*with_robot=*/true);
  for (Simulation* one : {simulation.get(), twin.get()}) {
    TickSeconds(*one, 0.1);
    ASSERT_EQ(one->Apply(JointVelocities{.arms = {{"right", {0.3, 0, 0, 0, 0, 0, 0}}}}),
              std::nullopt);
    TickSeconds(*one, 0.1);  // the block falls
  }
  ASSERT_EQ(simulation->Apply(LoadOf(OtherScene())), std::nullopt);
  EXPECT_EQ(WordsOf(*simulation->history().current().summary), "loaded other");
  TickSeconds(*simulation, 0.2);
  const std::uint64_t in_other = simulation->state_hash();
  ASSERT_EQ(simulation->Apply(Undo()), std::nullopt);
  EXPECT_EQ(simulation->state_hash(), twin->state_hash());
  EXPECT_EQ(simulation->scene().name, "test");
  ASSERT_EQ(simulation->Apply(Redo()), std::nullopt);
  EXPECT_EQ(simulation->state_hash(), in_other);
  ASSERT_EQ(simulation->Apply(Undo()), std::nullopt);
  for (Simulation* one : {simulation.get(), twin.get()}) TickSeconds(*one, 1);
  EXPECT_EQ(simulation->state_hash(), twin->state_hash());
  EXPECT_EQ(simulation->history().CommandsDone(), twin->history().CommandsDone());
}

TEST_F(LoadTest, AHistoryIsCompleteFromALoadOn) {
  const auto simulation = MakeSimulation({BlockAt("a", {0, 0, 0.05})}, /*with_robot=*/false);
  simulation->Restore(simulation->Save());
  EXPECT_FALSE(simulation->history().is_complete());
  ASSERT_EQ(simulation->Apply(LoadOf(OtherScene())), std::nullopt);
  EXPECT_TRUE(simulation->history().is_complete());
  ASSERT_EQ(simulation->Apply(Undo()), std::nullopt);
  EXPECT_FALSE(simulation->history().is_complete());
}

TEST_F(LoadTest, AScriptNamesAFileOrHasTheScene) {
  const std::filesystem::path folder =
      std::filesystem::temp_directory_path() / ("smile_load_" + std::to_string(getpid()));
  std::filesystem::create_directories(folder);
  WriteFile(folder / "other.xml", scene_xml::WriteScene(OtherScene()));
  scene::SceneSpec inches = OtherScene();
  inches.meters_per_unit = 0.0254;
  WriteFile(folder / "inches.xml", scene_xml::WriteScene(inches));
  const auto read = [&](const std::string& text) -> std::string {
    WriteFile(folder / "script.jsonl", text);
    try {
      const auto simulation = MakeSimulation({BlockAt("a", {0, 0, 0.05})}, false);
      ScriptPlayer player(ReadScript(folder / "script.jsonl", 0.1));
      player.Advance(simulation.get());
      return simulation->scene().name + (simulation->tabletop().Find("x") != nullptr ? " x" : "");
    } catch (const InputError& error) {
      return error.diagnostics().front().message;
    }
  };
  EXPECT_EQ(read(R"({"do": "load", "file": "other.xml"})"), "other x");
  EXPECT_EQ(read(ToJson(Command(LoadOf(OtherScene())), 0.1).dump()), "scene x");
  EXPECT_EQ(read(R"({"do": "load", "file": "inches.xml"})"),
            "the scene to load has 0.0254 meters per unit, expected those of the script's scene, "
            "0.1");
  EXPECT_EQ(read(R"({"do": "load", "xml": "<block/>"})").substr(0, 35),
            "\"xml\" is not a scene: scene:1: <blo");
  EXPECT_EQ(read(R"({"do": "load", "file": "../other.xml"})").substr(0, 41),
            "\"file\" is \"../other.xml\", expected a file");
  std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace smile::sim
