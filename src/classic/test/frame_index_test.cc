#include "classic/frame_index.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include "base/diagnostic.h"
#include "base/files.h"

namespace smile::classic {
namespace {

class FrameIndex : public ::testing::Test {
 protected:
  ~FrameIndex() override { std::filesystem::remove(csv_); }

  std::vector<FrameEntry> Read(const std::string& lines) const {
    WriteFile(csv_, "frame,tick,image\n" + lines);
    return ReadFrameIndex(csv_);
  }
  /// Its end, behind the name of the file.
  std::string ErrorOf(const std::string& lines) const {
    try {
      Read(lines);
    } catch (const InputError& error) {
      return std::string(error.what()).substr(csv_.string().size());
    }
    return "no error";
  }

  std::filesystem::path csv_ = std::filesystem::temp_directory_path() /
                               ("smile_frames_" + std::to_string(getpid()) + ".csv");
};

TEST_F(FrameIndex, HasAllFramesWithTheirPictures) {
  const std::vector<FrameEntry> frames = Read("0,60,0/0.png\n1,75,\n2,90,3/2.png\n3,1");
  ASSERT_EQ(frames.size(), 3u) << "the last line has no end";
  EXPECT_EQ(frames[0].image, "0/0.png");
  EXPECT_EQ(frames[1].tick, 75u);
  EXPECT_EQ(frames[1].image, "");
  EXPECT_EQ(frames[2].segment, 3);
}

TEST_F(FrameIndex, NamesTheLineThatIsWrong) {
  EXPECT_EQ(ErrorOf("0,0,0/0.png\nx,15,\n"), ":3: found \"x,15,\", expected frame,tick,image");
  EXPECT_EQ(ErrorOf("0,0,../../x.png\n"),
            ":2: found \"0,0,../../x.png\", expected a picture like 3/14.png");
  EXPECT_EQ(ErrorOf("0,15,\n1,15,\n"), ":3: found tick 15, expected more than 15");
}

}  // namespace
}  // namespace smile::classic
