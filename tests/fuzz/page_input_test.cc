#include "page_input.h"

#include "kept_inputs.h"

namespace smile::fuzz {
namespace {

class PageInputs : public KeptInputs {};

TEST_F(PageInputs, OurOwnAndAllThatEverFailedAreTakenWell) {
  for (const char* folder : {"tests/fuzz/corpus/page", "tests/fuzz/found/page"}) {
    for (const std::filesystem::path& file : FilesBelow(folder)) {
      EXPECT_EQ(FaultWithPageInput(InputIn(file)), "") << file;
    }
  }
}

TEST_F(PageInputs, MeantToBeTakenAreTaken) {
  const auto files = FilesBelow("tests/fuzz/corpus/page/good");
  EXPECT_FALSE(files.empty());
  for (const auto& file : files) EXPECT_EQ(ReasonAgainstPageInput(InputIn(file)), "") << file;
}

TEST_F(PageInputs, MeantToBeRefusedAreRefused) {
  for (const std::filesystem::path& file : FilesBelow("tests/fuzz/corpus/page/bad")) {
    EXPECT_NE(ReasonAgainstPageInput(InputIn(file)), "") << file;
  }
}

}  // namespace
}  // namespace smile::fuzz
