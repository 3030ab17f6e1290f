#include "library/content_routes.h"

#include <cstdlib>
#include <set>
#include <thread>

#include "image/png.h"
#include "recorder/test/recording_fixture.h"

namespace smile::library {
namespace {

class ContentRoutesTest : public recorder::RecordingFixture {
 protected:
  ContentRoutesTest() {
    std::filesystem::create_directories(scenes());
    WriteFile(scenes() / "pair.xml", std::string("<?xml version=\"1.0\"?>\n"
                                                 "<!-- Authored for SMILE. A red block: of two.\n"
                                                 "  More. -->\n") +
                                         kScene);
    WriteFile(scenes() / "wrong.xml", "<tabletop><block/></tabletop>");
    WriteFile(root_ / "secret.xml", kScene);
    std::filesystem::create_symlink(root_ / "secret.xml", scenes() / "link.xml");
  }

  std::filesystem::path scenes() const { return root_ / "scenes"; }

  /// Returns the picture at a path.
  Image PictureAt(const std::string& path) {
    const auto answer = content_routes_.Get(path);
    EXPECT_TRUE(answer) << path;
    if (!answer) return {};
    EXPECT_EQ(answer->type, "image/png");
    WriteFile(root_ / "got.png", answer->body);
    return ReadPng(root_ / "got.png");
  }

  ContentRoutes content_routes_{{.scenes = root_ / "scenes",
                                 .recordings = root_,
                                 .presets = {{{"name", "bricks"}, {"title", "Bricks"}}}}};
};

TEST_F(ContentRoutesTest, ListsScenesAndPresets) {
  const auto answer = content_routes_.Get("/scenes");
  ASSERT_TRUE(answer);
  EXPECT_EQ(answer->type, "application/json");
  const Json catalog = ParseJson(answer->body);
  ASSERT_EQ(catalog["scenes"].size(), 2u) << answer->body;
  EXPECT_EQ(catalog["scenes"][0],
            (Json{{"name", "pair"}, {"title", "A red block"}, {"picture", "/scenes/pair.png"}}));
  EXPECT_EQ(catalog["scenes"][1]["title"], "wrong");
  EXPECT_EQ(catalog["presets"][0]["title"], "Bricks");
  const auto text = content_routes_.Get("/scenes/pair.xml");
  ASSERT_TRUE(text);
  EXPECT_EQ(text->body, ReadFile(scenes() / "pair.xml", 1 << 20));
}

TEST_F(ContentRoutesTest, RefusesAllOtherPaths) {
  Record(R"({"do":"wait","seconds":0.1})");
  for (const char* path :
       {"/scenes/../secret.xml", "/scenes/link.xml", "/scenes/link.png", "/scenes/none.png",
        "/scenes/.xml", "/scenes/", "/recordings/none/picture.png", "/recordings/none.zip",
        "/recordings/../demo/picture.png", "/recordings/demo/segments/9.png",
        "/recordings/demo/segments/-1.png", "/recordings/demo/segments/0x.png",
        "/recordings/demo/trace.bin", "/recordings/demo", "/recordings/.zip", "/", ""}) {
    EXPECT_FALSE(content_routes_.Get(path)) << path;
  }
  EXPECT_THROW(content_routes_.Get("/scenes/wrong.png"), InputError);
}

TEST_F(ContentRoutesTest, ServesFilmsFromTheirFolderOnly) {
  std::filesystem::create_directories(root_ / "films/folder.mp4");
  WriteFile(root_ / "films/a tower.mp4", "frames");
  WriteFile(root_ / "secret.mp4", "secret");
  WriteFile(root_ / "films/tower.log", "log");
  const auto film = content_routes_.Get("/films/a tower.mp4");
  ASSERT_TRUE(film);
  EXPECT_EQ(film->type, "video/mp4");
  EXPECT_EQ(film->body, "frames");
  EXPECT_EQ(film->file_name, "a tower.mp4");
  for (const char* path : {"/films/../secret.mp4", "/films/none.mp4", "/films/folder.mp4",
                           "/films/tower.log", "/films/.mp4", "/films/", "/films"}) {
    EXPECT_FALSE(content_routes_.Get(path)) << path;
  }
}

TEST_F(ContentRoutesTest, ThumbnailsDependOnContent) {
  Record(kStackAOnB, /*with_robot=*/true);
  const Image scene = PictureAt("/scenes/pair.png");
  EXPECT_EQ(scene.width_px, 320);
  EXPECT_EQ(scene.height_px, 240);
  const Image start = PictureAt("/recordings/demo/segments/0.png");
  const Image moved = PictureAt("/recordings/demo/segments/1.png");
  const Image end = PictureAt("/recordings/demo/segments/2.png");
  EXPECT_TRUE(start.color == scene.color) << "nothing has moved, and there is no robot to be seen";
  EXPECT_TRUE(moved.color != start.color);
  EXPECT_TRUE(end.color != moved.color);
  EXPECT_TRUE(PictureAt("/recordings/demo/picture.png").color == end.color);
  EXPECT_GT(std::set<std::uint8_t>(end.color.begin(), end.color.end()).size(), 50u);
}

TEST_F(ContentRoutesTest, ShowsTheEndAsTheRobotSeesIt) {
  Record(kStackAOnB, /*with_robot=*/true);
  const Image eye = PictureAt("/recordings/demo/eye.png");
  EXPECT_EQ(eye.width_px, 320);
  EXPECT_TRUE(eye.color != PictureAt("/recordings/demo/picture.png").color);
  EXPECT_GT(std::set<std::uint8_t>(eye.color.begin(), eye.color.end()).size(), 50u);
}

TEST_F(ContentRoutesTest, RendersAChangedSceneAgain) {
  const Image before = PictureAt("/scenes/pair.png");
  std::string xml = kScene;
  xml.replace(xml.find("red"), 3, "blue");
  WriteFile(scenes() / "pair.xml", xml);
  EXPECT_TRUE(PictureAt("/scenes/pair.png").color != before.color);
}

TEST_F(ContentRoutesTest, ServesSeveralThreadsAtOnce) {
  Record();
  std::vector<std::thread> clients;
  std::vector<std::string> seen(8);
  for (std::size_t i = 0; i < seen.size(); ++i) {
    clients.emplace_back([this, i, &seen] {
      const auto answer =
          content_routes_.Get("/recordings/demo/segments/" + std::to_string(i % 2) + ".png");
      if (answer) seen[i] = answer->body;
    });
  }
  for (std::thread& client : clients) client.join();
  for (std::size_t i = 0; i < seen.size(); ++i) {
    EXPECT_FALSE(seen[i].empty());
    EXPECT_TRUE(seen[i] == seen[i % 2]) << i;
  }
  EXPECT_TRUE(seen[0] != seen[1]);
}

TEST_F(ContentRoutesTest, ReportsThatRenderingIsUnavailable) {
  setenv("SMILE_EGL_PLATFORM", "none", 1);
  EXPECT_THROW(content_routes_.Get("/scenes/pair.png"), std::runtime_error);
  unsetenv("SMILE_EGL_PLATFORM");
  EXPECT_TRUE(content_routes_.Get("/scenes/pair.png")) << "the next call may succeed";
}

}  // namespace
}  // namespace smile::library
