// Start, undo, redo, finish, and going on, as a user does it.

#include "program.h"

namespace smile {
namespace {

class HistoryAsUsed : public ProgramTest {
 protected:
  HistoryAsUsed() { Write("pair.xml", PairOfBlocks()); }
};

constexpr const char* kSecondThoughts = R"({"do":"start","name":"take","title":"Second thoughts"}
{"hand":"left","do":"grasp","object":"a"}
{"hand":"left","do":"move_to","position":[0,-3,3]}
{"do":"wait","until":"arrived"}
{"hand":"left","do":"release"}
{"do":"wait","seconds":0.5}
{"do":"undo"}
{"hand":"left","do":"move_to","position":[2,-3,1.51]}
{"do":"wait","until":"arrived"}
{"hand":"left","do":"release"}
{"do":"wait","seconds":0.5}
{"do":"undo"}
{"do":"redo"}
{"do":"finish"}
{"hand":"right","do":"grasp","object":"b"}
)";

TEST_F(HistoryAsUsed, AScriptStartsUndoesRedoesAndFinishes) {
  Write("thoughts.jsonl", kSecondThoughts);
  for (int i = 0; i < 2; ++i) {
    const Answer run = Smile("run pair.xml --commands thoughts.jsonl --recordings kept --json");
    ASSERT_EQ(run.exit_code, 0) << run.err;
    EXPECT_EQ(run.json()["recordings"], Json({i == 0 ? "kept/take" : "kept/take-2"}));
  }
  EXPECT_EQ(Smile("replay kept/take --verify").exit_code, 0);
  const Answer history = Smile("history kept/take");
  EXPECT_EQ(history.exit_code, 0) << history.err;
  EXPECT_NE(history.out.find("left hand takes a\n"), std::string::npos);
  EXPECT_NE(history.out.find("left hand drops a on the table (undone)\n"), std::string::npos);
  // The classic view knows of one release.
  EXPECT_TRUE(Exists("kept/take/2.txt"));
  EXPECT_FALSE(Exists("kept/take/3.txt"));
}

TEST_F(HistoryAsUsed, NamesWhatContactAndTheToolsOfARobotDid) {
  const std::filesystem::path golden =
      std::filesystem::path(SMILE_SOURCE_DIR) / "tests/golden/recordings";
  const Answer press = Smile("history '" + (golden / "robot_press").string() + "'");
  EXPECT_NE(press.out.find("Power pressed by arm gripper\n"), std::string::npos) << press.out;
  const Json steps =
      Smile("history '" + (golden / "robot_cut").string() + "' --json").json()["steps"];
  ASSERT_EQ(steps.size(), 3u);
  EXPECT_TRUE(steps[0]["effects"].empty());
  ASSERT_EQ(steps[1]["effects"].size(), 1u);
  EXPECT_EQ(steps[1]["effects"][0]["words"],
            "arm gripper cuts String between link 0 and 1 with Snips");
  EXPECT_GT(steps[1]["effects"][0]["at"].get<double>(), 1);
}

TEST_F(HistoryAsUsed, ACheckoutContinuesFromAnyStepAndKeepsAllOthers) {
  Write("thoughts.jsonl", kSecondThoughts);
  Write("more.jsonl", R"({"hand":"right","do":"grasp","object":"b"}
{"do":"wait","seconds":0.2}
)");
  ASSERT_EQ(Smile("run pair.xml --commands thoughts.jsonl --recordings . --no-robot").exit_code, 0);
  const Answer went_on = Smile("checkout take --at 2 --commands more.jsonl --json");
  ASSERT_EQ(went_on.exit_code, 0) << went_on.err;
  EXPECT_EQ(Smile("replay take --verify").exit_code, 0);
  const Json steps = Smile("history take --json").json()["steps"];
  ASSERT_EQ(steps.size(), 5u);
  EXPECT_EQ(steps[4]["words"], "right hand takes b");
  EXPECT_EQ(steps[4]["deed"]["hand"], "right");
  EXPECT_EQ(steps[4]["parent"], 2);
  EXPECT_TRUE(steps[2]["on_way"]);
  EXPECT_FALSE(steps[3]["on_way"]);

  // Back to what was left, in the middle of a step.
  ASSERT_EQ(Smile("checkout take --at 1 --after 0.25").exit_code, 0);
  EXPECT_EQ(Smile("replay take --verify --json").json()["ticks"], 15);
  EXPECT_EQ(Smile("checkout take --at 9").err,
            "smile: take has no step 9, expected 0 to 4 (see: smile history)\n");
}

TEST_F(HistoryAsUsed, PicturesAndSymbolsMayBeLeftOut) {
  ASSERT_EQ(Smile("run pair.xml --seconds 0.5 --record text --no-pictures").exit_code, 0);
  EXPECT_TRUE(Exists("text/0.txt"));
  EXPECT_FALSE(Exists("text/0/0.png"));
  ASSERT_EQ(Smile("run pair.xml --seconds 0.5 --record seen --no-symbols --size 40x30").exit_code,
            0);
  EXPECT_FALSE(Exists("seen/0.txt"));
  EXPECT_TRUE(Exists("seen/0/0.png"));
}

TEST_F(HistoryAsUsed, AFileSizeLimitIsReportedAndTheCompletePartOpens) {
  // The shell's limit counts kilobytes of one file.
  const Answer full = Shell(
      "ulimit -f 60; smile run pair.xml --seconds 60 --record demo "
      "--no-pictures --no-robot");
  EXPECT_EQ(full.exit_code, 3);
  EXPECT_EQ(full.err, "smile: demo/trace.bin: cannot be written: File too large\n");
  const Answer replay = Smile("replay demo --verify");
  EXPECT_EQ(replay.exit_code, 0) << replay.err;
  EXPECT_NE(replay.err.find("was cut"), std::string::npos);
}

TEST_F(HistoryAsUsed, AFullDiskIsReportedAndTheCompletePartOpens) {
  if (Shell("unshare -rm true").exit_code != 0) GTEST_SKIP() << "file systems cannot be made here";
  Write("fill.sh", R"(mkdir small && mount -t tmpfs -o size=400k tmpfs small || exit 99
smile() { ")" SMILE_PROGRAM R"(" "$@"; }
smile run pair.xml --seconds 600 --record small/demo --size 40x30
code=$?
smile replay small/demo --verify --json && smile history small/demo >history.txt
exit $code
)");
  const Answer full = Shell("unshare -rm bash fill.sh");
  if (full.exit_code == 99) GTEST_SKIP() << "file systems cannot be made here";
  EXPECT_EQ(full.exit_code, 3) << full.err;
  EXPECT_NE(full.err.find("cannot be written: No space left on device"), std::string::npos)
      << full.err;
  EXPECT_TRUE(full.json()["identical"]);
  EXPECT_GT(full.json()["ticks"], 100);
  EXPECT_EQ(Read("history.txt"), "*   0     0.00 s  the start\n");
}

}  // namespace
}  // namespace smile
