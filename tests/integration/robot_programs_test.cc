// The robot programs of python/examples and matlab/examples: each does its task in a layout that it
// has not seen, and the recording replays to the last bit.

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <ostream>
#include <string>

#include "program.h"

namespace smile {
namespace {

/// Checks what a program achieved; `end` is what `run --json` answers.
using Claim = void (*)(const Json& end);

struct RobotProgram {
  const char* brain;  ///< in the project's folder
  const char* scene;  ///< in scenes/, without .xml
  int seed;           ///< of the layout
  Claim claim;
  const char* robot = "baxter";
};
std::string NameOf(const RobotProgram& program) {
  const std::string brain = program.brain;
  return brain.substr(0, brain.find('/')) + "_" + std::filesystem::path(brain).stem().string() +
         "_" + program.robot;
}
void PrintTo(const RobotProgram& program, std::ostream* out) { *out << NameOf(program); }

constexpr double kDegrees = 3.141592653589793 / 180;

double PositionOf(const Json& end, const std::string& object, std::size_t axis) {
  return end.at("objects").at(object).at("position").at(axis).get<double>();
}
/// Returns x and y of an object as seen from another, which stands upright [units].
std::array<double, 2> SeenFrom(const Json& end, const std::string& base,
                               const std::string& object) {
  const double yaw = end.at("objects").at(base).at("rotation").at(2).get<double>() * kDegrees;
  const double x = PositionOf(end, object, 0) - PositionOf(end, base, 0);
  const double y = PositionOf(end, object, 1) - PositionOf(end, base, 1);
  return {std::cos(yaw) * x + std::sin(yaw) * y, std::cos(yaw) * y - std::sin(yaw) * x};
}

void TheFailedDriveIsReplaced(const Json& end) {
  const auto [x, y] = SeenFrom(end, "Rack", "Spare");
  EXPECT_NEAR(x, 1.1, 0.07) << "the slot leaves this room";
  EXPECT_NEAR(y, 0.8, 0.1);
  EXPECT_NEAR(PositionOf(end, "Spare", 2), 1.1, 0.01);
  EXPECT_NEAR(PositionOf(end, "Drive1", 2), 1.1, 0.01) << "the good drive stays";
  const auto [bin_x, bin_y] = SeenFrom(end, "Bin", "Drive2");
  EXPECT_LT(std::hypot(bin_x, bin_y), 0.2);
  EXPECT_EQ(end.at("controls").at("RackLight2"), "ready");
}

void TheWeightIsInTheBox(const Json& end) {
  const auto [x, y] = SeenFrom(end, "Box", "Weight");
  EXPECT_LT(std::max(std::abs(x), std::abs(y)), 0.8);
  EXPECT_NEAR(PositionOf(end, "Weight", 2), 0.45, 0.01);
  EXPECT_NEAR(PositionOf(end, "Scissors", 2), 0.4, 0.01) << "they are put back";
}

void TheHousingIsClosedOverTheGoodFuse(const Json& end) {
  const auto expect_over = [&end](const std::string& object, const std::string& base, double room,
                                  double height) {
    const auto [x, y] = SeenFrom(end, base, object);
    EXPECT_LT(std::max(std::abs(x), std::abs(y)), room) << object;
    EXPECT_NEAR(PositionOf(end, object, 2), height, 0.01) << object;
  };
  expect_over("Spare", "Housing", 0.1, 0.5);
  expect_over("DeadFuse", "Bin", 0.5, 0.5);
  expect_over("Screwdriver", "Holder", 0.07, 1.4);
  expect_over("Cover", "Housing", 0.1, 1.15);
  const double yaw = end.at("objects").at("Housing").at("rotation").at(2).get<double>();
  for (const char* screw : {"ScrewNW", "ScrewNE", "ScrewSW", "ScrewSE"}) {
    const double angle = end.at("objects").at(screw).at("rotation").at(2).get<double>();
    EXPECT_NEAR(PositionOf(end, screw, 2), 1.3, 0.01) << screw;
    EXPECT_NEAR(std::remainder(angle - yaw + 90, 360), 0, 1) << screw << " at its second stage";
  }
}

class RobotPrograms : public ProgramTest, public ::testing::WithParamInterface<RobotProgram> {};

TEST_P(RobotPrograms, DoTheirTaskWhereverItsObjectsStand) {
  const RobotProgram& program = GetParam();
  ASSERT_EQ(Smile("layout '" + Shipped("scenes/" + std::string(program.scene) + ".xml") +
                  "' --level fixtures --out scene.xml --robot " + program.robot + " --seed " +
                  std::to_string(program.seed))
                .exit_code,
            0);
  const Answer run =
      Smile("run scene.xml --robot " + std::string(program.robot) + " --brain '" +
            Shipped(program.brain) + "' --timeout 60 --record run --no-pictures --json");
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_EQ(run.json().at("brain").at("status"), "exited") << run.err;
  program.claim(run.json());
  EXPECT_EQ(Smile("replay run --verify").exit_code, 0);
}

INSTANTIATE_TEST_SUITE_P(
    All, RobotPrograms,
    ::testing::Values(
        RobotProgram{"python/examples/drive/drive.py", "drive_robot", 7, TheFailedDriveIsReplaced},
        RobotProgram{"python/examples/drive/drive.py", "drive_arm", 11, TheFailedDriveIsReplaced,
                     "tern"},
        RobotProgram{"python/examples/scissors/scissors.py", "scissors_arm", 2, TheWeightIsInTheBox,
                     "tern"},
        RobotProgram{"matlab/examples/drive", "drive_arm", 11, TheFailedDriveIsReplaced, "tern"},
        RobotProgram{"matlab/examples/scissors", "scissors_arm", 2, TheWeightIsInTheBox, "tern"},
        RobotProgram{"python/examples/cover/cover.py", "cover_arm", 1,
                     TheHousingIsClosedOverTheGoodFuse, "tern"},
        RobotProgram{"matlab/examples/drive", "drive_robot", 8, TheFailedDriveIsReplaced},
        RobotProgram{"python/examples/scissors/scissors.py", "scissors_robot", 7,
                     TheWeightIsInTheBox},
        RobotProgram{"matlab/examples/scissors", "scissors_robot", 8, TheWeightIsInTheBox},
        RobotProgram{"matlab/examples/cover", "cover_robot", 8, TheHousingIsClosedOverTheGoodFuse}),
    [](const auto& parameter) { return NameOf(parameter.param); });

}  // namespace
}  // namespace smile
