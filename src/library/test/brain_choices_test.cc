#include "library/brain_choices.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <map>

#include "base/files.h"

namespace smile::library {
namespace {

namespace fs = std::filesystem;

class BrainChoicesTest : public ::testing::Test {
 protected:
  BrainChoicesTest() { fs::create_directories(root_); }
  ~BrainChoicesTest() override { fs::remove_all(root_); }

  void Write(const fs::path& file, const std::string& text = "") {
    MakeDirectories((root_ / file).parent_path());
    WriteFile(root_ / file, text);
  }
  std::vector<BrainChoice> In(const std::vector<std::string>& folders) const {
    std::vector<fs::path> paths;
    for (const std::string& folder : folders) paths.push_back(root_ / folder);
    return BrainsIn(paths);
  }
  std::vector<std::string> NamesIn(const std::vector<std::string>& folders) const {
    std::vector<std::string> names;
    for (const BrainChoice& choice : In(folders)) names.push_back(choice.name);
    return names;
  }

  fs::path root_ =
      fs::temp_directory_path() / ("smile_brain_choices_" + std::to_string(::getpid()));
};

using Names = std::vector<std::string>;

TEST_F(BrainChoicesTest, DistinguishesProgramsOfOneNameByTheirPaths) {
  Write("matlab/learner/agentBehavior.m");
  Write("python/learner/learner.py");
  Write("python/learner/parts.py");
  Write("matlab/sway/agentBehavior.m");
  EXPECT_EQ(NamesIn({"matlab", "python"}), (Names{"matlab/learner", "sway", "python/learner"}));
  EXPECT_EQ(NamesIn({"python"}), Names{"learner"});
  EXPECT_EQ(In({"python"})[0].path, root_ / "python/learner/learner.py");
  EXPECT_EQ(In({"python"})[0].kind, "python");
}

TEST_F(BrainChoicesTest, ListsAProgramOnceIfItsFolderIsNamedTwice) {
  Write("own/a.py");
  EXPECT_EQ(NamesIn({"own", "own/../own", "none"}), Names{"a.py"});
}

TEST_F(BrainChoicesTest, FindsAProgramByTheEndOfItsPath) {
  Write("own/wave.py");
  Write("shipped/wave.py");
  const std::vector<BrainChoice> choices = In({"own", "shipped"});
  EXPECT_EQ(BrainNamed(choices, "shipped/wave.py"), &choices[1]);
  EXPECT_EQ(BrainNamed(choices, "wave.py"), &choices[0]) << "the first folder's";
  EXPECT_EQ(BrainNamed(choices, "ave.py"), nullptr);
  EXPECT_EQ(BrainNamed(choices, ""), nullptr);
}

TEST_F(BrainChoicesTest, FindsTheLearnerByItsFormerName) {
  Write("matlab/learner/agentBehavior.m");
  Write("python/learner/learner.py");
  const std::vector<BrainChoice> choices = In({"matlab", "python"});
  EXPECT_EQ(BrainNamed(choices, "matlab/um"), &choices[0]);
  EXPECT_EQ(BrainNamed(choices, "python/um"), &choices[1]);
  EXPECT_EQ(BrainNamed(choices, "mine/um"), nullptr);
  EXPECT_EQ(PresentBrainPath(root_ / "matlab/um"), root_ / "matlab/learner");
  EXPECT_EQ(PresentBrainPath(root_ / "matlab/um/"), root_ / "matlab/learner");
  EXPECT_EQ(PresentBrainPath(root_ / "python/um/um.py"), root_ / "python/learner/learner.py");
  EXPECT_EQ(PresentBrainPath(root_ / "mine/um"), root_ / "mine/um");
  Write("matlab/um/agentBehavior.m");
  EXPECT_EQ(PresentBrainPath(root_ / "matlab/um"), root_ / "matlab/um") << "exists";
}

TEST_F(BrainChoicesTest, AScriptIsAnImitatorIfItsCommentDeclaresIt) {
  Write("own/comment.py", "import os\n  # smile: imitates \r\n");
  Write("own/docstring.py", "\"\"\"Learns.\n\nsmile: imitates\n\"\"\"\n");
  Write("own/octave/agentBehavior.m", "function f()\n% smile: imitates\nend\n");
  Write("own/other.py", "# This smile: imitates nothing\n# smile: imitates not\n");
  Write("own/waves/agentBehavior.m", "function f()\nend\n");
  Write("own/x_late.py", std::string(20'000, '\n') + "# smile: imitates\n");
  std::map<std::string, bool> imitates;
  for (const BrainChoice& choice : In({"own"})) imitates[choice.name] = choice.imitates;
  EXPECT_EQ(imitates, (std::map<std::string, bool>{{"comment.py", true},
                                                   {"docstring.py", true},
                                                   {"octave", true},
                                                   {"other.py", false},
                                                   {"waves", false},
                                                   {"x_late.py", false}}));
}

TEST_F(BrainChoicesTest, OfTheShippedProgramsTheLearnersImitate) {
  const std::vector<BrainChoice> choices =
      BrainsIn({DataFile("matlab"), DataFile("python"), DataFile("matlab/examples"),
                DataFile("python/examples")});
  std::map<std::string, bool> imitates;
  for (const BrainChoice& choice : choices) imitates[choice.name] = choice.imitates;
  EXPECT_EQ(std::erase_if(imitates, [](const auto& choice) { return !choice.second; }), 10u);
  EXPECT_EQ(imitates,
            (std::map<std::string, bool>{{"matlab/learner", true}, {"python/learner", true}}));
  EXPECT_EQ(choices.front().name, "matlab/learner");
}

}  // namespace
}  // namespace smile::library
