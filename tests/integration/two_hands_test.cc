// The examples of two hands, examples/two_hands: each hand is recorded alone, and one recording
// laid over the other. Together they reach what neither reaches alone.

#include <array>
#include <cmath>
#include <map>
#include <sstream>

#include "program.h"

namespace smile {
namespace {

using Pose = std::array<double, 6>;  // position [units], rotation about x, y, z [degrees]

/// Example: its scripts are NAME_left.jsonl and NAME_right.jsonl.
struct TwoHands {
  const char* name;
  const char* right_scene;  ///< in which the right hand was recorded
  double overlay_at;        ///< [s]
};
constexpr TwoHands kTray{"tray", "tray", 0}, kBunker{"bunker", "bunker", 1},
    kBolt{"bolt", "bolt_held", 4};

class TwoHandsTest : public ProgramTest {
 protected:
  void Record(const std::string& example, const std::string& scene, const std::string& hand) const {
    const Answer run = Smile("run '" + Shipped("scenes/" + scene + ".xml") + "' --commands '" +
                             Shipped("examples/two_hands/" + example + "_" + hand + ".jsonl") +
                             "' --no-robot --no-pictures --record " + hand);
    ASSERT_EQ(run.exit_code, 0) << run.err;
  }
  /// Records both hands and lays the right one over the left one, in the recording `both`.
  /// @returns the report.
  Json Overlay(const TwoHands& example) const {
    Record(example.name, example.name, "left");
    Record(example.name, example.right_scene, "right");
    const Answer edit = Smile("edit left --overlay right --overlay-at " +
                              std::to_string(example.overlay_at) + " --out both --json");
    EXPECT_EQ(edit.exit_code, 0) << edit.err;
    EXPECT_EQ(Smile("replay both --verify").exit_code, 0);
    return edit.json();
  }
  /// Returns where objects come to rest in a recording, by its classic view: those that moved.
  std::map<std::string, Pose> EndsIn(const std::string& demo) const {
    std::map<std::string, Pose> ends;
    for (int segment = 0; Exists(demo + "/" + std::to_string(segment) + ".txt"); ++segment) {
      std::istringstream lines(Read(demo + "/" + std::to_string(segment) + ".txt"));
      for (std::string line; std::getline(lines, line);) {
        std::istringstream words(line);
        std::string frame, what, id, number;
        std::getline(words, frame, ',');
        std::getline(words, what, ',');
        std::getline(words, id, ',');
        if (what != "move") continue;
        for (double& one : ends[id]) one = std::getline(words, number, ',') ? std::stod(number) : 0;
      }
    }
    return ends;
  }
  /// Expects an object to be level, at a height and within `reach` of a place [units].
  static void ExpectLevelAt(const Pose& pose, const std::array<double, 3>& place, double reach) {
    EXPECT_NEAR(std::hypot(pose[0] - place[0], pose[1] - place[1]), 0, reach);
    EXPECT_NEAR(pose[2], place[2], 0.01);
    EXPECT_NEAR(pose[3], 0, 1);
    EXPECT_NEAR(pose[4], 0, 1);
  }
};

TEST_F(TwoHandsTest, CarryATrayWithWhatIsOnIt) {
  const Json report = Overlay(kTray);
  EXPECT_TRUE(report["conflicts"].empty()) << report;
  auto ends = EndsIn("both");
  ExpectLevelAt(ends["Tray"], {0, 2.6, 1.9}, 0.2);
  ExpectLevelAt(ends["RedCube"], {-1, 2.6, 2.35}, 0.2);
  ExpectLevelAt(ends["BlueCube"], {1, 2.6, 2.35}, 0.2);
  // One hand alone tips it.
  for (const char* alone : {"left", "right"}) {
    EXPECT_GT(std::abs(EndsIn(alone)["Tray"][5]) + std::abs(EndsIn(alone)["Tray"][3]), 10) << alone;
  }
}

TEST_F(TwoHandsTest, HoldALidOpenWhileSomethingIsPutIn) {
  EXPECT_TRUE(Overlay(kBunker)["conflicts"].empty());
  const Answer described = Smile("describe both");
  EXPECT_NE(described.out.find("Coal in Bunker"), std::string::npos) << described.out;
  auto ends = EndsIn("both");
  // It has slid shut above the block.
  ends.try_emplace("BunkerLid");
  EXPECT_NEAR(ends["BunkerLid"][2], EndsIn("left")["BunkerLid"][2], 0.01);
  EXPECT_LT(ends["Coal"][2], ends["BunkerLid"][2] - 0.8);
  EXPECT_GT(EndsIn("right")["Coal"][2], ends["BunkerLid"][2]) << "alone, it stays on the lid";
}

TEST_F(TwoHandsTest, HoldABoltWhileANutIsTurned) {
  const Json report = Overlay(kBolt);
  EXPECT_TRUE(report["conflicts"].empty()) << report;
  ASSERT_EQ(report["host_points"].size(), 1u);
  EXPECT_EQ(report["host_points"][0]["after"], "3");
  auto ends = EndsIn("both");
  ExpectLevelAt(ends["Bolt"], {0, -1.5, 1.6}, 0.02);
  ExpectLevelAt(ends["Nut"], {0, -1.5, 1.6}, 0.02);
}

TEST_F(TwoHandsTest, ThatMeetTooEarlyConflict) {
  Record(kBolt.name, kBolt.name, "left");
  Record(kBolt.name, kBolt.right_scene, "right");
  // The bolt is taken 4 s later.
  const Json report = Smile("edit left --shift 1-2:4 --overlay right --dry-run --json").json();
  ASSERT_FALSE(report["conflicts"].empty());
  EXPECT_EQ(report["conflicts"][0]["hand"], "right");
  EXPECT_EQ(report["conflicts"][0]["reason"],
            "no free point that fits 'NutHole' is within two units");
}

}  // namespace
}  // namespace smile
