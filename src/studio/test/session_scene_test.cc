// Scenes are loaded into a session, and objects are added to them.

#include "replay/replay.h"
#include "session_fixture.h"

namespace smile::studio {
namespace {

class SessionScene : public SessionFixture {};

TEST_F(SessionScene, ABrokenSceneChangesNothingAndIsReportedWithLines) {
  Begin();
  TickSeconds(0.1);
  const Json before = session_->Everything();
  const Json answer = AskWith({{"do", "load"},
                               {"name", "mine.xml"},
                               {"xml", std::string("<tabletop xmlns=\"http://synapse.cs.umd.edu/"
                                                   "tabletop-xml\">\n<blok/>\n</tabletop>")}});
  EXPECT_FALSE(answer["ok"].get<bool>());
  ASSERT_EQ(answer["diagnostics"].size(), 1u);
  EXPECT_EQ(answer["diagnostics"][0]["file"], "mine.xml");
  EXPECT_EQ(answer["diagnostics"][0]["line"], 2);
  EXPECT_EQ(Json(session_->Everything()), before);
  EXPECT_EQ(Refused(R"({"do":"load","scene":"../pair"})"), "there is no scene \"../pair\"");
  EXPECT_EQ(Json(session_->Everything()), before);
}

TEST_F(SessionScene, ScenesAreLoadedAndLoadedAgain) {
  Begin();
  Do(R"({"do":"load","scene":"pair_elsewhere"})");
  EXPECT_EQ(Latest("scene")["name"], "pair_elsewhere");
  EXPECT_TRUE(PositionOf("a").isApprox(Vector3(-3, -2, 0.5)));
  Command(R"({"do":"grasp","hand":"left","object":"a"})");
  Command(R"({"do":"destroy","hand":"left"})");
  TickSeconds(0.1);
  EXPECT_EQ(Latest("state")["gone"], Json::array({"a"}));
  EXPECT_EQ(Latest("looks")["looks"], Json::array({-1, 0}));
  const std::uint32_t number = session_->view().scene;
  Do(R"({"do":"reload"})");
  EXPECT_GT(session_->view().scene, number);
  EXPECT_EQ(State()["gone"], Json::array());
  Command(R"({"do":"start"})");
  EXPECT_NE(Refused(R"({"do":"load","scene":"pair"})").find("finish it first"), std::string::npos);
  EXPECT_NE(Refused(R"({"do":"clear","rage":true})").find("finish it first"), std::string::npos);
}

TEST_F(SessionScene, AnUndoLeadsBackIntoTheSceneThatWasLeft) {
  Begin();
  Command(R"({"do":"grasp","hand":"left","object":"a","point":[0,-2,1]})");
  Command(R"({"do":"move_to","hand":"left","position":[0,-2,4]})");
  Command(R"({"do":"markers","points":[[1,2,3]]})");
  TickSeconds(0.3);
  const Vector3 place = PositionOf("a");
  const std::uint64_t tick = State()["tick"].get<std::uint64_t>();
  Do(R"({"do":"load","scene":"pair_elsewhere"})");
  EXPECT_EQ(State()["markers"], Json::array());
  EXPECT_EQ(State()["hands"]["left"]["object"], Json());
  TickSeconds(0.1);
  Command(R"({"do":"undo"})");
  EXPECT_EQ(Latest("scene")["name"], "pair");
  EXPECT_EQ(State()["tick"], tick);
  EXPECT_EQ(State()["hands"]["left"]["object"], "a");
  EXPECT_EQ(PositionOf("a"), place);
  Command(R"({"do":"redo"})");
  EXPECT_EQ(Latest("scene")["name"], "pair_elsewhere");
  EXPECT_EQ(State()["tick"], 6);
  Do(R"({"do":"reload"})");
  Do(R"({"do":"spawn","preset":"ball","seed":1})");
  for (int i = 0; i < 3; ++i) Command(R"({"do":"undo"})");
  EXPECT_EQ(PositionOf("a"), place);
}

TEST_F(SessionScene, AddedObjectsAreRecordedAndCanBeUndone) {
  Begin();
  Command(R"({"do":"grasp","hand":"left","object":"a","point":[0,-2,1]})");
  Command(R"({"do":"move_to","hand":"left","position":[0,-2,4]})");
  TickSeconds(0.3);  // it is on its way
  Command(R"({"do":"start","name":"take"})");
  const Vector3 way = PositionOf("a");
  const std::uint32_t number = session_->view().scene;
  const std::string id = Do(R"({"do":"spawn","preset":"ball","seed":1})")["objects"][0];
  EXPECT_GT(session_->view().scene, number) << "pages receive the scene again";
  EXPECT_EQ(Latest("scene")["objects"].back()["id"], id);
  EXPECT_EQ(PositionOf("a"), way);
  EXPECT_EQ(State()["hands"]["left"]["object"], "a");
  TickOnce();
  EXPECT_GT((PositionOf("a") - way).norm(), 0.01) << "it continues as fast as it was";
  EXPECT_EQ(State()["recording"]["segments"].back()["deed"]["words"], "added " + id);
  Command(R"({"do":"undo"})");
  EXPECT_EQ(Latest("scene")["objects"].size(), 2u);
  EXPECT_EQ(PositionOf("a"), way);
  Command(R"({"do":"redo"})");
  EXPECT_EQ(Latest("scene")["objects"].size(), 3u);
  Command(R"({"do":"add","preset":"ring","seed":2})");
  Do(R"({"do":"clear"})");
  TickSeconds(0.5);
  EXPECT_EQ(State()["gone"], Json({"b", id, "ring_1"}));
  Command(R"({"do":"undo"})");
  TickSeconds(0.1);
  Command(R"({"do":"finish"})");
  const recording::Recording take = recording::OpenRecording(root_ / "recordings/take");
  EXPECT_EQ(take.start_scene().objects.size(), 2u);
  EXPECT_EQ(take.scene().objects.size(), 4u);
  EXPECT_EQ(replay::Replay(take).first_difference, std::nullopt);
  Do(R"({"do":"show","recording":"take","seconds":0})");
  EXPECT_EQ(Latest("scene")["objects"].size(), 4u);
  EXPECT_EQ(session_->view().state.variants, (std::vector<int>{0, 0, -1, -1})) << "not yet added";
}

TEST_F(SessionScene, PresetsGoToFreePlacesThatDependOnTheSeed) {
  Begin();
  Command(R"({"do":"grasp","hand":"right","object":"b","point":[3,-2,1]})");
  Command(R"({"do":"move_to","hand":"right","position":[5,-2,4]})");
  TickSeconds(1);
  const auto spawn_all = [this] {
    std::vector<Vector3> places;
    for (const char* preset :
         {"stack_5", "box", "big_block", "dominoes", "ring", "ball", "prism"}) {
      const Json answer = Do(R"({"do":"spawn","seed":7,"preset":")" + std::string(preset) + "\"}");
      for (const Json& id : answer["objects"]) places.push_back(PositionOf(id));
    }
    return places;
  };
  const std::vector<Vector3> places = spawn_all();
  EXPECT_EQ(places.size(), 15u);
  EXPECT_EQ(State()["hands"]["right"]["object"], "b");
  EXPECT_NEAR(PositionOf("b").z(), 3.5, 0.01);
  // What overlapped would be driven apart.
  const Vector3 top = places[4];
  TickSeconds(1);
  EXPECT_LT((PositionOf("smallblock_5") - top).norm(), 0.02);
  EXPECT_TRUE(State()["still"].get<bool>());
  // Composed scenes are recorded as any other.
  Command(R"({"do":"start","name":"composed"})");
  TickSeconds(0.2);
  Command(R"({"do":"finish"})");
  EXPECT_EQ(
      replay::Replay(recording::OpenRecording(root_ / "recordings/composed")).first_difference,
      std::nullopt);

  Do(R"({"do":"reload"})");
  Command(R"({"do":"grasp","hand":"right","object":"b","point":[3,-2,1]})");
  Command(R"({"do":"move_to","hand":"right","position":[5,-2,4]})");
  TickSeconds(1);
  const std::vector<Vector3> again = spawn_all();
  for (std::size_t i = 0; i < places.size(); ++i) EXPECT_EQ(again[i], places[i]);
  Do(R"({"do":"clear"})");
  EXPECT_EQ(State()["gone"].size(), Scene()["objects"].size() - 1);
  EXPECT_EQ(State()["hands"]["right"]["object"], "b");
}

// Sliders, strings, controls and bonds, used before.
TEST_F(SessionScene, ScenesThatWereUsedTakeMoreObjects) {
  for (const std::string name : {"controls", "dock", "lidbox", "screws", "strings", "valve"}) {
    WriteFile(root_ / "scenes" / (name + ".xml"),
              ReadFile(DataFile("scenes/" + name + ".xml"), 1 << 20));
  }
  std::filesystem::copy(DataFile("scenes/parts"), root_ / "scenes/parts");
  Begin();
  for (const std::string name : {"controls", "dock", "lidbox", "screws", "strings", "valve"}) {
    Do(R"({"do":"load","scene":")" + name + "\"}");
    const Json scene = Scene();
    for (const Json& object : scene["objects"]) {
      for (const Json& control : object["controls"]) {
        (void)AskWith(
            {{"do", "command"},
             {"command", {{"do", "trigger"}, {"hand", "any"}, {"control", control["id"]}}}});
      }
      if (!object["bonds"].get<bool>()) continue;
      for (const char* turn : {"fasten", "fasten", "loosen"}) {
        (void)AskWith({{"do", "command"},
                       {"command", {{"do", turn}, {"hand", "any"}, {"object", object["id"]}}}});
      }
    }
    TickSeconds(0.5);
    const Json controls = State()["controls"];
    Do(R"({"do":"spawn","preset":"ball","seed":5})");
    EXPECT_EQ(State()["controls"], controls) << name;
    Command(R"({"do":"start","name":")" + name + "\"}");
    TickSeconds(0.2);
    Command(R"({"do":"finish"})");
    EXPECT_EQ(
        replay::Replay(recording::OpenRecording(root_ / "recordings" / name)).first_difference,
        std::nullopt)
        << name;
  }
}

}  // namespace
}  // namespace smile::studio
