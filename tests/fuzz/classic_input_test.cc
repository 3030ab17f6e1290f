#include "classic_input.h"

#include "base/diagnostic.h"
#include "kept_inputs.h"

namespace smile::fuzz {
namespace {

class ClassicInputs : public KeptInputs {};

TEST_F(ClassicInputs, OurOwnAndAllThatEverFailedAreTakenWell) {
  for (const char* folder : {"tests/fuzz/corpus/classic", "tests/fuzz/found/classic"}) {
    for (const std::filesystem::path& file : FilesBelow(folder)) {
      EXPECT_EQ(FaultWithClassic(InputIn(file)), "") << file;
    }
  }
}

TEST_F(ClassicInputs, MeantToBeReadAreRead) {
  for (const std::filesystem::path& file : FilesBelow("tests/fuzz/corpus/classic/good")) {
    EXPECT_NO_THROW(ReadSegments(InputIn(file))) << file;
  }
}

TEST_F(ClassicInputs, MeantToBeRefusedAreRefused) {
  for (const std::filesystem::path& file : FilesBelow("tests/fuzz/corpus/classic/bad")) {
    EXPECT_THROW(ReadSegments(InputIn(file)), InputError) << file;
  }
}

}  // namespace
}  // namespace smile::fuzz
