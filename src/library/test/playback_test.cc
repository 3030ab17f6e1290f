#include "library/playback.h"

#include <cmath>
#include <limits>

#include "recorder/test/recording_fixture.h"
#include "recording/trace_reader.h"

namespace smile::library {
namespace {

class PlaybackTest : public recorder::RecordingFixture {
 protected:
  static std::vector<recording::TraceTick> MomentsOf(const std::filesystem::path& demo) {
    recording::TraceReader trace(recording::OpenRecording(demo));
    std::vector<recording::TraceTick> moments;
    while (auto moment = trace.Next()) moments.push_back(*std::move(moment));
    return moments;
  }

  static void ExpectShows(const recording::TraceTick& moment, const Playback& playback) {
    const DisplayedState view = playback.view();
    ASSERT_EQ(view.tick, moment.tick);
    ASSERT_EQ(view.state.poses.size(), static_cast<std::size_t>(view.model->num_frames));
    for (std::size_t i = 0; i < moment.objects.size(); ++i) {
      EXPECT_EQ(view.state.poses[i + 1], moment.objects[i].pose_in_world()) << moment.tick;
    }
  }
};

TEST_F(PlaybackTest, ShowsEveryMomentOfTheTraceAndStandsStillAtItsEnd) {
  const auto demo = Record();
  const auto moments = MomentsOf(demo);
  Playback playback("demo", demo);
  EXPECT_DOUBLE_EQ(playback.length(), static_cast<double>(moments.size() - 1) / 60);
  ExpectShows(moments.front(), playback);
  playback.Tick();
  ExpectShows(moments.front(), playback);  // it stands still at first
  playback.SetRate(1);
  for (std::size_t k = 1; k < moments.size(); ++k) {
    EXPECT_EQ(playback.rate(), 1);
    playback.Tick();
    ExpectShows(moments[k], playback);
  }
  EXPECT_EQ(playback.rate(), 0);
  EXPECT_EQ(playback.seconds(), playback.length());
  playback.SetRate(2);  // again from the start
  playback.Tick();
  ExpectShows(moments[2], playback);
}

TEST_F(PlaybackTest, SeekingLeadsWherePlayingDoes) {
  const auto demo = Record(
      R"({"hand":"left","do":"grasp","object":"a"}
{"hand":"left","do":"move_to","position":[0,-2,3]}
{"do":"wait","seconds":1}
{"hand":"left","do":"release"}
{"do":"wait","seconds":1}
{"do":"undo"}
{"do":"wait","seconds":2})",
      /*with_robot=*/true);
  const auto moments = MomentsOf(demo);
  ASSERT_GT(moments.size(), 150u);
  Playback playback("demo", demo);
  for (std::size_t k = 0; k < 60; ++k) {
    const std::size_t tick = (k * 7919) % moments.size();  // back and forth
    playback.Seek(static_cast<double>(tick) / 60);
    ExpectShows(moments[tick], playback);
  }
  playback.Seek(-1);
  ExpectShows(moments.front(), playback);
  playback.Seek(1e9);
  ExpectShows(moments.back(), playback);
}

TEST_F(PlaybackTest, PausesWhereTheTraceWasCutMeanwhileAndReportsItOnce) {
  const auto demo = Record(R"({"do":"wait","seconds":10})");
  Playback playback("demo", demo);
  // At rest, a tick takes 21 bytes: this removes more than two seconds.
  const auto trace = demo / "trace.bin";
  std::filesystem::resize_file(trace, std::filesystem::file_size(trace) - 3000);
  playback.SetRate(Playback::kMaxRate);
  for (int i = 0; i < 60; ++i) playback.Tick();
  EXPECT_EQ(playback.rate(), 0);
  EXPECT_GT(playback.seconds(), 1);
  EXPECT_LT(playback.seconds(), playback.length());
  EXPECT_THROW(playback.SetRate(1), std::runtime_error);
  EXPECT_THROW(playback.Seek(9), InputError);
  playback.Seek(1);
  EXPECT_EQ(playback.moment().tick, 60u);
  playback.SetRate(1);
  EXPECT_EQ(playback.rate(), 1);
}

TEST_F(PlaybackTest, RefusesRatesAndTimesThatAreNone) {
  Playback playback("demo", Record(R"({"do":"wait","seconds":0.1})"));
  EXPECT_THROW(playback.SetRate(-1), std::invalid_argument);
  EXPECT_THROW(playback.SetRate(std::nan("")), std::invalid_argument);
  EXPECT_THROW(playback.SetRate(std::numeric_limits<double>::infinity()), std::invalid_argument);
  EXPECT_THROW(playback.Seek(std::nan("")), std::invalid_argument);
  EXPECT_THROW(Playback("none", root_ / "none"), InputError);
}

}  // namespace
}  // namespace smile::library
