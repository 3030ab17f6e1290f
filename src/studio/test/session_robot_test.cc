// The robot of a session clears the table, and its joints are moved with sliders.

#include <map>

#include "robot/test/generated_robot.h"
#include "session_fixture.h"

namespace smile::studio {
namespace {

class SessionRobot : public SessionFixture {};

TEST_F(SessionRobot, ARobotThatClearsTheTableChangesNothingElse) {
  Begin(nullptr, /*with_robot=*/true);
  // The copies in which this is tried out have what was added, too.
  Do(R"({"do":"spawn","preset":"ball","seed":1})");
  Command(R"({"do":"grasp","hand":"left","object":"ball_1"})");
  EXPECT_FALSE(Do(R"({"do":"resting_place","hand":"left"})")["pose"].is_null());
  Command(R"({"do":"release","hand":"left"})");
  TickSeconds(0.1);
  const Json before = State();
  const Vector3 a_before = PositionOf("a");
  Do(R"({"do":"clear","rage":true})");
  TickSeconds(2);
  EXPECT_EQ(State()["mode"], "rage");
  EXPECT_NE(State()["robot"]["joints"], before["robot"]["joints"]);
  EXPECT_NE(Refused(R"({"do":"command","command":{"do":"grasp","hand":"left","object":"a"}})")
                .find("wait until it is done"),
            std::string::npos);
  TickSeconds(8);
  EXPECT_EQ(PositionOf("a"), a_before);
  EXPECT_EQ(State()["mode"], "live");
  EXPECT_EQ(State()["robot"]["joints"], before["robot"]["joints"]);
}

TEST_F(SessionRobot, ArmsOfAnyRobotHaveSlidersAndMove) {
  BeginWith(nullptr, sim::RobotPlacement{.model = robot::ThreeArms().Model()});
  const Json robot = Scene()["robot"];
  std::map<std::string, int> joints;
  for (const Json& joint : robot["joints"]) ++joints[joint["arm"].get<std::string>()];
  EXPECT_EQ(joints, (std::map<std::string, int>{{"front", 4}, {"middle", 6}, {"rear", 7}}));
  ASSERT_EQ(robot["grippers"].size(), 2u);
  EXPECT_EQ(robot["grippers"][1]["arm"], "rear");
  Command(R"({"do":"turn","joint":"middle_j2","velocity":0.4})");
  Command(R"({"do":"gripper","arm":"rear","velocity":0.5})");
  TickSeconds(0.5);
  Command(R"({"do":"turn","joint":"middle_j2","velocity":0})");
  EXPECT_NEAR(State()["robot"]["joints"]["middle_j2"].get<double>(), 0.7, 0.02);
  EXPECT_NEAR(State()["robot"]["grippers"][1].get<double>(), 0.25, 0.03);
  Command(
      R"({"do":"trajectory","joints":["front_gripper"],"points":[{"seconds":0,"positions":[0.05]}]})");
  TickSeconds(2);
  EXPECT_NEAR(State()["robot"]["grippers"][0].get<double>(), 0.5, 0.02);
  const Json before = State()["robot"]["joints"];
  Do(R"({"do":"clear","rage":true})");
  TickSeconds(1);
  for (const char* joint : {"front_j0", "middle_j0", "rear_j0"}) {
    EXPECT_NE(State()["robot"]["joints"][joint], before[joint]) << joint;
  }
}

TEST_F(SessionRobot, ClearingTheTableIsNotInTheHistory) {
  // Two sessions do the same, one of them with a rage in between.
  std::vector<std::string> logs;
  std::vector<Json> ends;
  for (const bool with_rage : {false, true}) {
    Begin(nullptr, /*with_robot=*/true);
    PutAOnB();
    if (with_rage) {
      Do(R"({"do":"clear","rage":true})");
      TickSeconds(10);
    }
    TickSeconds(1);
    Command(R"({"do":"start","name":"take"})");
    TickSeconds(0.2);
    Command(R"({"do":"finish"})");
    // The log contains all from the first command on, the trace a hash of the state for each tick.
    logs.push_back(ReadFile(root_ / "recordings/take/commands.jsonl", 1 << 20) +
                   ReadFile(root_ / "recordings/take/trace.bin", 1 << 24));
    Command(R"({"do":"undo"})");
    EXPECT_EQ(State()["hands"]["left"]["object"], "a");
    EXPECT_EQ(State()["allowed"]["commands"]["redo"], true);
    Command(R"({"do":"undo"})");
    EXPECT_NE(State()["allowed"]["commands"]["undo"], true);
    ends.push_back(State());
    session_.reset();
    std::filesystem::remove_all(root_ / "recordings");
  }
  EXPECT_TRUE(logs[0] == logs[1]);
  EXPECT_EQ(ends[0], ends[1]);
}

}  // namespace
}  // namespace smile::studio
