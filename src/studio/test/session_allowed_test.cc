#include <gtest/gtest.h>

#include "session_fixture.h"
#include "texts/message_json.h"

namespace smile::studio {
namespace {

using Names = std::set<std::string>;

class SessionAllowed : public SessionFixture {};

TEST_F(SessionAllowed, AStateReportsRefusedRequestsWithReasons) {
  Begin();
  const Names live = {"command", "resting_place", "load",   "reload",      "spawn",
                      "clear",   "show",          "branch", "record_over", "correct",
                      "start",   "support",       "pause",  "resume"};
  EXPECT_EQ(AllowedNow(), live);
  Command(R"({"do":"start","name":"take"})");
  Names recording = {"command", "resting_place", "support", "spawn",
                     "clear",   "finish",        "pause",   "resume"};
  EXPECT_EQ(AllowedNow(), recording);
  PutAOnB();
  recording.insert("undo");
  EXPECT_EQ(AllowedNow(), recording);
  Command(R"({"do":"undo"})");
  recording.insert("redo");
  EXPECT_EQ(AllowedNow(), recording);
  Command(R"({"do":"finish"})");
  Do(R"({"do":"show","recording":"take"})");
  EXPECT_EQ(AllowedNow(),
            (Names{"load", "reload", "show", "play", "live", "branch", "record_over", "correct"}));
  Do(R"({"do":"live"})");
  EXPECT_EQ(AllowedNow().count("play"), 0u);
}

TEST_F(SessionAllowed, WhileTheRobotClearsTheTableOnlyScenesMayChange) {
  Begin(nullptr, /*with_robot=*/true);
  Names live = AllowedNow();
  EXPECT_TRUE(live.contains("start_brain") && live.contains("imitate"));
  Do(R"({"do":"clear","rage":true})");
  EXPECT_EQ(AllowedNow(), (Names{"load", "reload", "branch", "record_over", "correct", "imitate",
                                 "pause", "resume"}));
}

TEST_F(SessionAllowed, LoadingAndRecordingWaitForARestoredMoment) {
  Begin();
  Command(R"({"do":"start","name":"take"})");
  PutAOnB();
  Command(R"({"do":"finish"})");
  ASSERT_TRUE(page::IsLater(BeginToAsk({{"do", "branch"}, {"recording", "take"}, {"step", 1}})));
  const std::uint32_t branch = seq_;
  EXPECT_EQ(AllowedNow(), (Names{"command", "resting_place", "support", "spawn", "clear", "show",
                                 "undo", "pause", "resume"}));
  EXPECT_EQ(State()["restoring"], "take");
  seq_ = branch;
  EXPECT_TRUE(LaterAnswer()["ok"].get<bool>());
  EXPECT_TRUE(State()["restoring"].is_null());
  EXPECT_TRUE(AllowedNow().contains("finish")) << "it is recorded on";
}

TEST_F(SessionAllowed, CommandsAreTriedWithoutEffect) {
  Begin();
  Command(R"({"do":"grasp","hand":"left","object":"a","point":[0,-2,1]})");
  TickSeconds(0.5);
  const Json before = session_->Everything();
  const std::string commands = R"([
    {"hand":"right","do":"grasp","object":"b"},
    {"hand":"left","do":"grasp","object":"b"},
    {"hand":"left","do":"release"},
    {"hand":"right","do":"release"},
    {"hand":"left","do":"fasten","object":"a"},
    {"hand":"right","do":"trigger","control":"c"},
    {"do":"undo"}, {"do":"redo"}])";
  const Json allowed = AllowedCommands(commands);
  EXPECT_EQ(Json(session_->Everything()), before);
  std::vector<bool> are_allowed;
  for (const Json& one : allowed) are_allowed.push_back(one == true);
  EXPECT_EQ(are_allowed, (std::vector<bool>{true, false, true, false, false, false, true, false}));
  // Requests are refused for the reason that the state message gives.
  const Json list = ParseJson(commands);
  for (std::size_t i = 0; i < list.size(); ++i) {
    if (allowed[i] == true) continue;
    EXPECT_EQ(Refused(R"({"do":"command","command":)" + ToText(list[i]) + "}"),
              texts::MessageOf(allowed[i]));
  }
}

TEST_F(SessionAllowed, TheRaisedButtonOfASwitchMayBePressedInAnyState) {
  Begin();
  const std::string scene = R"xml(<tabletop xmlns="http://synapse.cs.umd.edu/tabletop-xml">
  <toggleSwitch id="s" numStates="3" location="(0, 0, 0.1)"/>
</tabletop>)xml";
  Do(Json({{"do", "load"}, {"name", "switches"}, {"xml", scene}}).dump());
  const auto press = [](const std::string& button) {
    return R"({"do":"trigger","hand":"left","control":"s","part":")" + button + R"("})";
  };
  std::string raised = "s-b2", pressed = "s-b1";
  for (int presses = 0; presses < 3; ++presses) {
    const Json allowed = AllowedCommands("[" + press(raised) + "," + press(pressed) + "]");
    EXPECT_EQ(allowed[0], true);
    EXPECT_EQ(allowed[1]["say"], "controls.isPressed") << allowed;
    Command(press(raised));
    std::swap(raised, pressed);
  }
}

TEST_F(SessionAllowed, RequestsMayBeCheckedWithTheirFields) {
  Begin();
  const Json allowed =
      Do(R"({"do":"allowed","requests":[{"do":"clear"},{"do":"clear","rage":true},{"do":"live"}]})")
          ["allowed"];
  EXPECT_EQ(allowed[0], true);
  EXPECT_EQ(texts::MessageOf(allowed[1]), "there is no robot to clear the table");
  EXPECT_EQ(texts::MessageOf(allowed[2]), "no recording is shown");
  EXPECT_NE(Refused(R"({"do":"allowed","requests":[{"do":"dance"}]})").find("\"dance\""),
            std::string::npos);
  EXPECT_NE(Refused(R"({"do":"allowed","requests":[{"do":"command","command":{"do":"gasp"}}]})")
                .find("gasp"),
            std::string::npos);
}

}  // namespace
}  // namespace smile::studio
