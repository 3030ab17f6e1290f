#include "trajectory_input.h"

#include "base/diagnostic.h"
#include "kept_inputs.h"

namespace smile::fuzz {
namespace {

class TrajectoryInputs : public KeptInputs {};

TEST_F(TrajectoryInputs, OurOwnAndAllThatEverFailedAreTakenWell) {
  for (const char* folder : {"tests/fuzz/corpus/trajectory", "tests/fuzz/found/trajectory"}) {
    for (const std::filesystem::path& file : FilesBelow(folder)) {
      EXPECT_EQ(FaultWithTrajectory(InputIn(file)), "") << file;
    }
  }
}

TEST_F(TrajectoryInputs, MeantToBeReadAreRead) {
  for (const std::filesystem::path& file : FilesBelow("tests/fuzz/corpus/trajectory/good")) {
    EXPECT_NO_THROW(ReadTrajectoryText(InputIn(file))) << file;
  }
}

TEST_F(TrajectoryInputs, MeantToBeRefusedAreRefused) {
  for (const std::filesystem::path& file : FilesBelow("tests/fuzz/corpus/trajectory/bad")) {
    EXPECT_THROW(ReadTrajectoryText(InputIn(file)), InputError) << file;
  }
}

}  // namespace
}  // namespace smile::fuzz
