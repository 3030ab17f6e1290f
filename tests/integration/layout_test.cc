// Random starting positions: written by `smile layout`, used by `smile imitate`.

#include "program.h"

namespace smile {
namespace {

class Layout : public ProgramTest {};

TEST_F(Layout, ASeedGivesTheSameSceneAndNothingIsOverwritten) {
  const std::string of_seed = "layout " + Shipped("scenes/row_robot.xml") + " --seed ";
  ASSERT_EQ(Smile(of_seed + "5 --level stacked --out a.xml").exit_code, 0);
  ASSERT_EQ(Smile(of_seed + "5 --level stacked --out b.xml").exit_code, 0);
  ASSERT_EQ(Smile(of_seed + "6 --level stacked --out c.xml").exit_code, 0);
  EXPECT_EQ(Read("a.xml"), Read("b.xml"));
  EXPECT_NE(Read("a.xml"), Read("c.xml"));
  const std::string before = Read("a.xml");
  const Answer again = Smile(of_seed + "6 --out a.xml");
  EXPECT_EQ(again.exit_code, 1);
  EXPECT_NE(again.err.find("a.xml"), std::string::npos) << again.err;
  EXPECT_NE(again.err.find("exists already"), std::string::npos) << again.err;
  EXPECT_EQ(Read("a.xml"), before);
}

TEST_F(Layout, MeshesAreIncluded) {
  std::filesystem::create_directories(directory_ / "new");
  ASSERT_EQ(Smile("layout " + Shipped("scenes/meshes.xml") + " --seed 1 --out new/m.xml").exit_code,
            0);
  EXPECT_EQ(Smile("check new/m.xml").exit_code, 0);
  const Answer second = Smile("layout new/m.xml --seed 2 --out new/n.xml");
  EXPECT_EQ(second.exit_code, 1) << "the meshes of another scene are there";
  EXPECT_FALSE(Exists("new/n.xml"));
}

TEST_F(Layout, MisuseHasItsOwnExitCode) {
  const std::string scene = Shipped("scenes/row_robot.xml");
  EXPECT_EQ(Smile("layout " + scene + " --out a.xml").exit_code, 2);
  EXPECT_EQ(Smile("layout " + scene + " --seed 1 --level hard --out a.xml").exit_code, 2);
  const Answer fixed = Smile("layout " + Shipped("scenes/dial.xml") + " --seed 1 --out a.xml");
  EXPECT_EQ(fixed.exit_code, 2);
  EXPECT_NE(fixed.err.find("no object in 'dial' stands loose"), std::string::npos) << fixed.err;
  EXPECT_FALSE(Exists("a.xml"));
}

TEST_F(Layout, AnImitationBeginsThere) {
  Write("pair.xml", PairOfBlocks());
  Write("stack.jsonl", StackPair());
  ASSERT_EQ(Smile("run pair.xml --commands stack.jsonl --record demo --no-pictures").exit_code, 0);
  ASSERT_EQ(Smile("layout pair.xml --seed 8 --level touching --out there.xml").exit_code, 0);
  const std::string brain =
      std::filesystem::path(SMILE_PROGRAM).replace_filename("smile_wave").string();
  const std::string imitate = " --brain '" + brain + "' --seconds 0.1 --no-pictures --json ";
  const Answer seeded =
      Smile("imitate demo pair.xml --seed 8 --level touching --out seeded" + imitate);
  const Answer written = Smile("imitate demo there.xml --out written" + imitate);
  ASSERT_EQ(seeded.exit_code, 0) << seeded.err;
  EXPECT_EQ(seeded.json()["initial"], written.json()["initial"]);
  EXPECT_NE(seeded.json()["initial"]["objects"]["a"]["position"], Json({0, -3, 0.5}));
  EXPECT_TRUE(Exists("seeded/imitation/0.txt"));
  EXPECT_FALSE(Exists("seeded/imitation/0.png"));
}

}  // namespace
}  // namespace smile
