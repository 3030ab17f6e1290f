#include "classic/frame_writer.h"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include <csignal>
#include <stdexcept>

#include "base/files.h"
#include "image/png.h"

namespace smile::classic {
namespace {

namespace fs = std::filesystem;

class FrameWriterTest : public ::testing::Test {
 protected:
  FrameWriterTest() { fs::create_directories(root_); }
  ~FrameWriterTest() override { fs::remove_all(root_); }

  /// Returns frame k: every third one has no picture.
  FrameWriter::Frame Frame(int k) const {
    FrameWriter::Frame frame{.picture = root_ / (std::to_string(k) + ".png"),
                             .line = std::to_string(k) + "\n"};
    if (k % 3 == 2) return frame;
    frame.image = {.width_px = 64, .height_px = 48};
    for (int i = 0; i < 64 * 48 * 3; ++i) {
      frame.image.color.push_back(static_cast<std::uint8_t>(i * k / 7));
    }
    return frame;
  }
  std::string Index() const { return ReadFile(root_ / "frames.csv", 1 << 20); }
  static std::string Lines(int count) {
    std::string lines;
    for (int k = 0; k < count; ++k) lines += std::to_string(k) + "\n";
    return lines;
  }

  const fs::path root_ = fs::path(testing::TempDir()) /
                         ("smile-frames-" + std::to_string(getpid()) + "-" +
                          testing::UnitTest::GetInstance()->current_test_info()->name());
};

TEST_F(FrameWriterTest, WritesAllFramesInOrderAlsoThoseThatWaitAtItsEnd) {
  constexpr int kFrames = 5 * static_cast<int>(FrameWriter::kMaxWaiting);
  {
    FrameWriter writer(root_ / "frames.csv");
    for (int k = 0; k < kFrames; ++k) {
      writer.Add(Frame(k));
      EXPECT_EQ(writer.index_size(), Lines(k + 1).size());
    }
  }
  EXPECT_EQ(Index(), Lines(kFrames));
  for (int k = 0; k < kFrames; ++k) {
    const FrameWriter::Frame frame = Frame(k);
    ASSERT_EQ(fs::exists(frame.picture), !frame.image.color.empty()) << k;
    if (frame.image.color.empty()) continue;
    EXPECT_TRUE(ReadFile(frame.picture, 1 << 20) == EncodePng(frame.image)) << k;
  }
}

TEST_F(FrameWriterTest, AFrameThatCannotBeWrittenIsReportedAndEndsTheView) {
  FrameWriter writer(root_ / "frames.csv");
  for (int k = 0; k < 4; ++k) writer.Add(Frame(k));
  FrameWriter::Frame bad = Frame(4);
  bad.picture = root_ / "none" / "4.png";
  writer.Add(bad);
  std::string reason;
  try {
    for (int k = 5; k < 40; ++k) writer.Add(Frame(k));
    writer.Flush();
  } catch (const std::runtime_error& error) {
    reason = error.what();
  }
  EXPECT_EQ(reason, bad.picture.string() + ": cannot be written: No such file or directory");
  EXPECT_THROW(writer.Add(Frame(40)), std::runtime_error);
  EXPECT_THROW(writer.Flush(), std::runtime_error);
  EXPECT_EQ(Index(), Lines(4));
  EXPECT_FALSE(fs::exists(Frame(6).picture));
}

TEST_F(FrameWriterTest, ALineThatCannotBeWrittenEndsTheViewAsAPictureDoes) {
  FrameWriter writer(root_ / "frames.csv");
  writer.Add({.picture = {}, .image = {}, .line = "first\n"});
  // As on a full disk: files of this process cannot grow.
  rlimit before{};
  getrlimit(RLIMIT_FSIZE, &before);
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  const rlimit full{.rlim_cur = Index().size(), .rlim_max = before.rlim_max};
  setrlimit(RLIMIT_FSIZE, &full);
  EXPECT_THROW(writer.Add({.picture = {}, .image = {}, .line = "second\n"}), std::runtime_error);
  setrlimit(RLIMIT_FSIZE, &before);
  std::signal(SIGXFSZ, handler);

  EXPECT_THROW(writer.Add({.picture = {}, .image = {}, .line = "third\n"}), std::runtime_error);
  EXPECT_THROW(writer.Flush(), std::runtime_error);
  EXPECT_EQ(Index(), "first\n");
}

TEST_F(FrameWriterTest, CutsTheIndexAfterTheFramesThatWait) {
  FrameWriter writer(root_ / "frames.csv");
  for (int k = 0; k < 7; ++k) writer.Add(Frame(k));
  writer.CutIndex(Lines(3).size());
  EXPECT_TRUE(fs::exists(Frame(6).picture));
  for (int k = 3; k < 5; ++k) writer.Add(Frame(k));
  writer.Flush();
  EXPECT_EQ(Index(), Lines(5));
}

}  // namespace
}  // namespace smile::classic
