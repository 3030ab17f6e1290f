#include "brain_input.h"

#include "kept_inputs.h"

namespace smile::fuzz {
namespace {

class BrainInputs : public KeptInputs {};

TEST_F(BrainInputs, OurOwnAndAllThatEverFailedAreTakenWell) {
  for (const char* folder : {"tests/fuzz/corpus/brain", "tests/fuzz/found/brain"}) {
    for (const std::filesystem::path& file : FilesBelow(folder)) {
      EXPECT_EQ(FaultWithBrainMessage(InputIn(file)), "") << file;
    }
  }
}

TEST_F(BrainInputs, MeantToBeMessagesAreMessages) {
  const auto files = FilesBelow("tests/fuzz/corpus/brain/good");
  EXPECT_FALSE(files.empty());
  for (const auto& file : files) EXPECT_EQ(ReasonAgainstBrainMessage(InputIn(file)), "") << file;
}

TEST_F(BrainInputs, MeantToBeRefusedAreRefused) {
  for (const std::filesystem::path& file : FilesBelow("tests/fuzz/corpus/brain/bad")) {
    EXPECT_NE(ReasonAgainstBrainMessage(InputIn(file)), "") << file;
  }
}

}  // namespace
}  // namespace smile::fuzz
