#include "video/video_writer.h"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include <csignal>
#include <functional>
#include <stdexcept>
#include <string>

#include "base/files.h"
#include "video/internal_libav.h"

namespace smile::video {
namespace {

using internal::Check;

class VideoWriterTest : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = std::filesystem::temp_directory_path() / ("smile_video_" + std::to_string(getpid()));
    MakeDirectories(folder_);
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  std::filesystem::path File(const std::string& name = "film.mp4") const { return folder_ / name; }

 private:
  std::filesystem::path folder_;
};

Image Filled(int width_px, int height_px, std::array<std::uint8_t, 3> color) {
  Image image{.width_px = width_px, .height_px = height_px};
  for (int k = 0; k < width_px * height_px; ++k) {
    image.color.insert(image.color.end(), color.begin(), color.end());
  }
  return image;
}

/// A white bar walks over a colored ground.
Image FrameOfFilm(int width_px, int height_px, int number) {
  Image image = Filled(width_px, height_px, {200, 40, 90});
  for (int v = 0; v < height_px; ++v) {
    const int u = number % width_px;
    for (int channel = 0; channel < 3; ++channel) {
      image.color[3 * (v * width_px + u) + channel] = 255;
    }
  }
  return image;
}

void WriteFilm(const std::filesystem::path& path, int width_px, int height_px, int num_frames) {
  VideoWriter writer(path, width_px, height_px, 30);
  for (int k = 0; k < num_frames; ++k) writer.Add(FrameOfFilm(width_px, height_px, k));
  EXPECT_EQ(writer.num_frames(), num_frames);
  writer.Finish();
}

/// Decodes a film.
/// @param see  is called with each picture.
void Decode(const std::filesystem::path& path, const std::function<void(const AVFrame&)>& see) {
  AVFormatContext* opened = nullptr;
  Check(avformat_open_input(&opened, path.c_str(), nullptr, nullptr), path, "open");
  const internal::Input input(opened);
  const AVCodecParameters* parameters = input->streams[0]->codecpar;
  const internal::Codec codec(avcodec_alloc_context3(avcodec_find_decoder(parameters->codec_id)));
  avcodec_parameters_to_context(codec.get(), parameters);
  Check(avcodec_open2(codec.get(), nullptr, nullptr), path, "decoder");
  const internal::Frame frame(av_frame_alloc());
  const internal::Packet packet(av_packet_alloc());
  const auto receive = [&] {
    while (avcodec_receive_frame(codec.get(), frame.get()) == 0) see(*frame);
  };
  while (av_read_frame(input.get(), packet.get()) == 0) {
    avcodec_send_packet(codec.get(), packet.get());
    av_packet_unref(packet.get());
    receive();
  }
  avcodec_send_packet(codec.get(), nullptr);
  receive();
}

/// The Y, U and V of the middle of each picture of a film.
std::vector<std::array<int, 3>> MiddlesOf(const std::filesystem::path& path) {
  std::vector<std::array<int, 3>> middles;
  Decode(path, [&middles](const AVFrame& frame) {
    const auto at = [&](int plane, int u, int v) {
      return int{frame.data[plane][v * frame.linesize[plane] + u]};
    };
    const int u = frame.width / 2, v = frame.height / 2;
    middles.push_back({at(0, u, v), at(1, u / 2, v / 2), at(2, u / 2, v / 2)});
  });
  return middles;
}

/// The numbers of each picture of a film of numbers, row by row.
std::vector<std::vector<std::uint16_t>> LevelsOf(const std::filesystem::path& path) {
  std::vector<std::vector<std::uint16_t>> pictures;
  Decode(path, [&pictures](const AVFrame& frame) {
    EXPECT_EQ(frame.format, AV_PIX_FMT_GRAY12);
    auto& levels = pictures.emplace_back();
    for (int v = 0; v < frame.height; ++v) {
      const auto* row =
          reinterpret_cast<const std::uint16_t*>(frame.data[0] + v * frame.linesize[0]);
      levels.insert(levels.end(), row, row + frame.width);
    }
  });
  return pictures;
}

std::string MessageOf(const auto& action) {
  try {
    action();
  } catch (const std::exception& error) {
    return error.what();
  }
  return "nothing was thrown";
}

TEST_F(VideoWriterTest, WritesAsManyFramesAsWereAdded) {
  WriteFilm(File(), 160, 120, 30);
  EXPECT_EQ(ReadVideoInfo(File()), (VideoInfo{160, 120, 30.0, 30}));
  EXPECT_EQ(MiddlesOf(File()).size(), 30u);
}

TEST_F(VideoWriterTest, KeepsColors) {
  constexpr int kTolerance = 3;  // of 255
  {
    VideoWriter writer(File(), 64, 48, 10);
    for (int k = 0; k < 5; ++k) writer.Add(Filled(64, 48, {255, 0, 0}));
    for (int k = 0; k < 5; ++k) writer.Add(Filled(64, 48, {255, 255, 255}));
    writer.Finish();
  }
  // BT.709, limited range: pure red is (63, 102, 240), white (235, 128, 128).
  const auto middles = MiddlesOf(File());
  ASSERT_EQ(middles.size(), 10u);
  for (int channel = 0; channel < 3; ++channel) {
    EXPECT_NEAR(middles[0][channel], (std::array{63, 102, 240})[channel], kTolerance);
    EXPECT_NEAR(middles[9][channel], (std::array{235, 128, 128})[channel], kTolerance);
  }
}

TEST_F(VideoWriterTest, EqualPicturesGiveEqualBytes) {
  WriteFilm(File("a.mp4"), 160, 120, 40);
  WriteFilm(File("b.mp4"), 160, 120, 40);
  EXPECT_EQ(ReadFile(File("a.mp4"), 1 << 20), ReadFile(File("b.mp4"), 1 << 20));
}

TEST_F(VideoWriterTest, TakesAColonInAPathForALetter) {
  WriteFilm(File("day:1.mp4"), 32, 32, 2);
  EXPECT_EQ(ReadVideoInfo(File("day:1.mp4")).num_frames, 2);
}

TEST_F(VideoWriterTest, PutsTheIndexInFront) {
  WriteFilm(File(), 160, 120, 5);
  const std::string bytes = ReadFile(File(), 1 << 20);
  EXPECT_LT(bytes.find("moov"), bytes.find("mdat"));
}

TEST_F(VideoWriterTest, RoundsOddSizesUp) {
  for (const auto& [width, height] : {std::pair{1, 1}, {33, 21}, {64, 33}, {2, 2}}) {
    WriteFilm(File(), width, height, 3);
    const VideoInfo info = ReadVideoInfo(File());
    EXPECT_EQ(info.width_px, width + width % 2);
    EXPECT_EQ(info.height_px, height + height % 2);
    EXPECT_EQ(info.num_frames, 3);
  }
}

std::vector<std::uint16_t> Levels(int width_px, int height_px, int number) {
  std::vector<std::uint16_t> levels(static_cast<std::size_t>(width_px) * height_px);
  for (std::size_t k = 0; k < levels.size(); ++k) {
    levels[k] = static_cast<std::uint16_t>((k * k * 37 + number * 1001) % 4096);
  }
  return levels;
}

TEST_F(VideoWriterTest, KeepsNumbersWithoutLossInEqualBytes) {
  for (const auto& [width, height] : {std::pair{64, 48}, {66, 34}, {33, 41}}) {
    for (const char* name : {"a.mp4", "b.mp4"}) {
      VideoWriter writer(File(name), width, height, 30, VideoCoding::kLevels);
      for (int k = 0; k < 7; ++k) writer.AddLevels(Levels(width, height, k));
      writer.Finish();
    }
    EXPECT_EQ(ReadFile(File("a.mp4"), 1 << 20), ReadFile(File("b.mp4"), 1 << 20));
    EXPECT_EQ(ReadVideoInfo(File("a.mp4")), (VideoInfo{width, height, 30.0, 7}));
    const auto pictures = LevelsOf(File("a.mp4"));
    ASSERT_EQ(pictures.size(), 7u);
    for (int k = 0; k < 7; ++k) EXPECT_EQ(pictures[k], Levels(width, height, k)) << k;
  }
}

TEST_F(VideoWriterTest, RefusesColorsAmongNumbers) {
  VideoWriter numbers(File("a.mp4"), 64, 48, 30, VideoCoding::kLevels);
  VideoWriter colors(File("b.mp4"), 64, 48, 30);
  EXPECT_THROW(numbers.Add(Filled(64, 48, {1, 2, 3})), std::invalid_argument);
  EXPECT_THROW(colors.AddLevels(Levels(64, 48, 0)), std::invalid_argument);
  EXPECT_THROW(numbers.AddLevels(Levels(64, 47, 0)), std::invalid_argument);
  EXPECT_THROW(numbers.AddLevels(std::vector<std::uint16_t>(64 * 48, 4096)), std::invalid_argument);
}

TEST_F(VideoWriterTest, KeepsUnusualRates) {
  for (const double rate : {0.5, 4.0, 23.976, 60.0, 1000.0}) {
    {
      VideoWriter writer(File(), 32, 32, rate);
      for (int k = 0; k < 8; ++k) writer.Add(FrameOfFilm(32, 32, k));
      writer.Finish();
    }
    EXPECT_NEAR(ReadVideoInfo(File()).frames_per_second, rate, 1e-3 * rate);
  }
}

TEST_F(VideoWriterTest, ASeekableFilmStoresPicturesInOrderAndEverySecondAlone) {
  {
    VideoWriter writer(File(), 64, 48, 30, VideoCoding::kSeekable);
    for (int k = 0; k < 25; ++k) writer.Add(FrameOfFilm(64, 48, k));
    writer.Finish();
  }
  AVFormatContext* opened = nullptr;
  Check(avformat_open_input(&opened, internal::UrlOf(File()).c_str(), nullptr, nullptr), File(),
        "avformat_open_input");
  const internal::Input input(opened);
  const internal::Packet packet(av_packet_alloc());
  const AVStream* stream = input->streams[0];
  int number = 0;
  for (; av_read_frame(input.get(), packet.get()) >= 0; ++number, av_packet_unref(packet.get())) {
    EXPECT_EQ(packet->pts, packet->dts);
    // number / 30 s, exactly
    EXPECT_EQ(packet->pts * stream->time_base.num * 30,
              std::int64_t{number} * stream->time_base.den);
    EXPECT_EQ((packet->flags & AV_PKT_FLAG_KEY) != 0, number % 2 == 0);
  }
  EXPECT_EQ(number, 25);
}

TEST_F(VideoWriterTest, FinishesWhenItIsDestroyed) {
  {
    VideoWriter writer(File(), 32, 32, 30);
    writer.Add(FrameOfFilm(32, 32, 0));
  }
  EXPECT_EQ(ReadVideoInfo(File()), (VideoInfo{32, 32, 30.0, 1}));
}

TEST_F(VideoWriterTest, RefusesToFinishAnEmptyFilm) {
  VideoWriter writer(File(), 32, 32, 30);
  EXPECT_EQ(MessageOf([&] { writer.Finish(); }), File().string() + ": a film needs a picture");
}

TEST_F(VideoWriterTest, RefusesPicturesOfAnotherSizeAndContinues) {
  VideoWriter writer(File(), 32, 32, 30);
  EXPECT_THROW(writer.Add(FrameOfFilm(32, 31, 0)), std::invalid_argument);
  EXPECT_THROW(writer.Add(Image{.width_px = 32, .height_px = 32}), std::invalid_argument);
  writer.Add(FrameOfFilm(32, 32, 0));
  writer.Finish();
  writer.Finish();
  EXPECT_THROW(writer.Add(FrameOfFilm(32, 32, 0)), std::logic_error);
  EXPECT_EQ(ReadVideoInfo(File()).num_frames, 1);
}

TEST_F(VideoWriterTest, RefusesImpossibleFilms) {
  EXPECT_THROW(VideoWriter(File(), 0, 32, 30), std::invalid_argument);
  EXPECT_THROW(VideoWriter(File(), 32, 8193, 30), std::invalid_argument);
  EXPECT_THROW(VideoWriter(File(), 32, 32, 0), std::invalid_argument);
  EXPECT_FALSE(std::filesystem::exists(File()));
}

TEST_F(VideoWriterTest, NamesThePathAndTheReasonWhenItCannotWrite) {
  const auto path = File() / "in" / "no" / "folder.mp4";
  EXPECT_EQ(MessageOf([&] { VideoWriter(path, 32, 32, 30); }),
            path.string() + ": avio_open: No such file or directory");
}

TEST_F(VideoWriterTest, ReportsAFullDisk) {
  rlimit limit;
  ASSERT_EQ(getrlimit(RLIMIT_FSIZE, &limit), 0);
  const rlimit small{.rlim_cur = 2000, .rlim_max = limit.rlim_max};
  std::signal(SIGXFSZ, SIG_IGN);
  setrlimit(RLIMIT_FSIZE, &small);
  const std::string message = MessageOf([&] { WriteFilm(File(), 320, 240, 100); });
  setrlimit(RLIMIT_FSIZE, &limit);
  EXPECT_TRUE(message.starts_with(File().string() + ": ")) << message;
  EXPECT_TRUE(message.ends_with("File too large")) << message;
}

TEST_F(VideoWriterTest, ReadingNamesThePathOfAFileThatIsNoFilm) {
  EXPECT_EQ(MessageOf([&] { ReadVideoInfo(File()); }),
            File().string() + ": avformat_open_input: No such file or directory");
  WriteFile(File(), "these are no pictures");
  EXPECT_TRUE(MessageOf([&] { ReadVideoInfo(File()); }).starts_with(File().string() + ": "));
}

}  // namespace
}  // namespace smile::video

/// Asked by the leak search of sanitizers, under the name in quotes: libx265 frees some of its
/// memory only with the process.
extern "C" const char* LeaksOfLibraries() __asm__("__lsan_default_suppressions");
const char* LeaksOfLibraries() { return "leak:libx265"; }
