#include <gtest/gtest.h>

#include <filesystem>

#include "base/files.h"

namespace smile::scene_xml {
namespace {

TEST(ShippedScenes, BeginWithALineThatDescribesThem) {
  for (const char* folder : {"scenes", "scenes/parts"}) {
    int num_scenes = 0;
    for (const auto& entry : std::filesystem::directory_iterator(DataFile(folder))) {
      if (entry.path().extension() != ".xml") continue;
      ++num_scenes;
      EXPECT_TRUE(ReadFile(entry.path(), 1 << 20).starts_with("<!-- Authored for SMILE. "))
          << entry.path();
    }
    EXPECT_GT(num_scenes, 3) << folder;
  }
}

}  // namespace
}  // namespace smile::scene_xml
