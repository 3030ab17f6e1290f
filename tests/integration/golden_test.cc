// The recordings of tests/golden/recordings, made once by an earlier version of the program
// (tools/make_golden_recordings.sh): they open, replay to the same bits, and can be looked at, for
// ever.

#include <algorithm>
#include <vector>

#include "program.h"

namespace smile {
namespace {

/// An imported recording holds what was seen, but no commands to replay.
constexpr const char* kImported = "imported";

std::filesystem::path GoldenFolder() {
  return std::filesystem::path(SMILE_SOURCE_DIR) / "tests/golden/recordings";
}

std::vector<std::string> GoldenRecordings() {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(GoldenFolder())) {
    if (entry.is_directory()) names.push_back(entry.path().filename());
  }
  std::ranges::sort(names);
  return names;
}

class GoldenRecording : public ProgramTest, public ::testing::WithParamInterface<std::string> {
 protected:
  static std::string Recording() { return "'" + (GoldenFolder() / GetParam()).string() + "'"; }
};

TEST_P(GoldenRecording, ReplaysToTheSameBits) {
  const Answer replay = Smile("replay " + Recording() + " --verify --json");
  if (GetParam() == kImported) {
    EXPECT_NE(replay.err.find("no commands to replay"), std::string::npos) << replay.err;
    return;
  }
  ASSERT_EQ(replay.exit_code, 0) << replay.err << replay.out;
  EXPECT_TRUE(replay.json().at("identical").get<bool>());
  EXPECT_GT(replay.json().at("ticks").get<int>(), 0);
}

TEST_P(GoldenRecording, CanBeLookedAt) {
  const Answer look =
      Smile("history " + Recording() + " --json && smile render " + Recording() +
            " --size 64x48 --out picture.png && smile describe " + Recording() + " --json");
  // A demonstration in which nothing was achieved is described as that.
  if (look.exit_code != 0) {
    EXPECT_EQ(look.exit_code, 1);
    EXPECT_NE(look.err.find("nothing to imitate"), std::string::npos) << look.err;
  }
  EXPECT_TRUE(Exists("picture.png"));
}

INSTANTIATE_TEST_SUITE_P(All, GoldenRecording, ::testing::ValuesIn(GoldenRecordings()),
                         [](const auto& parameter) { return parameter.param; });

TEST(GoldenRecordings, AreAllThereAndSmall) {
  EXPECT_EQ(GoldenRecordings().size(), 48u) << "none is taken away; a new one counts here";
  std::uintmax_t num_bytes = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(GoldenFolder())) {
    if (entry.is_regular_file()) num_bytes += entry.file_size();
  }
  EXPECT_LT(num_bytes, std::uintmax_t{5} << 20);
}

}  // namespace
}  // namespace smile
