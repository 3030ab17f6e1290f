#include "program.h"

namespace smile {
namespace {

class RenderAsUsed : public ProgramTest {};

TEST_F(RenderAsUsed, DrawsScenesAndFilmsRecordings) {
  Write("pair.xml", PairOfBlocks());
  Write("stack.jsonl", StackPair());
  EXPECT_EQ(Smile("render pair.xml --out pair.png --size 320x200 --channels rgb,depth,id").out,
            "pair.png\npair.depth.png\npair.id.png\n");
  EXPECT_TRUE(Exists("pair.id.png"));
  ASSERT_EQ(Smile("run pair.xml --commands stack.jsonl --record demo").exit_code, 0);
  EXPECT_EQ(Smile("render demo --out demo.png --camera eye --size 64x48").exit_code, 0);
  EXPECT_EQ(Smile("render demo --out demo.mp4 --size 160x120 --rate 10").exit_code, 0);
  EXPECT_GT(std::filesystem::file_size(directory_ / "demo.mp4"), 1000u);
}

TEST_F(RenderAsUsed, SaysWhatItCannotDo) {
  Write("pair.xml", PairOfBlocks());
  const Answer camera = Smile("render pair.xml --out x.png --camera moon");
  EXPECT_EQ(camera.exit_code, 2);
  EXPECT_EQ(camera.err,
            "smile: camera is 'moon', expected one of eye, close, nice, front, left, right, top\n");
  EXPECT_EQ(Smile("render pair.xml --out x.gif").exit_code, 2);
  EXPECT_EQ(Smile("render pair.xml --out x.mp4").exit_code, 2);
  EXPECT_EQ(Smile("render nowhere --out x.png").exit_code, 1);
  EXPECT_EQ(Smile("render pair.xml --out /dev/null/x.png").exit_code, 3);
}

}  // namespace
}  // namespace smile
