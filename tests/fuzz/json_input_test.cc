#include "json_input.h"

#include "base/json.h"
#include "kept_inputs.h"

namespace smile::fuzz {
namespace {

class JsonInputs : public KeptInputs {};

TEST_F(JsonInputs, OurOwnAndAllThatEverFailedAreTakenWell) {
  for (const char* folder : {"tests/fuzz/corpus/json", "tests/fuzz/found/json"}) {
    for (const std::filesystem::path& file : FilesBelow(folder)) {
      EXPECT_EQ(FaultWithJson(InputIn(file)), "") << file;
    }
  }
}

TEST_F(JsonInputs, MeantToBeJsonAreJson) {
  for (const std::filesystem::path& file : FilesBelow("tests/fuzz/corpus/json/good")) {
    EXPECT_NO_THROW(ParseJson(InputIn(file))) << file;
  }
}

TEST_F(JsonInputs, MeantToBeRefusedAreRefused) {
  for (const std::filesystem::path& file : FilesBelow("tests/fuzz/corpus/json/bad")) {
    EXPECT_THROW(ParseJson(InputIn(file)), std::invalid_argument) << file;
  }
}

}  // namespace
}  // namespace smile::fuzz
