#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <vector>

#include "base/files.h"
#include "scene_xml/scene_reader.h"
#include "scene_xml/scene_writer.h"

namespace smile::scene_xml {
namespace {

std::vector<std::filesystem::path> XmlFilesIn(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() == ".xml") files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

TEST(ShippedScenes, ComeBackEqualFromTheirOwnWriting) {
  for (const auto& file : XmlFilesIn(DataFile("scenes"))) {
    const scene::SceneSpec scene = LoadScene(file);
    EXPECT_FALSE(scene.objects.empty()) << file;
    const SceneReading reading = ReadSceneText(WriteScene(scene), scene.name + ".xml");
    for (const Diagnostic& diagnostic : reading.diagnostics) ADD_FAILURE() << ToString(diagnostic);
    ASSERT_TRUE(reading.scene) << file;
    EXPECT_EQ(*reading.scene, scene) << file;
  }
}

TEST(ShippedScenes, BeginWithALineThatSaysWhatTheyShow) {
  std::vector<std::filesystem::path> files = XmlFilesIn(DataFile("scenes"));
  std::ranges::copy(XmlFilesIn(DataFile("scenes/parts")), std::back_inserter(files));
  for (const auto& file : files) {
    EXPECT_TRUE(ReadFile(file, 1 << 20).starts_with("<!-- Authored for SMILE. ")) << file;
  }
}

}  // namespace
}  // namespace smile::scene_xml
