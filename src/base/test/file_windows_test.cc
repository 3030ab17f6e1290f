#include "base/file_windows.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <string>

#include "base/diagnostic.h"
#include "base/files.h"

namespace smile {
namespace {

namespace fs = std::filesystem;

class FileWindowsTest : public testing::Test {
 protected:
  FileWindowsTest() {
    // Larger than the largest windows, and no multiple of any.
    for (std::size_t i = 0; i < 700'001; ++i) text_ += static_cast<char>(i * 2654435761u >> 16);
    WriteFile(path_, text_);
  }
  ~FileWindowsTest() override { fs::remove(path_); }

  std::string Expected(std::uint64_t place, std::size_t count) const {
    return place < text_.size() ? text_.substr(place, count) : "";
  }
  static std::string TextAt(FileWindows* file, std::uint64_t place, std::size_t count) {
    const auto bytes = file->At(place, count);
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
  }

  const fs::path path_ = fs::path(testing::TempDir()) /
                         ("smile-windows-" + std::to_string(getpid()) + "-" +
                          testing::UnitTest::GetInstance()->current_test_info()->name());
  std::string text_;
};

TEST_F(FileWindowsTest, ShowTheFileAtEveryPlace) {
  FileWindows file(path_);
  ASSERT_EQ(file.size(), text_.size());
  // Onwards, so that parts lie across the borders of windows of all sizes; backwards; to and fro.
  for (std::uint64_t place = 0; place < text_.size() + 50; place += 29) {
    ASSERT_EQ(TextAt(&file, place, 37), Expected(place, 37)) << place;
  }
  for (std::uint64_t place = text_.size() + 50; place > 4099; place -= 4099) {
    ASSERT_EQ(TextAt(&file, place, 4097), Expected(place, 4097)) << place;
  }
  for (std::uint64_t i = 0; i < 2000; ++i) {
    const std::uint64_t place = i * 7919 * 104'729 % text_.size();
    ASSERT_EQ(TextAt(&file, place, 4095 + i % 3), Expected(place, 4095 + i % 3)) << place;
  }
  EXPECT_EQ(TextAt(&file, 0, text_.size()), text_);
  EXPECT_EQ(TextAt(&file, 5, 0), "");
}

TEST_F(FileWindowsTest, ReadOnlyWhatIsNear) {
  FileWindows file(path_);
  EXPECT_EQ(file.bytes_read(), 0u);
  for (const std::uint64_t place : {600'000, 3, 400'000}) (void)file.At(place, 10);
  EXPECT_LE(file.bytes_read(), 3 * 4096u);
  // Going through it reads little twice.
  FileWindows whole(path_);
  for (std::uint64_t place = 0; place < text_.size(); place += 29) (void)whole.At(place, 37);
  EXPECT_LT(whole.bytes_read(), text_.size() + 1000);
}

TEST_F(FileWindowsTest, EndWhereTheFileHasBecomeShorter) {
  FileWindows file(path_);
  EXPECT_EQ(TextAt(&file, 0, 10), Expected(0, 10));
  fs::resize_file(path_, 500'000);
  EXPECT_EQ(TextAt(&file, 499'990, 100), Expected(499'990, 10));
  EXPECT_EQ(TextAt(&file, 600'000, 100), "");
  EXPECT_EQ(TextAt(&file, 100'000, 100), Expected(100'000, 100));
}

TEST_F(FileWindowsTest, AreOfRegularFilesOnly) {
  const auto complaint = [](const fs::path& path) -> std::string {
    try {
      const FileWindows file(path);
    } catch (const InputError& error) {
      return error.diagnostics().front().message;
    }
    return "";
  };
  EXPECT_EQ(complaint(path_.string() + "-none"), "no such file");
  EXPECT_EQ(complaint(path_ / "below"), "no such file");
  EXPECT_EQ(complaint(fs::temp_directory_path()), "is not a regular file");
  EXPECT_EQ(complaint("/dev/zero"), "is not a regular file");
}

}  // namespace
}  // namespace smile
