// A user takes over in a recording before it goes wrong.

#include "recording/recording_history.h"
#include "replay/replay.h"
#include "session_fixture.h"

namespace smile::studio {
namespace {

class Correct : public SessionFixture {
 protected:
  /// Records how the left hand puts a on b and the right one takes b.
  /// @returns the time at which it takes b.
  double RecordWrongTake() {
    Command(R"({"do":"start","name":"take","title":"wrong"})");
    PutAOnB();
    Command(R"({"do":"grasp","hand":"right","object":"b"})");
    TickSeconds(1);
    Command(R"({"do":"finish"})");
    const recording::Recording wrong = recording::OpenRecording(root_ / "recordings/take");
    return recording::SecondsInto(wrong, OnPath(HistoryOf(wrong)).at(3).begin.tick);
  }
};

TEST_F(Correct, ARecordingIsTheSameUpToTheMomentAtWhichTheUserTakesOver) {
  Begin();
  const double moment = RecordWrongTake();
  const std::string id =
      AskWith({{"do", "correct"}, {"recording", "take"}, {"seconds", moment}})["recording"];
  EXPECT_EQ(id, "take-corrected");
  EXPECT_EQ(State()["paused"], true);
  EXPECT_EQ(State()["recording"]["corrects"]["title"], "wrong");
  EXPECT_EQ(State()["hands"]["right"]["object"], nullptr)
      << "what comes at that moment is not done";
  Do(R"({"do":"resume"})");
  Command(R"({"do":"grasp","hand":"right","object":"a"})");
  TickSeconds(0.5);
  Command(R"({"do":"finish"})");

  const recording::Recording right = recording::OpenRecording(root_ / "recordings" / id);
  EXPECT_EQ(replay::Replay(right).first_difference, std::nullopt);
  EXPECT_EQ(right.info.corrects, (recording::Correction{"take", moment}));
  EXPECT_EQ(right.info.title, "wrong (corrected)");
  const auto steps = OnPath(HistoryOf(right));
  ASSERT_EQ(steps.size(), 4u);
  EXPECT_EQ(WordsOf(steps[2]), "left hand puts a on b");
  EXPECT_EQ(WordsOf(steps[3]), "right hand takes a");
}

TEST_F(Correct, WhatWasRecordedBeforeCannotBeUndone) {
  Begin();
  const double moment = RecordWrongTake();
  (void)AskWith({{"do", "correct"}, {"recording", "take"}, {"seconds", moment}});
  const auto refused = [this] {
    return Refused(R"({"do":"command","command":{"do":"undo"}})")
               .find("the correction begins here") != std::string::npos;
  };
  EXPECT_TRUE(refused());
  Command(R"({"do":"grasp","hand":"left","object":"a"})");
  Command(R"({"do":"undo"})");
  EXPECT_TRUE(refused());
  Command(R"({"do":"finish"})");
  Command(R"({"do":"undo"})");
}

TEST_F(Correct, AMomentAfterTheEndIsRefusedAndLeavesNothing) {
  Begin();
  Command(R"({"do":"start","name":"take"})");
  PutAOnB();
  Command(R"({"do":"finish"})");
  EXPECT_NE(Refused(R"({"do":"correct","recording":"take","seconds":1000})").find("s long"),
            std::string::npos);
  EXPECT_EQ(State()["recording"], nullptr);
  EXPECT_FALSE(std::filesystem::exists(root_ / "recordings/take-corrected"));
}

}  // namespace
}  // namespace smile::studio
