// Frames of demonstrations, as brains watch them.

#include "experiment/demonstration_frames.h"

#include "base/diagnostic.h"
#include "experiment_fixture.h"
#include "image/png.h"
#include "picture/rendered_eye.h"

namespace smile::experiment {
namespace {

class DemonstrationFrames : public ExperimentTest {
 protected:
  static constexpr std::uint64_t kTicksPerFrame = 15;

  /// A demonstration that takes small pictures, or none.
  fs::path Record(bool has_pictures) const {
    experiment::Run({.scene = Pair(),
                     .script = Stacking(),
                     .record = root_ / "demo",
                     .has_pictures = has_pictures,
                     .eye = kEye});
    return root_ / "demo";
  }
  static std::vector<brain::DemonstrationFrame> All(const brain::DemonstrationFrames& next) {
    std::vector<brain::DemonstrationFrame> frames;
    while (auto frame = next()) frames.push_back(*std::move(frame));
    return frames;
  }
  static std::string ErrorOf(const brain::DemonstrationFrames& next) {
    try {
      All(next);
    } catch (const std::exception& error) {
      return error.what();
    }
    return "no error";
  }

  static inline const sim::EyeSpec kEye{.width_px = 32, .height_px = 24};
};

TEST_F(DemonstrationFrames, AreThePicturesOfTheRecordingInOrder) {
  const fs::path demo = Record(/*has_pictures=*/true);
  const std::vector<brain::DemonstrationFrame> frames = All(FramesOf(demo, nullptr));
  ASSERT_EQ(frames.size(), CountLines("demo/frames.csv") - 1u);
  EXPECT_EQ(frames[0].image.color, ReadPng(demo / "0/0.png").color);
  EXPECT_EQ(frames[0].view.intrinsics.width_px, kEye.width_px);
  EXPECT_GT(frames[0].view.X_WC.translation().z(), 0.5) << "where the eye was [m]";
  std::size_t num_repeated = 0;
  for (std::size_t k = 0; k < frames.size(); ++k) {
    EXPECT_EQ(frames[k].tick, k * kTicksPerFrame);
    if (k > 0 && frames[k].image.color == frames[k - 1].image.color) ++num_repeated;
  }
  EXPECT_GT(num_repeated, 0u) << "while nothing moved";
  EXPECT_LT(num_repeated, frames.size() / 2);
}

TEST_F(DemonstrationFrames, AreDrawnWhereTheRecordingHasNoPictures) {
  const std::vector<brain::DemonstrationFrame> recorded =
      All(FramesOf(Record(/*has_pictures=*/true), nullptr));
  fs::remove_all(root_ / "demo");
  picture::RenderedEye eye(kEye);
  const std::vector<brain::DemonstrationFrame> drawn =
      All(FramesOf(Record(/*has_pictures=*/false), &eye));
  ASSERT_EQ(drawn.size(), recorded.size());
  for (std::size_t k = 0; k < drawn.size(); ++k) {
    EXPECT_EQ(drawn[k].tick, recorded[k].tick);
    // A picture is kept from the frame in which a move was large enough to be reported.
    if (k == 0 || recorded[k].image.color != recorded[k - 1].image.color) {
      EXPECT_EQ(drawn[k].image.color, recorded[k].image.color) << k;
    }
  }
}

TEST_F(DemonstrationFrames, BeginWithTheFirstPicture) {
  const fs::path demo = Record(/*has_pictures=*/true);
  Write("demo/frames.csv", "frame,tick,image\n0,0,\n1,15,0/0.png\n2,30,\n");
  const std::vector<brain::DemonstrationFrame> frames = All(FramesOf(demo, nullptr));
  ASSERT_EQ(frames.size(), 2u);
  EXPECT_EQ(frames[0].tick, 0u);
  EXPECT_EQ(frames[1].tick, 15u);
}

TEST_F(DemonstrationFrames, ReportWhyTheyAreUnavailable) {
  const fs::path demo = Record(/*has_pictures=*/true);
  const std::string index = "frame,tick,image\n0,0,0/0.png\n1,15,0/1.png\n";
  Write("demo/frames.csv", index);
  WritePng(demo / "0/1.png",
           {.width_px = 2, .height_px = 1, .color = std::vector<std::uint8_t>(6)});
  EXPECT_EQ(ErrorOf(FramesOf(demo, nullptr)),
            (demo / "0/1.png").string() + ": is 2x1, expected 32x24 as in demo.json");
  fs::remove(demo / "0/1.png");
  EXPECT_NE(ErrorOf(FramesOf(demo, nullptr)).find("0/1.png"), std::string::npos);
  Write("demo/frames.csv", "frame,tick,image\n0,99999,0/0.png\n");
  EXPECT_NE(ErrorOf(FramesOf(demo, nullptr)).find("has a frame of tick 99999"), std::string::npos);
  fs::remove_all(demo);
  EXPECT_EQ(ErrorOf(FramesOf(Record(/*has_pictures=*/false), nullptr)),
            demo.string() + ": has no pictures, and no eye to render them is given");
}

}  // namespace
}  // namespace smile::experiment
