#include "experiment/content_hash.h"

#include "experiment/move_aside.h"
#include "experiment_fixture.h"

namespace smile::experiment {
namespace {

using ContentHash = ExperimentTest;

TEST_F(ContentHash, ChangesWithNamesAndContentsOfFiles) {
  Write("a/x.m", "1");
  const std::string before = ContentOf(root_ / "a");
  EXPECT_EQ(before.size(), 16u);
  EXPECT_EQ(ContentOf(root_ / "a"), before);
  Write("a/x.m", "2");
  EXPECT_NE(ContentOf(root_ / "a"), before);
  Write("b/y.m", "1");
  EXPECT_NE(ContentOf(root_ / "b"), before);
}

TEST_F(ContentHash, OfAPythonProgramIncludesItsNeighboursButNotItsCache) {
  const fs::path brain = Write("a/brain.py", "import helper\n");
  Write("a/helper.py", "1");
  const std::string before = ContentOfBrain(brain);
  Write("a/__pycache__/helper.pyc", "1");
  Write("a/notes.txt", "1");
  EXPECT_EQ(ContentOfBrain(brain), before);
  Write("a/helper.py", "2");
  EXPECT_NE(ContentOfBrain(brain), before);
  EXPECT_NE(ContentOfBrain(root_ / "a/helper.py"), ContentOfBrain(brain));
}

TEST_F(ContentHash, OfAPythonProgramIncludesThePackagesBesideIt) {
  const fs::path brain = Write("a/brain.py", "import parts.see\n");
  Write("a/parts/see.py", "1");
  const std::string without = ContentOfBrain(brain);
  Write("a/parts/__init__.py", "");
  fs::create_directory_symlink(root_ / "a/parts", root_ / "a/parts/again");
  const std::string before = ContentOfBrain(brain);
  EXPECT_NE(before, without) << "now it can be imported";
  Write("a/parts/see.py", "2");
  EXPECT_NE(ContentOfBrain(brain), before);
}

TEST_F(ContentHash, OfAFolderIgnoresCaches) {
  Write("a/brain.py", "1");
  const std::string before = ContentOf(root_ / "a");
  Write("a/brain.pyc", "1");
  EXPECT_EQ(ContentOf(root_ / "a"), before);
}

TEST_F(ContentHash, DiffersForDifferentScenes) {
  scene::SceneSpec scene = Pair();
  const std::string before = ContentOf(scene);
  EXPECT_EQ(ContentOf(Pair()), before);
  scene.objects.pop_back();
  EXPECT_NE(ContentOf(scene), before);
}

using MoveAsideTest = ExperimentTest;

TEST_F(MoveAsideTest, NumbersEarlierResults) {
  std::string message;
  const Callbacks callbacks{.on_message = [&](std::string_view text) { message = text; }};
  MoveAside(root_ / "out", callbacks);
  EXPECT_EQ(message, "");
  for (const char* text : {"first", "second"}) {
    Write("out/result", text);
    MoveAside(root_ / "out/", callbacks);
  }
  EXPECT_FALSE(Exists("out"));
  EXPECT_EQ(Read("out.1/result"), "first");
  EXPECT_EQ(Read("out.2/result"), "second");
  EXPECT_EQ(message,
            (root_ / "out").string() + ": the earlier result is now " + (root_ / "out.2").string());
}

}  // namespace
}  // namespace smile::experiment
