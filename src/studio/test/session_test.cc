#include "studio/session.h"

#include <sys/resource.h>

#include <csignal>
#include <map>
#include <random>

#include "recorder/test/painted_eye.h"
#include "recording/recording_history.h"
#include "replay/replay.h"
#include "robot/test/generated_robot.h"
#include "session_fixture.h"
#include "texts/message_json.h"

namespace smile::studio {
namespace {

class SessionTest : public SessionFixture {};

TEST_F(SessionTest, ADemonstrationIsRecordedAndReplays) {
  Begin();
  const std::string id = Command(R"({"do":"start","name":"take","title":"A on B"})")["recording"];
  EXPECT_EQ(id, "take");
  PutAOnB();
  Command(R"({"do":"plane","hand":"left","angle":90})");
  const Json taken = Command(R"({"do":"grasp","hand":"left","object":"a"})");
  EXPECT_EQ(taken["deed"]["words"], "left hand takes a");
  Command(R"({"do":"rotate","hand":"left","angles":[0,0,30]})");
  Command(R"({"do":"drag","hand":"left","origin":[30,-2,8],"direction":[-1,0,-0.1]})");
  TickSeconds(0.5);
  Command(R"({"do":"undo"})");
  Command(R"({"do":"redo"})");
  Command(R"({"do":"undo"})");
  const Json recording = State()["recording"];
  EXPECT_EQ(recording["title"], "A on B");
  EXPECT_EQ(recording["segments"].size(), 3u);
  EXPECT_EQ(recording["segments"][0]["deed"], nullptr);
  EXPECT_EQ(recording["segments"][1]["deed"]["do"], "take");
  EXPECT_EQ(
      recording["segments"][2]["deed"],
      Json::parse(
          R"({"do":"put","hand":"left","what":"a","on":"b","words":"left hand puts a on b"})"));
  EXPECT_EQ(State()["allowed"]["commands"]["undo"], true);
  EXPECT_EQ(State()["allowed"]["commands"]["redo"], true);
  Command(R"({"do":"finish"})");
  EXPECT_TRUE(State()["recording"].is_null());
  const recording::Recording kept = recording::OpenRecording(root_ / "recordings/take");
  EXPECT_EQ(replay::Replay(kept).first_difference, std::nullopt);
  EXPECT_EQ(WordsOf(recording::HistoryOf(kept)[2]), "left hand puts a on b");
}

TEST_F(SessionTest, SeveralObjectsAreMovedAndCopiedInARecordingThatReplays) {
  Begin();
  Command(R"({"do":"start","name":"take"})");
  const Json moved = Command(R"({"do":"displace","objects":["a","b"],"by":[0,1,0]})");
  EXPECT_EQ(moved["deed"]["do"], "move");
  EXPECT_EQ(moved["deed"]["words"], "moved 2 objects");
  TickSeconds(0.2);
  const Json copied = Command(R"({"do":"duplicate","objects":["a","b"]})");
  EXPECT_EQ(copied["deed"]["words"], "added 2 objects");
  EXPECT_EQ(copied["objects"], Json({"a_2", "b_2"}));
  Command(R"({"do":"add","preset":"ball","seed":1,"place":[-5,2,0]})");
  TickSeconds(0.2);
  Command(R"({"do":"finish"})");
  const recording::Recording kept = recording::OpenRecording(root_ / "recordings/take");
  EXPECT_EQ(replay::Replay(kept).first_difference, std::nullopt);
  EXPECT_EQ(WordsOf(recording::HistoryOf(kept)[1]), "moved 2 objects");
  EXPECT_NE(
      Refused(R"({"do":"command","command":{"do":"displace","objects":["a","none"],"by":[0,1,0]}})")
          .find("there is no object 'none'"),
      std::string::npos);
}

TEST_F(SessionTest, TheRecordedCameraIsChosenBetweenRecordings) {
  recorder::PaintedEye eye;
  Begin(&eye, /*with_robot=*/true);
  EXPECT_EQ(State()["eye"], (Json{{"camera", "eye"}, {"cameras", {"eye", "head"}}}));
  Do(R"({"do":"eye","camera":"head"})");
  EXPECT_EQ(State()["eye"]["camera"], "head");
  EXPECT_NE(Refused(R"({"do":"eye","camera":"top"})").find("expected eye or head"),
            std::string::npos);
  Command(R"({"do":"start","name":"take"})");
  EXPECT_NE(Refused(R"({"do":"eye","camera":"eye"})").find("finish it first"), std::string::npos);
  TickSeconds(0.2);
  Command(R"({"do":"finish"})");
  EXPECT_EQ(recording::OpenRecording(root_ / "recordings/take").info.eye_camera, "head");
  Begin(&eye);
  EXPECT_EQ(State()["eye"]["cameras"], Json({"eye"})) << "without a robot";
  Begin();
  EXPECT_TRUE(State()["eye"].is_null());
  EXPECT_EQ(Refused(R"({"do":"eye","camera":"eye"})"), "the studio was started without pictures");
}

TEST_F(SessionTest, AFullDiskEndsTheRecordingAndTheStateReportsIt) {
  Begin();
  Command(R"({"do":"start","name":"take"})");
  EXPECT_TRUE(State()["failure"].is_null());
  rlimit before{};
  ASSERT_EQ(getrlimit(RLIMIT_FSIZE, &before), 0);
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  const rlimit small{3000, before.rlim_max};
  ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &small), 0);
  PutAOnB();
  setrlimit(RLIMIT_FSIZE, &before);
  std::signal(SIGXFSZ, handler);
  const Json state = State();
  EXPECT_TRUE(state["recording"].is_null());
  EXPECT_EQ(state["failure"]["recording"], "take");
  EXPECT_NE(state["failure"]["error"].get<std::string>().find("File too large"), std::string::npos);
  EXPECT_EQ(state["failure"]["kept"], true);
  EXPECT_EQ(Latest("error"), Json()) << "it is sent once";
  EXPECT_EQ(replay::Replay(recording::OpenRecording(root_ / "recordings/take")).first_difference,
            std::nullopt);
  Command(R"({"do":"start","name":"next"})");
  TickOnce();
  EXPECT_TRUE(State()["failure"].is_null());
}

TEST_F(SessionTest, ARecordingThatIsRemovedMeanwhileIsLost) {
  Begin();
  Command(R"({"do":"start","name":"take"})");
  TickSeconds(0.5);
  std::filesystem::remove_all(root_ / "recordings");
  EXPECT_NE(Refused(R"({"do":"command","command":{"do":"finish"}})").find("was removed"),
            std::string::npos);
  TickOnce();
  const Json state = State();
  EXPECT_TRUE(state["recording"].is_null());
  EXPECT_EQ(state["failure"]["recording"], "take");
  EXPECT_EQ(state["failure"]["kept"], false);
}

TEST_F(SessionTest, ARecordingIsGoneOnWithFromAnyOfItsSteps) {
  Begin();
  TickSeconds(0.1);
  Command(R"({"do":"grasp","hand":"right","object":"b"})");
  Command(R"({"do":"release","hand":"right"})");
  Command(R"({"do":"start","name":"take"})");
  PutAOnB();
  Command(R"({"do":"finish"})");
  Do(R"({"do":"load","scene":"pair_elsewhere"})");
  Do(R"({"do":"branch","recording":"take","step":1,"after":0.5})");
  const Json recording = State()["recording"];
  EXPECT_EQ(recording["segments"].size(), 2u);
  EXPECT_NEAR(recording["seconds"].get<double>(), 0.5, 0.06);
  EXPECT_EQ(State()["hands"]["left"]["object"], "a");
  Command(R"({"do":"release","hand":"left"})");
  TickSeconds(0.2);
  Command(R"({"do":"finish"})");
  const recording::Recording kept = recording::OpenRecording(root_ / "recordings/take");
  EXPECT_EQ(replay::Replay(kept).first_difference, std::nullopt);
}

TEST_F(SessionTest, TheWorldContinuesUntilThatOfARecordingIsReady) {
  Begin();
  Command(R"({"do":"start","name":"take"})");
  PutAOnB();
  Command(R"({"do":"finish"})");
  const std::uint64_t tick = State()["tick"].get<std::uint64_t>();
  ASSERT_TRUE(page::IsLater(BeginToAsk({{"do", "branch"}, {"recording", "take"}, {"step", 1}})));
  const std::uint32_t seq = seq_;
  TickSeconds(0.1);
  EXPECT_EQ(State()["tick"], tick + 6);
  Command(R"({"do":"grasp","hand":"right","object":"b"})");
  for (const char* what :
       {R"({"do":"command","command":{"do":"start"}})", R"({"do":"load","scene":"pair"})",
        R"({"do":"branch","recording":"take","step":1})"}) {
    EXPECT_NE(Refused(what).find("wait until it is done"), std::string::npos);
  }
  seq_ = seq;
  const Json answer = LaterAnswer();
  EXPECT_EQ(answer["recording"], "take") << ToText(answer);
  EXPECT_EQ(latest_["progress"]["what"], "branch");
  EXPECT_EQ(latest_["progress"]["done"], latest_["progress"]["total"]);
  EXPECT_EQ(State()["recording"]["id"], "take");
  EXPECT_EQ(State()["hands"]["left"]["object"], "a");
  EXPECT_EQ(State()["hands"]["right"]["object"], nullptr);
  Command(R"({"do":"finish"})");

  EXPECT_NE(Refused(R"({"do":"branch","recording":"take","step":99})").find("step"),
            std::string::npos);
  Command(R"({"do":"start"})");
}

// The world is left while another one is in the making.
TEST_F(SessionTest, UnfinishedJobsEndWithTheSession) {
  Begin();
  Command(R"({"do":"start","name":"take"})");
  PutAOnB();
  Command(R"({"do":"finish"})");
  ASSERT_TRUE(page::IsLater(BeginToAsk({{"do", "branch"}, {"recording", "take"}, {"step", 2}})));
  session_.reset();
}

TEST_F(SessionTest, ABrokenSceneChangesNothingAndIsReportedWithLines) {
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

TEST_F(SessionTest, ScenesAreLoadedAndLoadedAgain) {
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

TEST_F(SessionTest, AnUndoLeadsBackIntoTheSceneThatWasLeft) {
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

TEST_F(SessionTest, AddedObjectsAreRecordedAndCanBeUndone) {
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

TEST_F(SessionTest, PresetsGoToFreePlacesThatDependOnTheSeed) {
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
TEST_F(SessionTest, ScenesThatWereUsedTakeMoreObjects) {
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

// A nut and a plate with holes wait for screws: they cannot be fastened themselves.
TEST_F(SessionTest, OnlyObjectsThatFitHolesAreOfferedForFastening) {
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

TEST_F(SessionTest, ReportsWhatAHeldToolWouldDoExactlyWhileItsUseIsAllowed) {
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

TEST_F(SessionTest, ObjectsOfAShownRecordingCannotBeGrasped) {
  Begin();
  Command(R"({"do":"start","name":"take"})");
  PutAOnB();
  Command(R"({"do":"finish"})");
  const Vector3 left_at = PositionOf("a");
  const std::uint32_t number = session_->view().scene;
  Do(R"({"do":"show","recording":"take","seconds":0})");
  EXPECT_EQ(State()["mode"], "playback");
  EXPECT_GT(session_->view().scene, number);
  EXPECT_LT((PositionOf("a") - Vector3(0, -2, 0.5)).norm(), 0.01);
  Do(R"({"do":"play"})");
  TickSeconds(1);
  EXPECT_GT(PositionOf("a").z(), 1);
  EXPECT_NE(Refused(R"({"do":"command","command":{"do":"grasp","hand":"left","object":"a"}})")
                .find("a recording is shown"),
            std::string::npos);
  Do(R"({"do":"live"})");
  EXPECT_EQ(PositionOf("a"), left_at);
  EXPECT_EQ(State()["mode"], "live");
}

TEST_F(SessionTest, WhenItIsPausedTimeStandsStillAndHandsDoNot) {
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

TEST_F(SessionTest, SendsStatesOnlyWhenSomethingChanged) {
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

TEST_F(SessionTest, ReportsWhereAHeldObjectWouldComeToRest) {
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

TEST_F(SessionTest, ReportsWhatAnObjectStandsOn) {
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

TEST_F(SessionTest, ARestingPlaceThatWasFoundEarlierIsMarkedAsStale) {
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

TEST_F(SessionTest, ReportsObjectsOnTheFloor) {
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

TEST_F(SessionTest, ReportsGoalsOfTheGraspedPointAndTheOrigin) {
  Begin();
  Command(R"({"do":"grasp","hand":"left","object":"a","point":[0,-2,1]})");
  Command(R"({"do":"move_to","hand":"left","position":[1,-2,3]})");
  const Json hand = State()["hands"]["left"];
  EXPECT_EQ(hand["goal"], Json({1.0, -2.0, 3.0}));
  EXPECT_EQ(hand["place"], Json({1.0, -2.0, 2.5}));
}

TEST_F(SessionTest, TheEyeShowsWhatIsRecordedAndRestsWhenNothingMoves) {
  recorder::PaintedEye eye;
  Begin(&eye);
  TickSeconds(3);  // until all is asleep
  const int num_pictures = eye.num_pictures();
  TickSeconds(1);
  EXPECT_EQ(eye.num_pictures(), num_pictures);
  Command(R"({"do":"start","name":"take"})");
  session_->Tick();
  const SessionUpdates updates = session_->TakeUpdates();
  ASSERT_TRUE(updates.view.has_value());
  EXPECT_TRUE(updates.is_view_recorded);
  EXPECT_EQ(updates.view->color.front(), eye.num_pictures());
}

TEST_F(SessionTest, ARobotThatClearsTheTableChangesNothingElse) {
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

TEST_F(SessionTest, ArmsOfAnyRobotHaveSlidersAndMove) {
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

TEST_F(SessionTest, ClearingTheTableIsNotInTheHistory) {
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

TEST_F(SessionTest, WrongRequestsNameTheField) {
  Begin();
  EXPECT_EQ(Refused(R"({"do":"spawn","preset":"ball","seed":"7"})"),
            "\"seed\" is text, expected a number");
  EXPECT_EQ(Refused(R"({"do":"speed"})"), "\"factor\" is missing, expected a number from 0.1 to 4");
  EXPECT_EQ(Refused(R"({"do":"speed","factor":1e300})"),
            "\"factor\" is 1e+300, expected a number from 0.1 to 4");
  EXPECT_EQ(Refused(R"({"do":"snap","to":"faces"})"),
            "\"to\" is text, expected a list of any of rails, faces, edges, grid or angles");
  EXPECT_NE(Refused(R"({"do":"command","command":{"do":"grasp","hand":"left"}})").find("object"),
            std::string::npos);
}

/// JSON that no client would send, made of the parts of requests.
Json RandomJson(std::mt19937_64* random, int depth) {
  const auto lot = [random](int count) {
    return static_cast<int>((*random)() % static_cast<unsigned>(count));
  };
  static const std::vector<Json> kLeaves = {nullptr,
                                            true,
                                            -1,
                                            0,
                                            7,
                                            1e308,
                                            -1e-308,
                                            "",
                                            "left",
                                            "a",
                                            "grasp",
                                            "take",
                                            "faces",
                                            "pair",
                                            std::string(5000, 'x'),
                                            "../..",
                                            "\xc3\xa4\n",
                                            18446744073709551615u};
  const int kind = depth > 0 ? lot(4) : 0;
  if (kind < 2) return kLeaves[static_cast<std::size_t>(lot(static_cast<int>(kLeaves.size())))];
  static const std::vector<const char*> kKeys = {
      "do",    "command", "hand",      "object", "position", "scene", "xml",
      "name",  "seed",    "preset",    "rage",   "to",       "rate",  "step",
      "after", "brain",   "recording", "angle",  "factor"};
  Json value = kind == 2 ? Json::array() : Json::object();
  for (int i = lot(5); i > 0; --i) {
    if (kind == 2) {
      value.push_back(RandomJson(random, depth - 1));
    } else {
      value[kKeys[static_cast<std::size_t>(lot(static_cast<int>(kKeys.size())))]] =
          RandomJson(random, depth - 1);
    }
  }
  return value;
}

TEST_F(SessionTest, NoRequestHowEverStrangeDoesHarm) {
  Begin();
  std::mt19937_64 random(1);
  std::vector<std::string> requests;
  for (const auto& [name, entry] : session_->requests().requests) requests.push_back(name);
  for (int i = 0; i < 3000; ++i) {
    Json fields = Json::object();
    while (fields.size() < 4) {
      const Json more = RandomJson(&random, 3);
      if (more.is_object()) fields.update(more);
      fields["do"] = requests[random() % requests.size()];
      if (random() % 2 == 0) break;
    }
    const Json answer = AskWith(fields);
    ASSERT_EQ(answer["ok"].is_boolean(), true);
    if (i % 10 == 0) session_->Tick();
  }
  Do(R"({"do":"resume"})");
  EXPECT_TRUE(std::filesystem::is_directory(root_ / "scenes"));
}

}  // namespace
}  // namespace smile::studio
