// A corpus that is missing or empty is an error: a test of its files would check nothing.

#include "kept_inputs.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <stdexcept>

#include "base/files.h"

namespace smile::fuzz {
namespace {

class FilesBelowTest : public ::testing::Test {
 protected:
  FilesBelowTest() { std::filesystem::create_directories(folder_ / "empty" / "below"); }
  ~FilesBelowTest() override { std::filesystem::remove_all(folder_); }

  std::string ComplaintAbout(const std::filesystem::path& folder, std::size_t at_least = 1) const {
    try {
      (void)FilesBelow(folder_ / folder, at_least);
    } catch (const std::runtime_error& error) {
      return std::string(error.what()).substr((folder_ / folder).string().size());
    }
    return "";
  }

  const std::filesystem::path folder_ =
      std::filesystem::temp_directory_path() / ("smile_corpus_" + std::to_string(getpid()));
};

TEST_F(FilesBelowTest, AMissingFolderIsAnError) {
  EXPECT_EQ(ComplaintAbout("nowhere"), ": no such folder");
}

TEST_F(FilesBelowTest, AnEmptyFolderIsAlwaysAnError) {
  EXPECT_EQ(ComplaintAbout("empty"), ": found 0 files, expected at least 1");
  EXPECT_EQ(ComplaintAbout("empty", 0), ": found 0 files, expected at least 1");
}

TEST_F(FilesBelowTest, FewerFilesThanExpectedAreAnError) {
  WriteFile(folder_ / "b", "");
  WriteFile(folder_ / "empty" / "below" / "a", "");
  EXPECT_EQ(ComplaintAbout("", 2), "");
  EXPECT_EQ(ComplaintAbout("", 3), ": found 2 files, expected at least 3");
  EXPECT_EQ(FilesBelow(folder_).front(), folder_ / "b");
}

}  // namespace
}  // namespace smile::fuzz
