// What is drawn when an edit is saved.

#include "library_requests_fixture.h"
#include "picture/rendered_eye.h"

namespace smile::studio {
namespace {

bool draws_on_threads = false;

/// Drawing on the threads of jobs leaves threads of Mesa behind. At their end, the leak search of
/// clang 14 often reads from an invalid address and fails a test that has passed.
class LibraryRequestsGlTest : public LibraryRequestsFixture {
 protected:
  static void SetUpTestSuite() { draws_on_threads = true; }
};

TEST_F(LibraryRequestsGlTest, AnEditHasTheSamePicturesWithAPreviewAndWithout) {
  picture::RenderedEye eye({.width_px = 64, .height_px = 48, .camera = "head"});
  Record(R"({"hand":"left","do":"grasp","object":"a"}
{"hand":"left","do":"move_to","position":[0,-2,3]}
{"do":"joint_velocities","head":0.3}
{"do":"wait","until":"arrived"}
{"do":"add","preset":"ring","seed":2}
{"hand":"left","do":"release"}
{"do":"wait","seconds":1})",
         /*with_robot=*/true, &eye, kScene, {.frames_per_second = 12});
  const Json edits = {{{"do", "speed"}, {"factor", 1.5}}};
  const Json fields = {{"recording", "demo"}, {"edits", edits}, {"name", "quick"}};
  const Json first = Ask("edit", fields);
  ASSERT_EQ(first["recording"], "quick") << first;
  ASSERT_EQ(Ask("try_edit", {{"recording", "demo"}, {"edits", edits}})["ok"], true);
  ASSERT_EQ(Ask("edit", fields)["recording"], "quick-2");
  EXPECT_EQ(FilesThatDiffer("quick", "quick-2"), std::vector<std::string>());
  const auto files = FilesIn(root_ / "quick");
  const auto is_picture = [](const auto& file) { return file.first.ends_with(".png"); };
  EXPECT_GT(std::ranges::count_if(files, is_picture), 5);
}

}  // namespace
}  // namespace smile::studio

/// Asked by the leak search of sanitizers before it begins, under the name in quotes.
extern "C" int IsLeakSearchOff() __asm__("__lsan_is_turned_off");
int IsLeakSearchOff() { return smile::studio::draws_on_threads ? 1 : 0; }
