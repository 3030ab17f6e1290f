#include <gtest/gtest.h>

#include <filesystem>

#include "base/files.h"

namespace smile::scene_xml {
namespace {

TEST(ShippedScenes, BeginWithALineThatSaysWhatTheyShow) {
  for (const char* folder : {"scenes", "scenes/parts"}) {
    for (const auto& entry : std::filesystem::directory_iterator(DataFile(folder))) {
      if (entry.path().extension() != ".xml") continue;
      EXPECT_TRUE(ReadFile(entry.path(), 1 << 20).starts_with("<!-- Authored for SMILE. "))
          << entry.path();
    }
  }
}

}  // namespace
}  // namespace smile::scene_xml
