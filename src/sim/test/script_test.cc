#include "sim/script.h"

#include <unistd.h>

#include "base/diagnostic.h"
#include "base/wording.h"
#include "scene/units.h"
#include "simulation_fixture.h"

namespace smile::sim {
namespace {

class ScriptTest : public SimulationFixture {
 protected:
  /// Plays to the end; returns the first error.
  std::string Play(std::string_view text) {
    try {
      ScriptPlayer player(ParseScript(text, "demo.jsonl", scene::kMetersPerUnit));
      for (int i = 0; i < 3000; ++i) {
        player.Advance(simulation_.get());
        if (player.is_finished()) return "";
        simulation_->Tick();
      }
    } catch (const InputError& error) {
      return error.what();
    }
    return "it never ended";
  }

  std::unique_ptr<Simulation> simulation_ =
      MakeSimulation({BlockAt("a", {0, 0, 0.05}), BlockAt("b", {0.3, 0, 0.05})}, false);
};

TEST_F(ScriptTest, StacksABlock) {
  EXPECT_EQ(Play(R"(# put a on b
{"hand": "any", "do": "grasp", "object": "a"}
{"hand": "any", "do": "move_to", "position": [0, 0, 3]}
{"do": "wait", "until": "arrived"}

{"hand": "any", "do": "move_to", "position": [3, 0, 3]}
{"do": "wait", "until": "arrived"}
{"hand": "any", "do": "move_to", "position": [3, 0, 1.51]}
{"do": "wait", "until": "arrived"}
{"hand": "any", "do": "release"}
{"do": "wait", "until": "still"}
)"),
            "");
  EXPECT_LT((PositionOf(*simulation_, "a") - Vector3(0.3, 0, 0.15)).norm(), 0.001);
}

TEST_F(ScriptTest, WaitsForSecondsAndTicks) {
  EXPECT_EQ(Play(R"({"do": "wait", "seconds": 0.5}
{"tick": 45, "hand": "any", "do": "grasp", "object": "a"})"),
            "");
  EXPECT_EQ(simulation_->tick(), 45u);
}

TEST_F(ScriptTest, ADragIsTheMoveThatItMeans) {
  struct Ear : Listener {
    void OnCommand(const Simulation&, const Command& command) override { log.push_back(command); }
    std::vector<Command> log;
  } ear;
  simulation_->AddListener(&ear);
  EXPECT_EQ(Play(R"({"hand": "any", "do": "grasp", "object": "a"}
{"hand": "any", "do": "drag", "origin": [1, -5, 2], "direction": [0, 1, 0], "speed": 3})"),
            "");
  ASSERT_EQ(ear.log.size(), 2u);
  EXPECT_EQ(ear.log[1], Command(MoveTo{.p_WH = {0.1, 0, 0.2}, .speed = 0.3}));
}

TEST_F(ScriptTest, ReportsErrorsOfADrag) {
  EXPECT_EQ(
      Play(R"({"hand": "any", "do": "drag", "origin": [1, -5, 2]})"),
      "demo.jsonl:1: \"drag\" lacks \"direction\": direction of the ray, of any length but 0");
  EXPECT_EQ(Play(R"({"hand": "any", "do": "drag", "origin": [1, -5, 2], "direction": [0, 0, 0]})"),
            "demo.jsonl:1: \"direction\" is [0,0,0], expected three numbers [x, y, z] of at most "
            "1e6, not all 0");
  const std::string drag =
      R"({"hand": "right", "do": "drag", "origin": [1, -5, 2], "direction": [0, 1, 0]})";
  EXPECT_EQ(Play(drag), "demo.jsonl:1: the right hand holds nothing");
  EXPECT_EQ(Play(R"({"hand": "right", "do": "grasp", "object": "a"}
{"hand": "right", "do": "drag", "origin": [1, -5, 2], "direction": [1, 0, 0]})"),
            "demo.jsonl:2: the ray is parallel to the motion plane of the right hand");
}

TEST_F(ScriptTest, NamesTheLineOfARefusedCommand) {
  EXPECT_EQ(Play("\n{\"hand\": \"any\", \"do\": \"grasp\", \"object\": \"x\"}"),
            "demo.jsonl:2: there is no object 'x'");
}

TEST_F(ScriptTest, ReportsAHandThatCannotArrive) {
  EXPECT_EQ(Play(R"({"hand": "any", "do": "grasp", "object": "a"}
{"hand": "any", "do": "move_to", "position": [0, 0, -1]}
{"do": "wait", "until": "arrived", "seconds": 2})"),
            "demo.jsonl:3: waited 2 s, but a hand has not arrived: the table is in the way of 'a'");
}

TEST_F(ScriptTest, NamesTheObjectsAndTheRobotInTheWay) {
  EXPECT_EQ(Play(R"({"hand": "any", "do": "grasp", "object": "a"}
{"hand": "any", "do": "move_to", "position": [0, 0, 2]}
{"do": "wait", "until": "arrived"}
{"hand": "any", "do": "move_to", "position": [3, 0, 2]}
{"do": "wait", "until": "arrived"}
{"hand": "any", "do": "move_to", "position": [3, 0, 0.5]}
{"do": "wait", "until": "arrived", "seconds": 2})"),
            "demo.jsonl:7: waited 2 s, but a hand has not arrived: 'b' is in the way of 'a'");

  simulation_ = MakeSimulation({BlockAt("a", {0, 0, 0.05})}, true);
  const Vector3 torso =
      scene::ToFileUnits(simulation_->robot()->base_pose().translation(), scene::kMetersPerUnit);
  const std::string inside = NumberText(torso.x()) + ", " + NumberText(torso.y()) + ", 2]}";
  EXPECT_EQ(Play(R"({"hand": "any", "do": "grasp", "object": "a"}
{"hand": "any", "do": "move_to", "position": [0, 0, 2]}
{"do": "wait", "until": "arrived"}
{"hand": "any", "do": "move_to", "position": [)" +
                 inside + R"(
{"do": "wait", "until": "arrived", "seconds": 6})"),
            "demo.jsonl:5: waited 6 s, but a hand has not arrived: the robot is in the way of 'a'");
}

TEST_F(ScriptTest, ReadsTheTrajectoriesItNamesInItsFolderOnly) {
  const auto folder =
      std::filesystem::temp_directory_path() / ("smile_script_" + std::to_string(getpid()));
  MakeDirectories(folder / "robot");
  WriteFile(folder / "robot/nod.csv", "time,head_pan\n0,0\n0.5,0.3\n1,0\n");
  WriteFile(folder / "broken.csv", "time,head_pan\n0,x\n");
  WriteFile(folder / "nod.jsonl", R"({"do": "trajectory", "file": "robot/nod.csv"}
{"do": "wait", "until": "arrived"})");
  WriteFile(folder / "robot/bad.jsonl", R"({"do": "trajectory", "file": "../broken.csv"}
{"do": "trajectory", "file": "nod.csv", "speed": 2})");
  simulation_ = MakeSimulation({}, true);
  ScriptPlayer player(ReadScript(folder / "nod.jsonl", scene::kMetersPerUnit));
  for (player.Advance(simulation_.get()); !player.is_finished();
       player.Advance(simulation_.get())) {
    simulation_->Tick();
  }
  EXPECT_EQ(simulation_->tick(), 61u);

  const std::string bad = (folder / "robot/bad.jsonl").string();
  const auto fault = [&](const std::vector<std::filesystem::path>& roots) -> std::string {
    try {
      ReadScript(bad, scene::kMetersPerUnit, roots);
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  };
  const std::string second =
      bad + ":2: \"trajectory\" with a \"file\" has an unknown key \"speed\"";
  EXPECT_EQ(fault({}),
            bad +
                ":1: \"file\" is \"../broken.csv\", expected a file in the folder of the "
                "script, in a --path folder or below these\n" +
                second);
  // A root is where names begin, too.
  EXPECT_EQ(fault({folder / "robot"}), fault({})) << "../broken.csv is above it";
  std::filesystem::remove_all(folder);
}

TEST_F(ScriptTest, CannotFillTheMemoryByNamingALongFileOnManyLines) {
  const auto folder =
      std::filesystem::temp_directory_path() / ("smile_long_script_" + std::to_string(getpid()));
  MakeDirectories(folder);
  std::string still = "time,head_pan\n", script;
  for (int i = 0; i < 10'000; ++i) still += std::to_string(i) + ",0\n";
  for (int i = 0; i < 101; ++i) script += "{\"do\": \"trajectory\", \"file\": \"still.csv\"}\n";
  WriteFile(folder / "still.csv", still);
  WriteFile(folder / "long.jsonl", script);
  try {
    ReadScript(folder / "long.jsonl", scene::kMetersPerUnit);
    ADD_FAILURE() << "it was read";
  } catch (const InputError& error) {
    EXPECT_EQ(error.what(), (folder / "long.jsonl").string() +
                                ":101: the trajectories of the script have more than 1000000 "
                                "points together");
  }
  std::filesystem::remove_all(folder);
}

TEST_F(ScriptTest, ReportsATrajectoryThatIsLongerThanTheWait) {
  simulation_ = MakeSimulation({}, true);
  EXPECT_EQ(Play(R"({"do": "pose", "name": "ready", "speed": 0.05}
{"do": "wait", "until": "arrived", "seconds": 2})"),
            "demo.jsonl:2: waited 2 s, but the robot is still moving: its trajectory takes longer");
}

TEST_F(ScriptTest, CollectsEveryFindingBeforeAnythingMoves) {
  EXPECT_EQ(Play("{\"do\": \"wait\"}\n[1, 2]\nnonsense\n{\"do\": \"wait\", \"seconds\": -1}"),
            "demo.jsonl:1: \"wait\" lacks \"seconds\" or \"until\"\n"
            "demo.jsonl:2: found array, expected an object like {\"hand\": \"left\", \"do\": …}\n"
            "demo.jsonl:3: this is not JSON\n"
            "demo.jsonl:4: \"seconds\" is -1, expected a number from 0 to 86400");
  EXPECT_EQ(simulation_->tick(), 0u);
}

}  // namespace
}  // namespace smile::sim
