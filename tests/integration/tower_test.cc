// The main job: shown a tower, the robot builds one from other starting positions.
// tools/tower_layouts.sh does the same for any number of layouts.

#include "program.h"

namespace smile {
namespace {

class Tower : public ProgramTest, public ::testing::WithParamInterface<int> {};

TEST_P(Tower, IsRebuiltFromASeededLayout) {
  const Answer answer =
      Smile("experiment tower --out tower --no-films --json --seed " + std::to_string(GetParam()));
  ASSERT_EQ(answer.exit_code, 0) << answer.err;
  const Json result = answer.json();
  EXPECT_TRUE(result["rebuilt"]);
  EXPECT_EQ(result["score"], 1.0);
  EXPECT_LT(result["mean_error_mm"], 10);
  EXPECT_EQ(result["goal"]["objects"].size(), 3u);
  EXPECT_NE(Read("tower/report.html").find("built one of its own"), std::string::npos);
  for (const char* recording : {"demonstration", "imitation"}) {
    EXPECT_EQ(Smile("replay --verify tower/" + std::string(recording)).exit_code, 0);
  }
}

INSTANTIATE_TEST_SUITE_P(Seeds, Tower, ::testing::Values(1, 2));

}  // namespace
}  // namespace smile
