#include <gtest/gtest.h>

#include <random>

#include "robot/test/robot_files.h"

namespace smile::robot {
namespace {

class UrdfReaderProperty : public RobotFiles {};

/// Returns the text with a few letters changed, a piece removed or a piece duplicated.
std::string Damaged(std::string text, std::mt19937* random) {
  const auto below = [&](std::size_t end) {
    return std::uniform_int_distribution<std::size_t>(0, end - 1)(*random);
  };
  constexpr std::string_view kLetters = "<>/\"'= -.0129eainx\n";
  switch (below(3)) {
    case 0:
      for (int i = 0; i < 4; ++i) text[below(text.size())] = kLetters[below(kLetters.size())];
      break;
    case 1:
      text.erase(below(text.size()), below(200) + 1);
      break;
    default:
      text.insert(below(text.size()), text.substr(below(text.size()), below(200) + 1));
  }
  return text;
}

TEST_F(UrdfReaderProperty, DamagedFilesAreReadOrRefusedWithAnAddress) {
  constexpr int kTrials = 400;
  const std::string urdf = ReadFile(DataFile("robots/baxter.urdf"), 1 << 20);
  const std::string side_file = ReadFile(DataFile("robots/baxter.robot.json"), 1 << 20);
  std::mt19937 random(5);
  for (int trial = 0; trial < kTrials; ++trial) {
    const bool is_side_file = trial % 4 == 0;
    const std::string message = is_side_file ? Complaint(urdf, Damaged(side_file, &random))
                                             : Complaint(Damaged(urdf, &random), side_file);
    EXPECT_TRUE(message.empty() || message.starts_with("r.")) << message;
  }
}

}  // namespace
}  // namespace smile::robot
