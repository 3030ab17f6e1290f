#include "scene_input.h"

#include "kept_inputs.h"

namespace smile::fuzz {
namespace {

class SceneInputs : public KeptInputs {};

TEST_F(SceneInputs, OurOwnAndAllThatEverFailedAreTakenWell) {
  int num_files = 0;
  for (const char* folder : {"scenes", "tests/fuzz/corpus/scene", "tests/fuzz/found/scene"}) {
    for (const std::filesystem::path& file : FilesBelow(folder)) {
      if (folder == std::string("scenes") && file.extension() != ".xml") continue;
      EXPECT_EQ(FaultWithScene(InputIn(file)), "") << file;
      ++num_files;
    }
  }
  EXPECT_GT(num_files, 20);
}

TEST_F(SceneInputs, MeantToBeScenesAreScenes) {
  for (const std::filesystem::path& file : FilesBelow("tests/fuzz/corpus/scene/good")) {
    for (const Diagnostic& diagnostic : ReadHostileScene(InputIn(file)).diagnostics) {
      ADD_FAILURE() << file << ToString(diagnostic);
    }
  }
}

TEST_F(SceneInputs, MeantToBeRefusedAreRefused) {
  for (const std::filesystem::path& file : FilesBelow("tests/fuzz/corpus/scene/bad")) {
    EXPECT_FALSE(ReadHostileScene(InputIn(file)).diagnostics.empty()) << file;
  }
}

}  // namespace
}  // namespace smile::fuzz
