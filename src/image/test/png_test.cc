#include "image/png.h"

#include <gtest/gtest.h>
#include <png.h>
#include <sys/resource.h>
#include <unistd.h>

#include <cmath>
#include <csignal>
#include <memory>
#include <stdexcept>

#include "base/files.h"

namespace smile {
namespace {

class PngTest : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = std::filesystem::temp_directory_path() / ("smile_png_" + std::to_string(getpid()));
    MakeDirectories(folder_);
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  std::filesystem::path File() const { return folder_ / "image.png"; }
  void WriteBytes(const std::string& bytes) const { WriteFile(File(), bytes); }

 private:
  std::filesystem::path folder_;
};

Image Gradient(int width_px, int height_px) {
  Image image{.width_px = width_px, .height_px = height_px};
  for (int v = 0; v < height_px; ++v) {
    for (int u = 0; u < width_px; ++u) {
      for (const int value : {u, v, u * v}) image.color.push_back(static_cast<std::uint8_t>(value));
    }
  }
  return image;
}

/// The raw 16-bit gray values of a file, read by libpng's classic interface.
std::vector<std::uint16_t> ReadGray16(const std::filesystem::path& path) {
  const std::unique_ptr<FILE, int (*)(FILE*)> file(std::fopen(path.c_str(), "rb"), &std::fclose);
  png_structp png = png_create_read_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
  png_infop info = png_create_info_struct(png);
  png_init_io(png, file.get());
  png_read_png(png, info, PNG_TRANSFORM_SWAP_ENDIAN, nullptr);
  EXPECT_EQ(png_get_bit_depth(png, info), 16);
  EXPECT_EQ(png_get_color_type(png, info), PNG_COLOR_TYPE_GRAY);
  std::vector<std::uint16_t> values;
  for (png_uint_32 v = 0; v < png_get_image_height(png, info); ++v) {
    const auto* row = reinterpret_cast<const std::uint16_t*>(png_get_rows(png, info)[v]);
    values.insert(values.end(), row, row + png_get_image_width(png, info));
  }
  png_destroy_read_struct(&png, &info, nullptr);
  return values;
}

std::string MessageOf(const auto& action) {
  try {
    action();
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "nothing was thrown";
}

TEST_F(PngTest, ReadsBackTheColorsItWrote) {
  for (const auto& [width, height] : {std::pair{1, 1}, {7, 3}, {200, 150}}) {
    const Image image = Gradient(width, height);
    WritePng(File(), image);
    EXPECT_TRUE(ReadPng(File()) == image);
  }
}

TEST_F(PngTest, HasFourChannelsAsTheClassicRecordings) {
  WritePng(File(), Gradient(5, 4));
  const std::string bytes = ReadFile(File(), 10'000);
  // The header chunk: 8 bytes of signature, 8 of chunk, width, height, bit depth, color type.
  EXPECT_EQ(bytes[24], 8);
  EXPECT_EQ(bytes[25], PNG_COLOR_TYPE_RGB_ALPHA);
}

TEST_F(PngTest, WritesTheSameBytesEveryTime) {
  WritePng(File(), Gradient(64, 48));
  const std::string first = ReadFile(File(), 100'000);
  WritePng(File(), Gradient(64, 48));
  EXPECT_EQ(ReadFile(File(), 100'000), first);
}

TEST_F(PngTest, WritesDepthInTenthsOfMillimeters) {
  WriteDepthPng(
      File(),
      {.width_px = 6, .height_px = 1, .depth = {0, 1.23456f, 6.5534f, 7.0f, 1e-6f, std::nanf("")}});
  EXPECT_EQ(ReadGray16(File()), (std::vector<std::uint16_t>{0, 12346, 65534, 65535, 1, 0}));
}

TEST_F(PngTest, WritesIdsAsTheyAre) {
  WriteIdPng(File(), {.width_px = 2, .height_px = 2, .ids = {0, 1, 1000, 65535}});
  EXPECT_EQ(ReadGray16(File()), (std::vector<std::uint16_t>{0, 1, 1000, 65535}));
  EXPECT_THROW(WriteIdPng(File(), {.width_px = 1, .height_px = 1, .ids = {65536}}),
               std::invalid_argument);
}

TEST_F(PngTest, RefusesAnImageWithoutTheChannel) {
  const Image image = Gradient(3, 3);
  EXPECT_THROW(WritePng(File(), Image{}), std::invalid_argument);
  EXPECT_THROW(WriteDepthPng(File(), image), std::invalid_argument);
  EXPECT_THROW(WriteIdPng(File(), image), std::invalid_argument);
}

TEST_F(PngTest, NamesThePathAndTheReasonWhenItCannotWrite) {
  const std::string path = File().string() + "/in/no/folder.png";
  EXPECT_EQ(MessageOf([&] { WritePng(path, Gradient(3, 3)); }),
            path + ": cannot be written: No such file or directory");
}

TEST_F(PngTest, ReportsAFullDisk) {
  rlimit limit;
  ASSERT_EQ(getrlimit(RLIMIT_FSIZE, &limit), 0);
  const rlimit small{.rlim_cur = 1000, .rlim_max = limit.rlim_max};
  std::signal(SIGXFSZ, SIG_IGN);
  setrlimit(RLIMIT_FSIZE, &small);
  const std::string message = MessageOf([&] { WritePng(File(), Gradient(300, 300)); });
  setrlimit(RLIMIT_FSIZE, &limit);
  EXPECT_EQ(message, File().string() + ": cannot be written: File too large");
  EXPECT_FALSE(std::filesystem::exists(File()));
}

TEST_F(PngTest, NamesThePathOfAFileThatIsMissingOrNoPng) {
  EXPECT_EQ(MessageOf([&] { ReadPng(File()); }), File().string() + ": no such file");
  WriteBytes("these are not pixels");
  EXPECT_TRUE(MessageOf([&] {
                ReadPng(File());
              }).starts_with(File().string() + ": is not a readable PNG: "));
}

TEST_F(PngTest, SurvivesEveryTruncationAndFlippedByte) {
  WritePng(File(), Gradient(9, 5));
  const std::string bytes = ReadFile(File(), 10'000);
  for (std::size_t length = 0; length < bytes.size() - 12; ++length) {  // 12: the end chunk
    WriteBytes(bytes.substr(0, length));
    EXPECT_THROW(ReadPng(File()), std::runtime_error) << "cut to " << length << " bytes";
  }
  for (std::size_t k = 0; k < bytes.size(); ++k) {
    std::string damaged = bytes;
    damaged[k] = static_cast<char>(~damaged[k]);
    WriteBytes(damaged);
    try {
      EXPECT_LE(ReadPng(File()).width_px, 8192);
    } catch (const std::runtime_error&) {
    }
  }
}

TEST_F(PngTest, RefusesAPictureTooLargeToHold) {
  WritePng(File(), Gradient(1, 1));
  // A true header of 100,000 x 100,000 pixels: width, height, then their checksum.
  std::string bytes = ReadFile(File(), 10'000);
  bytes.replace(16, 8, std::string("\x00\x01\x86\xa0\x00\x01\x86\xa0", 8));
  bytes.replace(29, 4, std::string("\xa8\x52\x0b\xc8", 4));
  WriteBytes(bytes);
  EXPECT_EQ(MessageOf([&] { ReadPng(File()); }),
            File().string() + ": is 100000x100000 pixels, expected at most 8192 each");
}

}  // namespace
}  // namespace smile
