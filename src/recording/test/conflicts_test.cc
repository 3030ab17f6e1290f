#include "recording/conflicts.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include "base/diagnostic.h"
#include "base/files.h"

namespace smile::recording {
namespace {

using demonstrator::HandName;

class Conflicts : public ::testing::Test {
 protected:
  Conflicts() {
    root_ =
        std::filesystem::temp_directory_path() / ("smile_conflicts_" + std::to_string(getpid()));
    std::filesystem::create_directories(root_);
  }
  ~Conflicts() override { std::filesystem::remove_all(root_); }

  std::string FaultOf(const std::string& text) const {
    WriteFile(root_ / "conflicts.json", text);
    try {
      (void)ReadConflicts(root_);
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  }

  std::filesystem::path root_;
};

TEST_F(Conflicts, AreReadAsTheyWereWritten) {
  const std::vector<Conflict> conflicts{{HandName::kLeft, 1.25, "\"a\" is\n gone"},
                                        {std::nullopt, 2.5, texts::Say("session.noRobot")}};
  WriteConflicts(root_, conflicts);
  EXPECT_EQ(ReadConflicts(root_), conflicts);
  EXPECT_EQ(ReadConflicts(root_)[1].reason.id(), "session.noRobot");
  RemoveConflictsAfter(root_, 1.25);
  EXPECT_EQ(ReadConflicts(root_), std::vector{conflicts[0]});
  RemoveConflictsAfter(root_, 1);
  EXPECT_FALSE(std::filesystem::exists(root_ / "conflicts.json"));
  EXPECT_EQ(ReadConflicts(root_), std::vector<Conflict>());
}

TEST_F(Conflicts, StayReadableHoweverManyAndLongTheyAre) {
  WriteConflicts(root_, std::vector<Conflict>(2000, {HandName::kRight, 1, "it is gone"}));
  EXPECT_EQ(ReadConflicts(root_).size(), kMaxConflicts);
  WriteConflicts(root_,
                 std::vector<Conflict>(9, {HandName::kRight, 1, std::string(100'000, '\1')}));
  EXPECT_EQ(ReadConflicts(root_).size(), 5u);
}

TEST_F(Conflicts, AreInEnglishIfTheirMessagesAreOfAnotherVersion) {
  for (const char* message : {R"({"say":"of.another"})", R"({"say":"session.noObject"})", "7"}) {
    EXPECT_EQ(FaultOf(R"({"conflicts":[{"hand":null,"seconds":1,"reason":"it is gone","message":)" +
                      std::string(message) + "}]}"),
              "");
    EXPECT_EQ(ReadConflicts(root_)[0].reason, "it is gone");
  }
}

TEST_F(Conflicts, NameFaultsWithTheirPlace) {
  const std::string file = (root_ / "conflicts.json").string();
  EXPECT_EQ(FaultOf(R"({"conflicts":[{"hand":"third","seconds":1,"reason":""}]})"),
            file + ": <conflicts/0/hand>: found \"third\", expected a hand or null");
  EXPECT_NE(FaultOf(R"({"conflicts":[{"hand":null,"seconds":-1,"reason":""}]})").find("seconds"),
            std::string::npos);
  EXPECT_NE(FaultOf(R"({"conflicts":[{"hand":null,"seconds":1}]})").find("reason"),
            std::string::npos);
  EXPECT_NE(FaultOf(R"({"conflict":[]})").find("conflict"), std::string::npos);
  EXPECT_NE(FaultOf("[").find(file), std::string::npos);
  EXPECT_NE(FaultOf(R"({"conflicts":{}})"), "");
}

}  // namespace
}  // namespace smile::recording
