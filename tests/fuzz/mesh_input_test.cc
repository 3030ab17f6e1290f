#include "mesh_input.h"

#include "base/diagnostic.h"
#include "kept_inputs.h"

namespace smile::fuzz {
namespace {

class MeshInputs : public KeptInputs {};

TEST_F(MeshInputs, OurOwnAndAllThatEverFailedAreTakenWell) {
  int num_files = 0;
  for (const char* folder : {"tests/fuzz/corpus/mesh", "tests/fuzz/found/mesh"}) {
    for (const std::filesystem::path& file : FilesBelow(folder)) {
      EXPECT_EQ(FaultWithMesh(InputIn(file)), "") << file;
      ++num_files;
    }
  }
  EXPECT_GT(num_files, 8);
}

TEST_F(MeshInputs, MeantToBeMeshesAreMeshes) {
  for (const std::filesystem::path& file : FilesBelow("tests/fuzz/corpus/mesh/good")) {
    EXPECT_NO_THROW(ImportHostileMesh(InputIn(file))) << file;
  }
}

TEST_F(MeshInputs, MeantToBeRefusedAreRefused) {
  for (const std::filesystem::path& file : FilesBelow("tests/fuzz/corpus/mesh/bad")) {
    EXPECT_THROW(ImportHostileMesh(InputIn(file)), InputError) << file;
  }
}

}  // namespace
}  // namespace smile::fuzz
