#include "program.h"

namespace smile {
namespace {

class EditAsUsed : public ProgramTest {
 protected:
  EditAsUsed() {
    Write("pair.xml", PairOfBlocks());
    Write("stack.jsonl", StackPair());
    EXPECT_EQ(Smile("run pair.xml --commands stack.jsonl --record demo --size 32x24 --title stack")
                  .exit_code,
              0);
  }
};

TEST_F(EditAsUsed, MakesANewRecordingAndReportsTheResult) {
  const Answer brisk = Smile("edit demo --max-pause 0.1 --retime 1:9 --out brisk --json");
  EXPECT_EQ(brisk.exit_code, 0) << brisk.err;
  EXPECT_TRUE(brisk.json()["ends_the_same"]);
  EXPECT_GT(brisk.json()["seconds_after"], 9);
  EXPECT_EQ(Smile("replay brisk --verify").exit_code, 0);
  EXPECT_TRUE(Exists("brisk/0/0.png"));
  const Json info = Json::parse(Read("brisk/demo.json"));
  EXPECT_EQ(info["origin"], "edited");
  EXPECT_EQ(info["title"], "stack");
  EXPECT_EQ(info["eye"]["width_px"], 32);

  const Answer again = Smile("edit brisk --drop 1 --out brisk");
  EXPECT_EQ(again.exit_code, 1);
  EXPECT_EQ(again.err,
            "brisk: exists already, expected a new directory; recordings are never overwritten\n");
}

TEST_F(EditAsUsed, EditsInTheOrderTyped) {
  const auto seconds_after = [this](const std::string& edits) {
    return Smile("edit demo --dry-run --json " + edits).json()["seconds_after"].get<double>();
  };
  EXPECT_DOUBLE_EQ(seconds_after("--drop 0 --drop 2 --retime 1:3 --speed 2"), 1.5);
  EXPECT_DOUBLE_EQ(seconds_after("--speed 2 --drop 0 --drop 2 --retime 1:3"), 3);
}

TEST_F(EditAsUsed, ADryRunWritesNothing) {
  const Answer answer = Smile("edit demo --drop 1 --out new --dry-run");
  EXPECT_EQ(answer.exit_code, 0) << answer.err;
  EXPECT_NE(answer.out.find("line 5 of the log is skipped: the right hand holds nothing\n"),
            std::string::npos)
      << answer.out;
  EXPECT_NE(answer.out.find("a ends 223.6 mm and 0.0 degrees from its previous pose\n"),
            std::string::npos)
      << answer.out;
  EXPECT_FALSE(Exists("new"));
}

TEST_F(EditAsUsed, ReportsInvalidEdits) {
  const auto complaint = [this](const std::string& arguments) {
    const Answer answer = Smile("edit demo " + arguments);
    EXPECT_EQ(answer.exit_code, 2) << arguments;
    return answer.err;
  };
  EXPECT_EQ(complaint("--dry-run --drop 9"), "smile: --drop 9: segment is 9, expected 0 to 2\n");
  EXPECT_EQ(complaint("--dry-run --trim 1:2"),
            "smile: --trim: found \"1:2\", expected the number of a segment and the seconds to "
            "keep, like 3:0.5-2\n");
  EXPECT_EQ(complaint("--dry-run --speed nan"),
            "smile: --speed nan: factor is NaN, expected 0.01 to 100\n");
  EXPECT_EQ(complaint("--drop 1"),
            "smile: the result has no destination: give --out or --dry-run\n");
}

}  // namespace
}  // namespace smile
