// Objects come and go while a scene runs and is recorded, as a user does it.

#include "program.h"

namespace smile {
namespace {

class SpawnAsUsed : public ProgramTest {
 protected:
  void Record() {
    const std::string script = std::string(SMILE_SOURCE_DIR) + "/tests/golden/scripts/spawn.jsonl";
    const Answer run = Smile("run '" + Shipped("scenes/tower.xml") + "' --commands '" + script +
                             "' --recordings . --no-robot --no-pictures");
    ASSERT_EQ(run.exit_code, 0) << run.err;
  }
};

TEST_F(SpawnAsUsed, TheRecordingReplaysAndReportsAddedAndRemovedObjects) {
  Record();
  const Answer replay = Smile("replay spawn --verify --json");
  ASSERT_EQ(replay.exit_code, 0) << replay.err << replay.out;
  EXPECT_TRUE(replay.json().at("identical").get<bool>());
  const Answer history = Smile("history spawn");
  ASSERT_EQ(history.exit_code, 0) << history.err;
  for (const char* words :
       {"added Panel\n", "left hand takes smallblock_3\n", "added ball_1 (undone)\n",
        "added ring_1\n", "removed RedBlock\n", "cleared the table of 6 objects (undone)\n"}) {
    EXPECT_NE(history.out.find(words), std::string::npos) << words << history.out;
  }
  EXPECT_EQ(Smile("describe spawn").exit_code, 0);
  // The classic view, too, has a segment for each of them.
  const std::string added = Read("spawn/1.txt");
  EXPECT_NE(added.find(",create,Panel,"), std::string::npos) << added;
  EXPECT_NE(added.find(",initializeControl,Lamp,indicatorLights,Panel,off"), std::string::npos);
  std::filesystem::remove(directory_ / "spawn/demo.json");
  const Answer imported = Smile("import spawn --out imported && smile history imported");
  EXPECT_EQ(imported.exit_code, 0) << imported.err;
}

TEST_F(SpawnAsUsed, EachMomentIsSeenWithWhatWasThere) {
  Record();
  ASSERT_EQ(Smile("render spawn --at 0 --size 80x60 --out first.png").exit_code, 0);
  const Answer last = Smile("render spawn --size 80x60 --out last.png");
  ASSERT_EQ(last.exit_code, 0) << last.err;
  EXPECT_NE(Read("first.png"), Read("last.png"));
  const Answer film = Smile("render spawn --size 80x60 --rate 5 --out film.mp4");
  EXPECT_EQ(film.exit_code, 0) << film.err;
}

TEST_F(SpawnAsUsed, TheRecordingIsEditedAndGoneOnWith) {
  Record();
  // Without the panel the switch cannot be pressed.
  const Answer edit = Smile("edit spawn --drop 1 --out edited --no-pictures --json");
  ASSERT_EQ(edit.exit_code, 0) << edit.err;
  EXPECT_NE(edit.out.find("there is no control 'Power'"), std::string::npos) << edit.out;
  EXPECT_NE(edit.out.find("\"Panel\""), std::string::npos) << edit.out;
  EXPECT_EQ(Smile("replay edited --verify").exit_code, 0);
  // Step 3 was undone: what was added in it is there again, and under its name.
  Write("more.jsonl", R"({"hand":"right","do":"grasp","object":"ball_1"}
{"do":"add","preset":"ball"}
{"do":"wait","seconds":0.2}
)");
  const Answer went_on = Smile("checkout spawn --at 3 --commands more.jsonl --json");
  ASSERT_EQ(went_on.exit_code, 0) << went_on.err;
  EXPECT_EQ(Smile("replay spawn --verify").exit_code, 0);
  const Json steps = Smile("history spawn --json").json()["steps"];
  EXPECT_EQ(steps.back()["words"], "added ball_2");
  EXPECT_EQ(steps.back()["deed"]["hand"], Json());
}

}  // namespace
}  // namespace smile
