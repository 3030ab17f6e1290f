#include "library/scene_catalog.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include "base/files.h"

namespace smile::library {
namespace {

class SceneCatalogTest : public ::testing::Test {
 protected:
  SceneCatalogTest() {
    folder_ = std::filesystem::temp_directory_path() /
              ("smile_scene_catalog_" + std::to_string(getpid()) + "_" +
               ::testing::UnitTest::GetInstance()->current_test_info()->name());
    std::filesystem::create_directories(folder_);
  }
  ~SceneCatalogTest() override { std::filesystem::remove_all(folder_); }

  std::string TitleOf(const std::string& text) {
    WriteFile(folder_ / "scene.xml", text);
    const Json list = SceneCatalog(folder_).List();
    return list.size() == 1 ? list[0]["title"].get<std::string>() : "not listed";
  }

  std::filesystem::path folder_;
};

TEST_F(SceneCatalogTest, TitlesAreThePhraseThatTheFirstCommentBeginsWith) {
  EXPECT_EQ(TitleOf("<!-- Authored for SMILE. Two towers: the taller one\nfalls. --><tabletop/>"),
            "Two towers");
  EXPECT_EQ(TitleOf("<?xml version='1.0'?>\n<!-- Three\nblocks (1.5 high) --><tabletop/>"),
            "Three blocks");
  EXPECT_EQ(TitleOf("<!--> 2 blocks. --><tabletop/>"), "> 2 blocks");
  const std::string body(5000, ' ');
  EXPECT_EQ(TitleOf("<!-- A long scene. --><tabletop>" + body + "</tabletop>"), "A long scene");
  EXPECT_EQ(TitleOf("<!-- A broken scene. --><tabletop>"), "A broken scene");
}

TEST_F(SceneCatalogTest, ScenesWithoutACommentInFrontHaveTheirName) {
  EXPECT_EQ(TitleOf("<tabletop><!-- Inside. --></tabletop>"), "scene");
  EXPECT_EQ(TitleOf("<tabletop/><!-- Behind. -->"), "scene");
  EXPECT_EQ(TitleOf("<!-- " + std::string(300, 'x') + " --><tabletop/>"), "scene");
  EXPECT_EQ(TitleOf("<?note <!-- In an instruction. --> ?><tabletop/>"), "scene");
  EXPECT_EQ(TitleOf("no XML <!-- at all -->"), "scene");
  EXPECT_EQ(TitleOf(""), "scene");
}

TEST_F(SceneCatalogTest, NoNameLeadsOutOfTheFolder) {
  WriteFile(folder_ / "scene.xml", "<tabletop/>");
  const SceneCatalog catalog(folder_);
  EXPECT_TRUE(catalog.FileOf("scene"));
  std::filesystem::create_symlink(folder_ / "scene.xml", folder_ / "link.xml");
  for (const char* name : {"", "link", "missing", ".", "../scene", "/scene"}) {
    EXPECT_FALSE(catalog.FileOf(name)) << name;
  }
}

}  // namespace
}  // namespace smile::library
