#include "program.h"

namespace smile {
namespace {

class RecordingAsUsed : public ProgramTest {
 protected:
  RecordingAsUsed() {
    Write("pair.xml", PairOfBlocks());
    Write("stack.jsonl", StackPair());
  }

  /// For the shell: waits until what runs in the background has recorded a good many ticks, or is
  /// gone.
  static std::string UntilSomeIsWritten(const std::string& recording) {
    return "while kill -0 $! && [ -z \"$(find " + recording +
           "/trace.bin -size +8000c 2>/dev/null)\" ]; do sleep 0.1; done; ";
  }
};

TEST_F(RecordingAsUsed, ReplaysIdenticallyWithoutItsScene) {
  ASSERT_EQ(Smile("run pair.xml --commands stack.jsonl --record demo").exit_code, 0);
  std::filesystem::remove(directory_ / "pair.xml");
  const Answer answer = Smile("replay demo --verify --json");
  EXPECT_EQ(answer.exit_code, 0) << answer.err;
  EXPECT_TRUE(answer.json()["identical"]);
  EXPECT_GT(answer.json()["ticks"], 40);
  EXPECT_TRUE(answer.json()["first_difference"].is_null());
}

TEST_F(RecordingAsUsed, HoldsTheClassicView) {
  ASSERT_EQ(Smile("run pair.xml --commands stack.jsonl --record demo").exit_code, 0);
  EXPECT_EQ(Read("demo/0.txt").rfind("0,create,a,shape,block\n0,create,b,shape,block\n", 0), 0u);
  EXPECT_TRUE(Exists("demo/0/0.png"));
  EXPECT_NE(Read("demo/1.txt").find(",grasp,RightHand,a\n"), std::string::npos);
  EXPECT_NE(Read("demo/2.txt").find(",release,RightHand\n"), std::string::npos);
}

TEST_F(RecordingAsUsed, ADifferenceIsNamedAndIsExitCodeOne) {
  ASSERT_EQ(Smile("run pair.xml --commands stack.jsonl --record demo").exit_code, 0);
  ASSERT_EQ(Shell("sed -i 's/-3.0,2.5/-3.0,2.6/' demo/commands.jsonl").exit_code, 0);
  const Answer answer = Smile("replay demo --verify --json");
  EXPECT_EQ(answer.exit_code, 1);
  EXPECT_EQ(answer.json()["first_difference"]["object"], "a");
  EXPECT_EQ(Smile("replay demo").exit_code, 0);
}

TEST_F(RecordingAsUsed, DifferencesToAnotherVersionAreReported) {
  ASSERT_EQ(Smile("run pair.xml --commands stack.jsonl --record demo").exit_code, 0);
  ASSERT_EQ(Shell("sed -i 's/-3.0,2.5/-3.0,2.6/' demo/commands.jsonl").exit_code, 0);
  // This program's own recording ends at the first difference.
  EXPECT_TRUE(Smile("replay demo --verify --json").json()["differences"].empty());
  ASSERT_EQ(Shell("sed -i 's/\"smile [^\"]*/\"smile 0.0.1/' demo/demo.json").exit_code, 0);
  const Answer answer = Smile("replay demo --verify --json");
  EXPECT_EQ(answer.exit_code, 1);
  EXPECT_EQ(answer.err.find("demo: was made by smile 0.0.1; this program is smile "), 0u);
  const Json difference = answer.json()["differences"][0];
  EXPECT_EQ(difference["object"], "a");
  EXPECT_NEAR(difference["largest_mm"].get<double>(), 10, 0.5);
  EXPECT_LT(difference["end_mm"], 1);
  EXPECT_NE(Smile("replay demo").out.find("\n  a: 10 mm and 0 degrees apart at tick "),
            std::string::npos);
}

TEST_F(RecordingAsUsed, ComparesARangeAndReportsIt) {
  ASSERT_EQ(Smile("run pair.xml --seconds 2 --record demo").exit_code, 0);
  EXPECT_EQ(Smile("replay demo --verify --from 0.5 --to 1.5").out,
            "demo: identical, 60 ticks from 0.50 s to 1.50 s\n");
  const Answer answer = Smile("replay demo --to 3");
  EXPECT_EQ(answer.exit_code, 2);
  EXPECT_EQ(answer.err, "smile: to is 3 s, but the recording is 2 s long\n");
}

TEST_F(RecordingAsUsed, IsNeverOverwritten) {
  ASSERT_EQ(Smile("run pair.xml --seconds 1 --record demo").exit_code, 0);
  const Answer again = Smile("run pair.xml --seconds 1 --record demo");
  EXPECT_EQ(again.exit_code, 1);
  EXPECT_EQ(again.err,
            "demo: exists already, expected a new directory; recordings are never overwritten\n");
}

TEST_F(RecordingAsUsed, AFailedScriptKeepsWhatWasRecorded) {
  Write("bad.jsonl", StackPair() + "{\"hand\":\"left\",\"do\":\"grasp\",\"object\":\"z\"}\n");
  EXPECT_EQ(Smile("run pair.xml --commands bad.jsonl --record demo").exit_code, 1);
  const Answer answer = Smile("replay demo --verify --json");
  EXPECT_EQ(answer.exit_code, 0) << answer.err;
  EXPECT_GT(answer.json()["ticks"], 40);
}

TEST_F(RecordingAsUsed, SurvivesBeingKilledAndEndsCleanlyOnRequest) {
  const Answer killed =
      Shell("\"" SMILE_PROGRAM "\" run pair.xml --seconds 600 --realtime --record killed & " +
            UntilSomeIsWritten("killed") + "kill -9 $!; wait");
  EXPECT_GT(Smile("replay killed --verify --json").json()["ticks"], 10);

  const Answer asked =
      Shell("\"" SMILE_PROGRAM "\" run pair.xml --seconds 600 --realtime --record asked --json & " +
            UntilSomeIsWritten("asked") + "kill -TERM $!; wait $!");
  EXPECT_EQ(asked.exit_code, 0) << asked.err;
  EXPECT_LT(asked.json()["ticks"], 36000) << "it did not wait for its end";
  EXPECT_EQ(Smile("replay asked --verify").exit_code, 0);
}

TEST_F(RecordingAsUsed, RecordingsOfTheOriginalCanBeImportedAndRendered) {
  ASSERT_EQ(Smile("run pair.xml --commands stack.jsonl --record demo").exit_code, 0);
  ASSERT_EQ(Shell("mkdir classic; cp -r demo/[0-9]* classic").exit_code, 0);
  const Answer blocks = Smile("import classic --out blocks");
  EXPECT_EQ(blocks.exit_code, 0);
  EXPECT_EQ(blocks.err,
            "classic: without its scene, every object is shown as a block; name the scene with "
            "--scene\n");
  const Answer imported = Smile("import classic --scene pair.xml --out imported --json");
  EXPECT_EQ(imported.exit_code, 0) << imported.err;
  EXPECT_EQ(imported.json()["objects"], 2);
  EXPECT_EQ(imported.json()["segments"], 3);
  EXPECT_EQ(Smile("render imported --out end.png --size 64x48").exit_code, 0);
  EXPECT_EQ(Smile("replay imported").exit_code, 1);

  ASSERT_EQ(Shell("echo 99,vanish,a >>classic/2.txt").exit_code, 0);
  const Answer wrong = Smile("import classic --out wrong");
  EXPECT_EQ(wrong.exit_code, 1);
  EXPECT_NE(wrong.err.find("classic/2.txt:"), std::string::npos) << wrong.err;
  EXPECT_FALSE(Exists("wrong"));
}

TEST_F(RecordingAsUsed, AFolderWithoutARecordingIsReported) {
  const Answer answer = Smile("replay . --verify");
  EXPECT_EQ(answer.exit_code, 1);
  EXPECT_EQ(answer.err, ".: is not a recording; expected a directory with a demo.json in it\n");
}

}  // namespace
}  // namespace smile
