// What a session draws.

#include "picture/rendered_eye.h"
#include "session_fixture.h"

namespace smile::studio {
namespace {

using SessionGlTest = SessionFixture;

/// Pictures of a recording, by name.
std::map<std::string, std::string> PicturesOf(const std::filesystem::path& recording) {
  std::map<std::string, std::string> pictures;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(recording)) {
    if (entry.path().extension() != ".png") continue;
    pictures[entry.path().lexically_relative(recording)] = ReadFile(entry.path(), 1 << 20);
  }
  return pictures;
}

TEST_F(SessionGlTest, ARecordingThatIsGoneOnWithKeepsItsPicturesAndGetsMore) {
  picture::RenderedEye eye({.width_px = 64, .height_px = 48});
  Begin(&eye);
  Command(R"({"do":"start","name":"take"})");
  TickSeconds(0.1);
  Command(R"({"do":"grasp","hand":"left","object":"a","point":[0,-2,1]})");
  Command(R"({"do":"move_to","hand":"left","position":[0,-2,4]})");
  TickSeconds(0.6);
  Command(R"({"do":"finish"})");
  const auto before = PicturesOf(root_ / "recordings/take");
  ASSERT_GE(before.size(), 2u);

  Do(R"({"do":"branch","recording":"take","step":1})");
  EXPECT_EQ(PicturesOf(root_ / "recordings/take"), before);
  Command(R"({"do":"move_to","hand":"left","position":[1,-2,2]})");
  TickSeconds(0.6);
  Command(R"({"do":"finish"})");
  EXPECT_GT(PicturesOf(root_ / "recordings/take").size(), before.size());
}

}  // namespace
}  // namespace smile::studio
