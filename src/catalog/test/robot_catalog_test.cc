#include "catalog/robot_catalog.h"

#include <algorithm>

#include "catalog/robot_check.h"
#include "catalog/test/made_urdf.h"

namespace smile::catalog {
namespace {

class RobotCatalog : public MadeRobots {
 protected:
  std::string Refusal(const auto& action) {
    try {
      action();
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "";
  }
};

TEST_F(RobotCatalog, FindsShippedRobotsByName) {
  const std::vector<CatalogEntry> robots = AllRobots();
  ASSERT_GE(robots.size(), 2u);
  EXPECT_EQ(robots[0].name, "baxter");
  EXPECT_TRUE(robots[0].is_shipped);
  EXPECT_EQ(FindRobot("tern").urdf, DataFile("robots/tern.urdf"));
  const std::filesystem::path urdf = WriteUrdf("");
  EXPECT_EQ(FindRobot(urdf.string()).urdf, urdf);
}

TEST_F(RobotCatalog, KeepsAddedRobotsWithTheirFiles) {
  const std::filesystem::path urdf = WriteUrdf(ChainText("a", 6));
  const robot::RobotReading reading =
      robot::LoadRobot(urdf, {.side_file_text = GuessRobot(urdf, {}).side_file});
  const std::filesystem::path folder = AddRobot("mine", reading.files);
  EXPECT_EQ(folder, folder_ / "data/smile/robots/mine");
  std::filesystem::remove(urdf);
  const RobotSource source = FindRobot("mine");
  EXPECT_EQ(source.urdf, folder / "mine.urdf");
  EXPECT_EQ(robot::ReadRobot(source.urdf).arms.size(), 1u);
  EXPECT_EQ(AllRobots().back().name, "mine");
  EXPECT_FALSE(AllRobots().back().is_shipped);
}

TEST_F(RobotCatalog, RefusesUnknownNamesAndNamesThatAreTaken) {
  EXPECT_EQ(Refusal([] { FindRobot("bakster"); }),
            "no robot is called \"bakster\", expected baxter or tern, or the path of a URDF; did "
            "you mean \"baxter\"?");
  EXPECT_EQ(Refusal([] { CheckNewName("tern"); }), "there is a robot \"tern\", " +
                                                       DataFile("robots/tern.urdf").string() +
                                                       ", expected another name");
  for (const std::string name : {"", "../x", "7", "a b", ".hidden"}) {
    EXPECT_EQ(Refusal([&] { CheckNewName(name); }),
              "the name is \"" + name +
                  "\", expected a letter, then letters, digits, _ or -, 40 at most");
  }
  EXPECT_EQ(Refusal([] { CheckNewName("ur5e-left_2"); }), "");
}

TEST_F(RobotCatalog, ShipsRobotsInWhichNothingIsWrong) {
  for (const CatalogEntry& entry : AllRobots()) {
    const robot::RobotReading reading = robot::LoadRobot(entry.urdf, {.has_appearance = false});
    model::RobotPlacement placement{.model = reading.model};
    placement.gap = reading.gap.value_or(placement.gap);
    placement.height = reading.height.value_or(placement.height);
    EXPECT_EQ(CheckRobot(placement).findings, std::vector<std::string>()) << entry.name;
  }
}

TEST_F(RobotCatalog, FindsPosesInWhichLinksOverlap) {
  const std::filesystem::path urdf = WriteUrdf(ChainText("a", 6));
  // The elbow folds the arm onto itself.
  const robot::RobotModel folded = robot::ReadRobot(urdf, {.side_file_text = R"({"format": 2,
"arms": {"arm": {"joints": ["a1", "a2", "a3", "a4", "a5", "a6"], "tool": "a6"}},
"never_collide": [["base", "a1"], ["a1", "a2"], ["a2", "a3"], ["a3", "a4"], ["a4", "a5"], ["a5", "a6"]],
"poses": {"ready": {"arm": [0, 1.6, 2, 2, 0, 1.6]}}, "start": "ready"})"});
  const RobotReport report = CheckRobot({.model = folded});
  ASSERT_FALSE(report.findings.empty());
  EXPECT_TRUE(std::ranges::any_of(report.findings, [](const std::string& finding) {
    return finding.starts_with("pose \"ready\": ") &&
           finding.find(" overlap by ") != std::string::npos;
  })) << report.findings.front();
}

}  // namespace
}  // namespace smile::catalog
