#include "base/files.h"

#include "base/library_folder.h"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <fstream>
#include <iterator>
#include <limits>
#include <stdexcept>
#include <thread>

namespace smile {
namespace {

namespace fs = std::filesystem;

/// A folder of its own for each test.
class Files : public testing::Test {
 protected:
  Files() { fs::create_directories(folder_); }
  ~Files() override { fs::remove_all(folder_); }

  /// What the function says when it fails.
  template <class Function>
  static std::string ReasonOf(Function function) {
    try {
      function();
    } catch (const std::runtime_error& error) {
      return error.what();
    }
    ADD_FAILURE() << "expected a std::runtime_error";
    return {};
  }

  const fs::path folder_ = fs::path(testing::TempDir()) /
                           ("smile-files-" + std::to_string(getpid()) + "-" +
                            testing::UnitTest::GetInstance()->current_test_info()->name());
};

TEST_F(Files, ComeBackAsWritten) {
  const std::string text("any\0bytes\r\n", 11);
  WriteFile(folder_ / "a", text);
  EXPECT_EQ(ReadFile(folder_ / "a", 11), text);
  WriteFile(folder_ / "a", "");
  EXPECT_EQ(ReadFile(folder_ / "a", 0), "");
}

TEST_F(Files, LeaveNothingBesideThem) {
  WriteFile(folder_ / "a", "text");
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_), fs::directory_iterator()), 1);
}

TEST_F(Files, LeaveNothingBesideThemWhenTheLastStepFails) {
  // The temporary neighbor is a pipe, so that something can happen between its writing and its
  // renaming: a directory takes the name. The text is longer than a pipe holds.
  ASSERT_EQ(mkfifo((folder_ / "a.part").c_str(), 0600), 0);
  std::thread other([this] {
    std::ifstream pipe(folder_ / "a.part", std::ios::binary);
    fs::create_directory(folder_ / "a");
    pipe.ignore(std::numeric_limits<std::streamsize>::max());
  });
  const std::string reason =
      ReasonOf([this] { WriteFile(folder_ / "a", std::string(1 << 20, '.')); });
  other.join();
  EXPECT_TRUE(reason.starts_with((folder_ / "a").string() + ": cannot be written: ")) << reason;
  EXPECT_FALSE(fs::exists(folder_ / "a.part"));
}

TEST_F(Files, AreWrittenThroughLinksAndIntoDevices) {
  WriteFile(folder_ / "a", "old");
  fs::create_symlink(folder_ / "a", folder_ / "link");
  WriteFile(folder_ / "link", "new");
  EXPECT_TRUE(fs::is_symlink(folder_ / "link"));
  EXPECT_EQ(ReadFile(folder_ / "a", 3), "new");
  fs::create_symlink("/dev/null", folder_ / "nothing");
  WriteFile(folder_ / "nothing", "gone");
  EXPECT_TRUE(fs::is_character_file("/dev/null"));
}

TEST_F(Files, LargerThanAllowedAreNotRead) {
  WriteFile(folder_ / "a", "12345");
  EXPECT_EQ(ReasonOf([&] { ReadFile(folder_ / "a", 4); }),
            (folder_ / "a").string() + ": is larger than 4 bytes");
}

TEST_F(Files, ThatCannotBeReadReportWhy) {
  EXPECT_EQ(ReasonOf([&] { ReadFile(folder_ / "none", 9); }),
            (folder_ / "none").string() + ": no such file");
  EXPECT_EQ(ReasonOf([&] { ReadFile(folder_, 9); }), folder_.string() + ": is not a regular file");
}

TEST_F(Files, ThatCannotBeWrittenReportWhy) {
  EXPECT_EQ(ReasonOf([&] { WriteFile(folder_ / "none" / "a", "text"); }),
            (folder_ / "none" / "a").string() + ": cannot be written: No such file or directory");
  WriteFile(folder_ / "a", "text");
  EXPECT_TRUE(ReasonOf([&] {
                MakeDirectories(folder_ / "a" / "b");
              }).starts_with((folder_ / "a" / "b").string() + ": cannot be created: "));
}

TEST_F(Files, AreWithinTheFolderThatLinksAndDotsLeadTo) {
  const fs::path in = folder_ / "in", out = folder_ / "in2";
  MakeDirectories(in / "deep");
  MakeDirectories(out);
  for (const fs::path& file : {in / "deep" / "a", out / "a"}) WriteFile(file, "");
  fs::create_symlink(out, in / "leads_out");
  fs::create_symlink(in / "deep", out / "leads_in");
  fs::create_symlink(in, folder_ / "also_in");

  for (const fs::path& path : {in, in / "deep" / "a", in / "deep" / ".." / "deep" / "a",
                               out / ".." / "in" / "deep", out / "leads_in" / "a"}) {
    EXPECT_TRUE(IsWithin(path, in)) << path;
    EXPECT_TRUE(IsWithin(path, in / "")) << path;
    EXPECT_TRUE(IsWithin(path, folder_ / "also_in")) << path;
    EXPECT_TRUE(IsWithin(path, "/")) << path;
  }
  for (const fs::path& path : {folder_, out, out / "a", in / "..", in / ".." / "in2" / "a",
                               in / "leads_out" / "a", in / "none", fs::path()}) {
    EXPECT_FALSE(IsWithin(path, in)) << path;
    EXPECT_FALSE(IsWithin(path, folder_ / "none")) << path;
  }
}

TEST_F(Files, ThatShipWithUsAreFound) {
  EXPECT_TRUE(fs::exists(DataFile("scenes/tower.xml")));
  EXPECT_TRUE(ReasonOf([] {
                DataFile("scenes/none.xml");
              }).starts_with("scenes/none.xml: not found; looked at\n"));
}

TEST_F(Files, OfAProgramAreSearchedBesideIt) {
  EXPECT_EQ(LibraryFolder(), fs::read_symlink("/proc/self/exe").parent_path());
}

}  // namespace
}  // namespace smile
