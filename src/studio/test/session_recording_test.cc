// Demonstrations are recorded, shown and continued in a session; failures are reported.

#include <sys/resource.h>

#include <csignal>

#include "recorder/test/painted_eye.h"
#include "recording/recording_history.h"
#include "replay/replay.h"
#include "session_fixture.h"

namespace smile::studio {
namespace {

class SessionRecording : public SessionFixture {};

TEST_F(SessionRecording, ADemonstrationIsRecordedAndReplays) {
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

TEST_F(SessionRecording, SeveralObjectsAreMovedAndCopiedInARecordingThatReplays) {
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

TEST_F(SessionRecording, TheRecordedCameraIsChosenBetweenRecordings) {
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

TEST_F(SessionRecording, TheEyeShowsWhatIsRecordedAndRestsWhenNothingMoves) {
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

TEST_F(SessionRecording, AFullDiskEndsTheRecordingAndTheStateReportsIt) {
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

TEST_F(SessionRecording, ARecordingThatIsRemovedMeanwhileIsLost) {
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

TEST_F(SessionRecording, ARecordingIsGoneOnWithFromAnyOfItsSteps) {
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

TEST_F(SessionRecording, TheWorldContinuesUntilThatOfARecordingIsReady) {
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
TEST_F(SessionRecording, UnfinishedJobsEndWithTheSession) {
  Begin();
  Command(R"({"do":"start","name":"take"})");
  PutAOnB();
  Command(R"({"do":"finish"})");
  ASSERT_TRUE(page::IsLater(BeginToAsk({{"do", "branch"}, {"recording", "take"}, {"step", 2}})));
  session_.reset();
}

TEST_F(SessionRecording, ObjectsOfAShownRecordingCannotBeGrasped) {
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

}  // namespace
}  // namespace smile::studio
