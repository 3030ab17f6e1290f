#include <cstring>
#include <sstream>

#include "program.h"

namespace smile {
namespace {

class RenderAsUsed : public ProgramTest {
 protected:
  /// The lines of a table without its head, as words.
  std::vector<std::vector<std::string>> Table(const std::string& name) const {
    std::istringstream text(Read(name));
    std::vector<std::vector<std::string>> table;
    std::string line;
    for (std::getline(text, line); std::getline(text, line);) {
      std::istringstream words(line + ",");
      table.emplace_back();
      for (std::string word; std::getline(words, word, ',');) table.back().push_back(word);
    }
    return table;
  }
};

TEST_F(RenderAsUsed, DrawsScenesAndFilmsRecordings) {
  Write("pair.xml", PairOfBlocks());
  Write("stack.jsonl", StackPair());
  EXPECT_EQ(Smile("render pair.xml --out pair.png --size 320x200 --channels rgb,depth,id").out,
            "pair.png\npair.depth.png\npair.id.png\n");
  EXPECT_TRUE(Exists("pair.id.png"));
  // Where the preset stands, in the scene's units.
  ASSERT_EQ(Smile("render pair.xml --camera front --out front.png --size 64x48").exit_code, 0);
  ASSERT_EQ(Smile("render pair.xml --camera 0,23,9:0,-3,2 --out same.png --size 64x48").exit_code,
            0);
  EXPECT_TRUE(Read("same.png") == Read("front.png"));
  ASSERT_EQ(Smile("run pair.xml --commands stack.jsonl --record demo").exit_code, 0);
  EXPECT_EQ(Smile("render demo --out demo.png --camera eye --size 64x48").exit_code, 0);
  EXPECT_EQ(Smile("render demo --out demo.mp4 --size 160x120 --rate 10").exit_code, 0);
  EXPECT_GT(std::filesystem::file_size(directory_ / "demo.mp4"), 1000u);
}

TEST_F(RenderAsUsed, FilmsAgainWhatTheEyeSawToTheLastBit) {
  Write("pair.xml", PairOfBlocks());
  Write("stack.jsonl", StackPair());
  ASSERT_EQ(
      Smile("run pair.xml --commands stack.jsonl --size 160x120 --rate 7 --record demo").exit_code,
      0);
  ASSERT_EQ(Smile("render demo --out again/ --camera eye --size 160x120 --rate 7").exit_code, 0);
  const auto recorded = Table("demo/frames.csv"), again = Table("again/frames.csv");
  ASSERT_EQ(again.size(), recorded.size());
  int num_pictures = 0;
  for (std::size_t k = 0; k < again.size(); ++k) {
    EXPECT_EQ(again[k][1], recorded[k][1]) << "tick of frame " << k;
    const std::string& picture = recorded[k][2];
    if (picture.empty()) continue;
    ++num_pictures;
    EXPECT_TRUE(Read("again/" + again[k][3]) == Read("demo/" + picture)) << picture;
  }
  EXPECT_GT(num_pictures, 5);
}

TEST_F(RenderAsUsed, DrawsAgainWhatTheRealEyeSaw) {
  Write("pair.xml", PairOfBlocks());
  Write("stack.jsonl", StackPair() + "{\"do\":\"joint_angles\",\"head\":0.3}\n");
  ASSERT_EQ(
      Smile("run pair.xml --commands stack.jsonl --eye head --rate 7 --record demo").exit_code, 0);
  EXPECT_EQ(Json::parse(Read("demo/demo.json"))["eye"]["camera"], "head");
  EXPECT_EQ(Json::parse(Read("demo/demo.json"))["eye"]["height_px"], 400);
  ASSERT_EQ(Smile("edit demo --speed 1 --out edited").exit_code, 0);
  ASSERT_EQ(Smile("render demo --out again/ --camera eye --size 640x400 --rate 7").exit_code, 0);
  ASSERT_EQ(Smile("render demo --out head/ --camera head --size 640x400 --rate 7").exit_code, 0);
  const auto recorded = Table("demo/frames.csv"), again = Table("again/frames.csv");
  ASSERT_EQ(again.size(), recorded.size());
  int num_pictures = 0;
  for (std::size_t k = 0; k < again.size(); ++k) {
    const std::string& picture = recorded[k][2];
    if (picture.empty()) continue;
    ++num_pictures;
    EXPECT_TRUE(Read("again/" + again[k][3]) == Read("demo/" + picture)) << picture;
    EXPECT_TRUE(Read("head/" + again[k][3]) == Read("demo/" + picture)) << picture;
    EXPECT_TRUE(Read("edited/" + picture) == Read("demo/" + picture)) << picture;
  }
  EXPECT_GT(num_pictures, 5);
}

TEST_F(RenderAsUsed, RendersThroughEveryCamera) {
  Write("pair.xml", SceneOf("<block id='a' location='(0,-3,0.5)'/>"
                            "<camera id='overhead' location='(0,0,20)' target='(0,0,0)'/>"));
  for (const std::string camera : {"eye", "head", "left_hand", "right_hand", "overhead"}) {
    const Answer answer =
        Smile("render pair.xml --size 64x40 --camera " + camera + " --out " + camera + ".png");
    EXPECT_EQ(answer.exit_code, 0) << answer.err;
  }
  EXPECT_NE(Read("eye.png"), Read("head.png"));
  EXPECT_NE(Read("left_hand.png"), Read("right_hand.png"));
  EXPECT_EQ(Smile("render pair.xml --no-robot --camera overhed --out x.png").err,
            "smile: camera is \"overhed\", expected eye, overhead, close, nice, front, left, right "
            "or top, or FROM:TO[:FOV] like 8,4,6:0,-3,1:40; did you mean \"overhead\"?\n");
  EXPECT_EQ(Smile("run pair.xml --no-robot --eye head --record x --seconds 0").err,
            "smile: camera is \"head\", expected eye or overhead\n");
  EXPECT_FALSE(Exists("x"));
}

TEST_F(RenderAsUsed, FilmsARangeOfARecordingThatBeganLate) {
  Write("pair.xml", PairOfBlocks());
  Write("stack.jsonl", StackPair());
  ASSERT_EQ(Smile("run pair.xml --no-robot --commands stack.jsonl --record demo").exit_code, 0);
  const std::string film = "render demo --camera 0,-12,6:1,-3,0.5:30 --size 64x48 ";
  ASSERT_EQ(Smile(film + "--out early/ --from 0.5 --to 1 --rate 10").exit_code, 0);
  std::filesystem::rename(directory_ / "demo", directory_ / "at_once");
  Write("late.jsonl", "{\"tick\":1000,\"do\":\"start\",\"name\":\"demo\"}\n" + StackPair());
  ASSERT_EQ(Smile("run pair.xml --no-robot --commands late.jsonl --recordings .").exit_code, 0);
  ASSERT_EQ(
      Smile(film + "--out late/ --from 0.5 --to 1 --rate 10 --channels rgb,depth,id").exit_code, 0);
  const auto late = Table("late/frames.csv");
  ASSERT_EQ(late.size(), 6u);
  EXPECT_EQ(late[1], (std::vector<std::string>{"1", "1036", "0.6", "000001.png"}));
  EXPECT_TRUE(Exists("late/000005.depth.png") && Exists("late/000005.id.png"));
  EXPECT_NE(Read("late/000000.png"), Read("late/000005.png"));
  for (const auto& row : late) EXPECT_TRUE(Read("late/" + row[3]) == Read("early/" + row[3]));

  ASSERT_EQ(Smile(film + "--out at.png --at 0.6").exit_code, 0);
  EXPECT_TRUE(Read("at.png") == Read("late/000001.png"));
  EXPECT_EQ(Smile(film + "--out late.mp4 --rate 10").exit_code, 0);
  EXPECT_GT(std::filesystem::file_size(directory_ / "late.mp4"), 1000u);
}

TEST_F(RenderAsUsed, ReportsInvalidRequests) {
  Write("pair.xml", PairOfBlocks());
  const Answer camera = Smile("render pair.xml --out x.png --camera moon");
  EXPECT_EQ(camera.exit_code, 2);
  EXPECT_EQ(
      camera.err,
      "smile: camera is \"moon\", expected eye, head, left_hand, right_hand, close, nice, front, "
      "left, right or top, or FROM:TO[:FOV] like 8,4,6:0,-3,1:40\n");
  const auto complaint = [this](const std::string& arguments) {
    return Smile("render " + arguments + " --size 64x48").err;
  };
  EXPECT_EQ(complaint("pair.xml --out x.png --camera 1,2,3:4,five,6"),
            "smile: camera is \"1,2,3:4,five,6\": \"five\" is not a number from -10000 to 10000\n");
  EXPECT_EQ(complaint("pair.xml --out x.png --camera 1,2:4,5,6"),
            "smile: camera is \"1,2:4,5,6\": \"1,2\" is not a point x,y,z\n");
  EXPECT_EQ(complaint("pair.xml --out x.png --camera 1,2,3:1,2,3"),
            "smile: camera is \"1,2,3:1,2,3\": it looks at its own position\n");
  EXPECT_EQ(complaint("pair.xml --out x.png --at 1"),
            "smile: --at needs a recording, but 'pair.xml' is not one\n");
  ASSERT_EQ(Smile("run pair.xml --seconds 1 --record demo").exit_code, 0);
  EXPECT_EQ(complaint("demo --out x.png --at 1.5"),
            "smile: at is 1.5 s, but the recording is 1 s long\n");
  EXPECT_EQ(complaint("demo --out x.mp4 --at 1"),
            "smile: --at is for a picture; a film has --from and --to\n");
  EXPECT_EQ(complaint("demo --out demo"),
            "demo: exists already, expected a new directory; pictures are never overwritten\n");
  EXPECT_EQ(complaint("demo --out new --frames --camera moon").find("smile: camera is"), 0u);
  EXPECT_FALSE(Exists("new"));
  EXPECT_EQ(Smile("render pair.xml --out x.gif").exit_code, 2);
  EXPECT_EQ(Smile("render pair.xml --out x.mp4").exit_code, 2);
  EXPECT_EQ(Smile("render nowhere --out x.png").exit_code, 1);
  EXPECT_EQ(Smile("render pair.xml --out /dev/null/x.png").exit_code, 3);
}

}  // namespace
}  // namespace smile
