// What the state tells a page about the world, and when it is sent.

#include "session_fixture.h"
#include "texts/message_json.h"

namespace smile::studio {
namespace {

class SessionState : public SessionFixture {};

TEST_F(SessionState, SendsStatesOnlyWhenSomethingChanged) {
  Begin();
  TickSeconds(1);
  sent_.clear();
  TickSeconds(2);
  EXPECT_TRUE(sent_.empty()) << ToText(sent_.front());
  Command(R"({"do":"grasp","hand":"left","object":"a","point":[0,-2,1]})");
  for (int i = 0; i < 60; ++i) {
    Command(R"({"do":"move_to","hand":"left","position":[)" + std::to_string(0.02 * i) + ",-2,3]}");
    TickSeconds(1.0 / 60);
  }
  const auto num_states =
      std::ranges::count_if(sent_, [](const Json& message) { return message["t"] == "state"; });
  EXPECT_GE(num_states, 15);
  EXPECT_LE(num_states, 20);
}

TEST_F(SessionState, WhenItIsPausedTimeStandsStillAndHandsDoNot) {
  Begin();
  Do(R"({"do":"pause"})");
  TickSeconds(0.5);
  EXPECT_EQ(State()["tick"], 0);
  Command(R"({"do":"grasp","hand":"left","object":"a"})");
  TickSeconds(0.1);
  EXPECT_EQ(Latest("state")["hands"]["left"]["object"], "a");
  EXPECT_EQ(Latest("event")["kind"], "grasped");
  Do(R"({"do":"resume"})");
  TickSeconds(0.5);
  EXPECT_EQ(State()["tick"], 30);
}

// A nut and a plate with holes wait for screws: they cannot be fastened themselves.
TEST_F(SessionState, OnlyObjectsThatFitHolesAreOfferedForFastening) {
  const std::filesystem::path scenes = root_ / "scenes";
  WriteFile(scenes / "screws.xml", ReadFile(DataFile("scenes/screws.xml"), 1 << 20));
  std::filesystem::copy(DataFile("scenes/parts"), scenes / "parts");
  Begin();
  Do(R"({"do":"load","scene":"screws"})");
  const Json scene = Scene();
  std::vector<std::string> offered;
  for (const Json& object : scene["objects"]) {
    if (object["bonds"].get<bool>()) offered.push_back(object["id"]);
  }
  EXPECT_EQ(offered, (std::vector<std::string>{"BrassScrew", "SteelScrew"}));
}

TEST_F(SessionState, ReportsWhatAHeldToolWouldDoExactlyWhileItsUseIsAllowed) {
  const std::filesystem::path scenes = root_ / "scenes";
  WriteFile(scenes / "cover.xml", ReadFile(DataFile("scenes/cover.xml"), 1 << 20));
  std::filesystem::copy(DataFile("scenes/parts"), scenes / "parts");
  Begin();
  Do(R"({"do":"load","scene":"cover"})");
  const auto expect_uses = [this](const char* uses) {
    const Json allowed = AllowedCommands(
        R"([{"do":"use","hand":"right"}, {"do":"use","hand":"right","loosen":true}])");
    Json verbs = Json::array();
    if (allowed[0] == true) verbs.push_back("fasten");
    if (allowed[1] == true) verbs.push_back("loosen");
    const Json state = State();
    EXPECT_EQ(state["uses"], ParseJson(uses)) << ToText(allowed);
    EXPECT_EQ(state["uses"].empty() ? Json::array() : state["uses"]["Screwdriver"]["do"], verbs);
  };
  const auto move_to = [this](const std::string& position) {
    Command(R"({"do":"move_to","hand":"right","position":)" + position + "}");
    TickSeconds(1.5);
  };
  Command(R"({"do":"grasp","hand":"right","object":"Screwdriver"})");
  expect_uses("{}");
  move_to("[5.1,0.2,3.4]");
  move_to("[-2.55,1.75,3.4]");
  expect_uses("{}");
  move_to("[-2.55,1.75,2.84]");
  // It is tight already.
  expect_uses(R"({"Screwdriver":{"do":["loosen"],"target":"ScrewNW"}})");
  Command(R"({"do":"use","hand":"right","loosen":true})");
  expect_uses(R"({"Screwdriver":{"do":["fasten","loosen"],"target":"ScrewNW"}})");
  move_to("[-2.55,1.75,3.6]");
  expect_uses("{}");

  const Json scene = Scene();
  for (const Json& object : scene["objects"]) {
    EXPECT_EQ(object.contains("tool"), object["id"] == "Screwdriver") << object["id"];
  }
}

TEST_F(SessionState, ReportsWhereAHeldObjectWouldComeToRest) {
  Begin();
  Command(R"({"do":"grasp","hand":"left","object":"a","point":[0,-2,1]})");
  Command(R"({"do":"move_to","hand":"left","position":[3.1,-2,4]})");
  TickSeconds(1);
  const Json before = session_->Everything();
  const Json pose = Do(R"({"do":"resting_place","hand":"left"})")["pose"];
  EXPECT_NEAR(pose[0].get<double>(), 3.1, 0.05);
  EXPECT_NEAR(pose[2].get<double>(), 1.5, 0.05);
  EXPECT_EQ(Json(session_->Everything()), before);
  EXPECT_TRUE(Do(R"({"do":"resting_place","hand":"right"})")["pose"].is_null());
}

TEST_F(SessionState, ReportsWhatAnObjectStandsOn) {
  Begin();
  const std::string ask = R"({"do":"support","object":"a"})";
  EXPECT_EQ(Do(ask)["on"], "");
  Command(R"({"do":"grasp","hand":"left","object":"a","point":[0,-2,1]})");
  Command(R"({"do":"move_to","hand":"left","position":[3,-2,4]})");
  TickSeconds(1);
  EXPECT_FALSE(Do(ask).contains("on")) << "it is in the air";
  Command(R"({"do":"release","hand":"left"})");
  EXPECT_FALSE(Do(ask).contains("on")) << "it falls";
  TickSeconds(2);
  EXPECT_EQ(Do(ask)["on"], "b");
  EXPECT_FALSE(Do(ask).contains("into"));
  EXPECT_EQ(texts::MessageOf(Ask(R"({"do":"support","object":"c"})")["error"]),
            "there is no object \"c\"");
}

TEST_F(SessionState, ARestingPlaceThatWasFoundEarlierIsMarkedAsStale) {
  Begin();
  Command(R"({"do":"grasp","hand":"left","object":"a","point":[0,-2,1]})");
  Command(R"({"do":"move_to","hand":"left","position":[3,-2,4]})");
  TickSeconds(0.2);
  const std::string ask = R"({"do":"resting_place","hand":"left"})";
  const Json first = Do(ask);
  EXPECT_EQ(first["stale"], true) << "it moves";
  TickSeconds(0.1);
  const Json second = Do(ask);
  EXPECT_EQ(second["stale"], true);
  EXPECT_EQ(second["pose"], first["pose"]);
  TickSeconds(2);
  const Json third = Do(ask);
  EXPECT_EQ(third["stale"], false);
  EXPECT_EQ(Do(ask)["stale"], false) << "time stood still";
  TickSeconds(0.1);
  EXPECT_EQ(Do(ask)["stale"], true);
  Command(R"({"do":"release","hand":"left"})");
  TickSeconds(1.5);
  const Vector3 rest = PositionOf("a");
  for (int axis = 0; axis < 3; ++axis) {
    EXPECT_NEAR(third["pose"][static_cast<std::size_t>(axis)].get<double>(), rest[axis], 0.01);
  }
}

TEST_F(SessionState, ReportsObjectsOnTheFloor) {
  Begin();
  EXPECT_EQ(State()["fallen"], Json::array());
  Command(R"({"do":"start","name":"take"})");
  Command(R"({"do":"grasp","hand":"left","object":"a"})");
  Command(R"({"do":"move_to","hand":"left","position":[0,-2,3]})");
  TickSeconds(0.5);
  Command(R"({"do":"move_to","hand":"left","position":[18,-2,3]})");
  TickSeconds(3);
  Command(R"({"do":"release","hand":"left"})");
  TickSeconds(2);
  EXPECT_EQ(State()["fallen"], Json::array({"a"}));
  EXPECT_EQ(State()["gone"], Json::array());

  // So does a recording that is shown, of each moment; also one that began after the fall.
  Command(R"({"do":"finish"})");
  Command(R"({"do":"start","name":"after"})");
  Command(R"({"do":"grasp","hand":"left","object":"b"})");
  Command(R"({"do":"destroy","hand":"left"})");
  TickSeconds(0.5);
  Command(R"({"do":"finish"})");
  const auto fallen_and_gone_at = [this](const std::string& recording, const char* seconds) {
    Do(R"({"do":"show","recording":")" + recording + R"(","seconds":)" + seconds + "}");
    const Json state = State();
    EXPECT_EQ(state["mode"], "playback");
    return Json{state["fallen"], state["gone"]};
  };
  EXPECT_EQ(fallen_and_gone_at("take", "0"), ParseJson("[[],[]]"));
  EXPECT_EQ(fallen_and_gone_at("take", "99"), ParseJson(R"([["a"],[]])"));
  EXPECT_EQ(fallen_and_gone_at("take", "3"), ParseJson("[[],[]]"));
  EXPECT_EQ(fallen_and_gone_at("after", "99"), ParseJson(R"([["a"],["b"]])"));
}

TEST_F(SessionState, ReportsGoalsOfTheGraspedPointAndTheOrigin) {
  Begin();
  Command(R"({"do":"grasp","hand":"left","object":"a","point":[0,-2,1]})");
  Command(R"({"do":"move_to","hand":"left","position":[1,-2,3]})");
  const Json hand = State()["hands"]["left"];
  EXPECT_EQ(hand["goal"], Json({1.0, -2.0, 3.0}));
  EXPECT_EQ(hand["place"], Json({1.0, -2.0, 2.5}));
}

}  // namespace
}  // namespace smile::studio
