#include "robot_input.h"

#include "base/diagnostic.h"
#include "kept_inputs.h"

namespace smile::fuzz {
namespace {

class RobotInputs : public KeptInputs {};

TEST_F(RobotInputs, OurOwnAndAllThatEverFailedAreTakenWell) {
  int num_files = 0;
  for (const char* folder : {"robots", "tests/fuzz/corpus/robot", "tests/fuzz/found/robot"}) {
    for (const std::filesystem::path& file : FilesBelow(folder)) {
      EXPECT_EQ(FaultWithRobot(InputIn(file)), "") << file;
      ++num_files;
    }
  }
  EXPECT_GT(num_files, 15);
}

TEST_F(RobotInputs, MeantToBeRobotsAreRobots) {
  for (const std::filesystem::path& file : FilesBelow("tests/fuzz/corpus/robot/good")) {
    EXPECT_NO_THROW(ReadHostileRobot(InputIn(file))) << file;
  }
}

TEST_F(RobotInputs, MeantToBeRefusedAreRefused) {
  for (const std::filesystem::path& file : FilesBelow("tests/fuzz/corpus/robot/bad")) {
    EXPECT_THROW(ReadHostileRobot(InputIn(file)), InputError) << file;
  }
}

}  // namespace
}  // namespace smile::fuzz
