// What the documents tell a reader to type is typed here: every ```sh block is run, every whole
// scene in an ```xml block is checked.

#include <regex>
#include <sstream>
#include <vector>

#include "program.h"

namespace smile {
namespace {

/// The fenced blocks of a document in this language.
std::vector<std::string> BlocksOf(const std::string& document, const std::string& language) {
  std::vector<std::string> blocks;
  std::istringstream lines(ReadFile(std::string(SMILE_SOURCE_DIR) + "/" + document, 1 << 22));
  bool is_inside = false, is_wanted = false;
  for (std::string line; std::getline(lines, line);) {
    if (line.rfind("```", 0) == 0) {
      is_inside = !is_inside;
      is_wanted = is_inside && line == "```" + language;
      if (is_wanted) blocks.emplace_back();
    } else if (is_wanted) {
      blocks.back() += line + "\n";
    }
  }
  return blocks;
}

class Documents : public ProgramTest, public ::testing::WithParamInterface<const char*> {
 protected:
  /// A directory that looks like the project's root, with a ./run that does not build.
  Documents() {
    for (const char* name : {"scenes", "examples", "matlab", "python", "robots", "docs"}) {
      std::filesystem::create_symlink(Shipped(name), directory_ / name);
    }
    std::filesystem::create_directories(directory_ / "build");
    std::filesystem::create_symlink(SMILE_BUILD_DIR, directory_ / "build/release");
    // The main job has a test of its own; here a shorter task stands for it.
    Write("run",
          "#!/bin/bash\n[ $# = 0 ] && set -- experiment tower --no-films --out out/um\nexec "
          "\"" SMILE_PROGRAM "\" \"$@\"\n");
    std::filesystem::permissions(directory_ / "run", std::filesystem::perms::owner_all);
  }
};

TEST_P(Documents, CommandsWork) {
  for (const std::string& block : BlocksOf(GetParam(), "sh")) {
    // ./test would start itself.
    const std::string typed = std::regex_replace(block, std::regex(R"(\./test[^\n]*)"), "true");
    const Answer answer = Shell("set -e\n" + typed);
    EXPECT_EQ(answer.exit_code, 0) << GetParam() << ":\n" << block << answer.out << answer.err;
  }
}

TEST_P(Documents, ScenesAreRight) {
  for (const std::string& block : BlocksOf(GetParam(), "xml")) {
    if (block.find("<tabletop") == std::string::npos) continue;
    Write("example.xml", block);
    const Answer answer = Smile("check example.xml");
    EXPECT_EQ(answer.exit_code, 0) << GetParam() << ":\n" << block << answer.err;
  }
}

// What tools/generate.py writes is what the program says.
TEST_F(ProgramTest, TablesInTheDocumentsAreTheProgramsOwn) {
  const std::vector<std::pair<std::string, std::string>> tables = {
      {"commands.md", "commands --markdown"},
      {"studio-protocol.md", "protocol"},
      {"studio-protocol.md", "protocol --news"}};
  for (const auto& [document, arguments] : tables) {
    const std::string text = ReadFile(SMILE_SOURCE_DIR "/docs/" + document, 1 << 20);
    const std::string table = Smile(arguments).out;
    EXPECT_NE(table, "");
    EXPECT_NE(text.find("<!-- smile " + arguments + " -->\n\n" + table + "\n<!-- -->"),
              std::string::npos)
        << document << ": run tools/generate.py";
  }
}

TEST_F(ProgramTest, ThePagesTypesAreTheProgramsOwn) {
  for (const auto& [file, arguments] : {std::pair("commands.ts", "commands --typescript"),
                                        std::pair("messages.ts", "protocol --typescript")}) {
    EXPECT_EQ(ReadFile(std::string(SMILE_SOURCE_DIR "/web/src/") + file, 1 << 20),
              Smile(arguments).out)
        << "run tools/generate.py";
  }
}

TEST_F(ProgramTest, TheCppExampleOfMotionIsCompiled) {
  EXPECT_EQ(BlocksOf("docs/motion.md", "cpp").front(),
            ReadFile(SMILE_SOURCE_DIR "/tests/motion/example.cc", 1 << 16));
}

INSTANTIATE_TEST_SUITE_P(All, Documents,
                         ::testing::Values("README.md", "docs/architecture.md", "docs/brains.md",
                                           "docs/brain-protocol.md", "docs/commands.md",
                                           "docs/demonstrators.md", "docs/editing.md",
                                           "docs/experiments.md", "docs/glossary.md",
                                           "docs/importing.md", "docs/learner.md", "docs/motion.md",
                                           "docs/recording-format.md", "docs/results.md",
                                           "docs/robot.md", "docs/scene-format.md",
                                           "docs/scenes.md", "docs/studio.md",
                                           "docs/studio-protocol.md"));

}  // namespace
}  // namespace smile
