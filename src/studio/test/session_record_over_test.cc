// A new demonstration is recorded over another one, of which some hands act again.

#include <algorithm>
#include <random>

#include "recording/conflicts.h"
#include "recording/recording_history.h"
#include "replay/replay.h"
#include "session_fixture.h"

namespace smile::studio {
namespace {

class RecordOver : public SessionFixture {
 protected:
  /// Records how the left hand puts a on b and the right one takes b, then begins to record over
  /// it, while the left hand acts.
  /// @returns the id of the new recording.
  std::string RecordOverTheLeftHand() {
    Command(R"({"do":"start","name":"take","title":"both"})");
    PutAOnB();
    Command(R"({"do":"grasp","hand":"right","object":"b"})");
    Command(R"({"do":"finish"})");
    return Do(
        R"({"do":"record_over","recording":"take","hands":["left"],"seconds":0})")["recording"];
  }
};

/// Replays a recording; returns what was done in it and not undone, in words.
std::vector<std::string> DoneIn(const recording::Recording& recording) {
  EXPECT_EQ(replay::Replay(recording).first_difference, std::nullopt);
  std::vector<std::string> done;
  for (const auto& step : recording::HistoryOf(recording)) {
    if (step.is_on_path) done.push_back(WordsOf(step));
  }
  return done;
}

TEST_F(RecordOver, OneHandIsRecordedWhileTheOtherOneActsAgain) {
  Begin();
  const std::string id = RecordOverTheLeftHand();
  EXPECT_EQ(State()["paused"], true);
  EXPECT_EQ(State()["recording"]["over"]["actions_left"], 2);
  Do(R"({"do":"resume"})");
  TickOnce();
  Command(R"({"do":"point","hand":"right","part":"b"})");
  TickSeconds(2.5);
  EXPECT_EQ(State()["hands"]["left"]["object"], nullptr) << "it has put a on b";
  // An undo reverts what the user did, and time: what the other hand did since, it does again.
  Command(R"({"do":"undo"})");
  EXPECT_EQ(State()["hands"]["left"]["object"], "a");
  EXPECT_EQ(State()["recording"]["over"]["actions_left"], 1);
  TickSeconds(1);
  Command(R"({"do":"grasp","hand":"right","object":"b"})");
  TickSeconds(2);
  EXPECT_EQ(State()["recording"]["over"],
            Json::parse(R"({"hands":["left"],"actions_left":0,"conflicts":[]})"));
  Command(R"({"do":"finish"})");
  const recording::Recording kept = recording::OpenRecording(root_ / "recordings" / id);
  EXPECT_EQ(kept.info.title, "both (over)");
  EXPECT_EQ(DoneIn(kept),
            (std::vector<std::string>{"the start", "left hand takes a", "right hand takes b",
                                      "left hand puts a on b"}));
}

TEST_F(RecordOver, WhateverIsUndoneWhileAHandActsAgainTheRecordingReplays) {
  Begin();
  const std::string id = RecordOverTheLeftHand();
  Do(R"({"do":"resume"})");
  std::mt19937 random(5);
  const std::vector<std::string> commands = {R"({"do":"grasp","hand":"right","object":"b"})",
                                             R"({"do":"release","hand":"right"})",
                                             R"({"do":"point","hand":"right","part":"b"})",
                                             R"({"do":"undo"})",
                                             R"({"do":"undo"})",
                                             R"({"do":"redo"})"};
  for (int i = 0; i < 60; ++i) {
    (void)AskWith(
        {{"do", "command"}, {"command", Json::parse(commands[random() % commands.size()])}});
    for (unsigned ticks = random() % 20; ticks > 0; --ticks) TickOnce();
  }
  TickSeconds(4);
  EXPECT_EQ(State()["recording"]["over"],
            Json::parse(R"({"hands":["left"],"actions_left":0,"conflicts":[]})"));
  Command(R"({"do":"finish"})");
  const std::vector<std::string> done = DoneIn(recording::OpenRecording(root_ / "recordings" / id));
  EXPECT_EQ(std::ranges::count(done, "left hand takes a"), 1);
  EXPECT_EQ(std::ranges::count(done, "left hand puts a on b"), 1);
}

TEST_F(RecordOver, WhatIsNoLongerPossibleInARecordingOverAnotherIsSkippedAndTold) {
  Begin();
  EXPECT_NE(Refused(R"({"do":"record_over","recording":"take","hands":["third"],"seconds":0})")
                .find("third"),
            std::string::npos);
  RecordOverTheLeftHand();
  Command(R"({"do":"grasp","hand":"right","object":"a"})");
  Command(R"({"do":"destroy","hand":"right"})");
  Do(R"({"do":"resume"})");
  TickSeconds(1);
  const Json conflicts = State()["recording"]["over"]["conflicts"];
  ASSERT_EQ(conflicts.size(), 1u) << "the moves after it follow from it: " << conflicts;
  EXPECT_EQ(conflicts[0]["hand"], "left");
  EXPECT_EQ(conflicts[0]["reason"], "'a' no longer exists: it was destroyed");
}

TEST_F(RecordOver, WhatTheHandsDoNotFindAsItWasIsKeptWithTheRecording) {
  Begin();
  const std::string id = RecordOverTheLeftHand();
  Command(R"({"do":"grasp","hand":"right","object":"a"})");
  Do(R"({"do":"resume"})");
  TickSeconds(4);
  Command(R"({"do":"finish"})");
  const auto conflicts = recording::ReadConflicts(root_ / "recordings" / id);
  ASSERT_EQ(conflicts.size(), 1u);
  EXPECT_EQ(conflicts[0].hand, sim::HandName::kLeft);
  EXPECT_EQ(conflicts[0].reason, "takes a from the right hand, which holds it now");
  EXPECT_EQ(DoneIn(recording::OpenRecording(root_ / "recordings" / id)).size(), 5u)
      << "the start, both grasps, the release between them, and the last one";
}

}  // namespace
}  // namespace smile::studio
