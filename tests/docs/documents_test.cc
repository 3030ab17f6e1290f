// Runs what the documents ask a reader to type, and checks every whole scene in them. The word
// after the language of a fenced block says what else the block is:
//
//   sh             commands, which succeed; `sh fails` commands that do not
//   xml lamp.xml   a file that the reader saves under this name, in any language
//   text output    lines that the commands before it print; an ellipsis stands for anything, a
//   blank
//                  for any number of blanks

#include <map>
#include <regex>
#include <sstream>
#include <vector>

#include "program.h"

namespace smile {
namespace {

/// A fenced block of a document.
struct Block {
  std::string language;
  std::string purpose;  ///< the word after the language, often none
  std::string text;
};

/// The fenced blocks of a document, in order.
std::vector<Block> BlocksOf(const std::string& document) {
  std::vector<Block> blocks;
  std::istringstream lines(ReadFile(SMILE_SOURCE_DIR "/" + document, 1 << 22));
  bool is_inside = false;
  for (std::string line; std::getline(lines, line);) {
    if (line.rfind("```", 0) == 0) {
      is_inside = !is_inside;
      if (!is_inside) continue;
      std::istringstream words(line.substr(3));
      Block& block = blocks.emplace_back();
      words >> block.language >> block.purpose;
    } else if (is_inside) {
      blocks.back().text += line + "\n";
    }
  }
  return blocks;
}

/// Whether a block is a file that the reader saves.
bool IsFile(const Block& block) { return block.purpose.find('.') != std::string::npos; }

/// A text with one blank for several: the widths of columns depend on the names in them.
std::string Squeezed(const std::string& text) {
  return std::regex_replace(text, std::regex(" +"), " ");
}

/// Whether a printed line contains all parts of an expected one, whose ellipses stand for anything.
bool Matches(const std::string& printed, const std::string& expected) {
  static constexpr std::string_view kEllipsis = "\u2026";
  std::size_t at = 0;
  for (std::size_t begin = 0; begin <= expected.size();) {
    const std::size_t end = std::min(expected.find(kEllipsis, begin), expected.size());
    const std::string part = expected.substr(begin, end - begin);
    const std::size_t found = printed.find(part, at);
    if (found == std::string::npos) return false;
    at = found + part.size();
    begin = end + kEllipsis.size();
  }
  return true;
}

/// The first expected line that was not printed; empty if all were.
std::string FirstMissingLine(const std::string& printed, const std::string& expected) {
  std::istringstream expected_lines(Squeezed(expected));
  for (std::string wanted; std::getline(expected_lines, wanted);) {
    std::istringstream printed_lines(Squeezed(printed));
    bool is_found = false;
    for (std::string line; !is_found && std::getline(printed_lines, line);) {
      is_found = Matches(line, wanted);
    }
    if (!is_found) return wanted;
  }
  return "";
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
    // ./run by itself does the main job, which integration.Learner runs: here it does nothing. A
    // studio ends as soon as it is open.
    Write("build/page/index.html", "<html>the page</html>");
    Write("build/page/study/index.html", "<html>the page</html>");
    Write("run", "#!/bin/bash\nprogram='" SMILE_PROGRAM
                 "'\n"
                 R"(
[ $# = 0 ] && exit
case "$1 $2" in
  studio*) options=--no-open ;;
  study*.json) options= ;;
  *) exec "$program" "$@" ;;
esac
export SMILE_DATA_DIR="$PWD"
rm -f link
"$program" "$@" $options >link & studio=$!
until [ -s link ] || ! kill -0 $studio; do sleep 0.05; done
cat link
kill $studio; wait $studio
)");
    std::filesystem::permissions(directory_ / "run", std::filesystem::perms::owner_all);
  }
};

TEST_P(Documents, CommandsWork) {
  std::string printed;
  for (const Block& block : BlocksOf(GetParam())) {
    if (IsFile(block)) {
      Write(block.purpose, block.text);
    } else if (block.language == "sh") {
      // ./test would start itself; tests/package installs the Python package.
      const std::string typed = std::regex_replace(
          block.text, std::regex(R"((\./test|python3 -m venv|~/env/bin/)[^\n]*)"), "true");
      const Answer answer = Shell("set -e\n" + typed);
      EXPECT_EQ(answer.exit_code != 0, block.purpose == "fails")
          << GetParam() << ":\n"
          << block.text << answer.out << answer.err;
      printed = answer.out + answer.err;
    } else if (block.purpose == "output") {
      EXPECT_EQ(FirstMissingLine(printed, block.text), "") << GetParam() << " prints:\n" << printed;
    }
  }
}

TEST_P(Documents, ScenesAreRight) {
  for (const Block& block : BlocksOf(GetParam())) {
    if (block.language != "xml" || block.text.find("<tabletop") == std::string::npos) continue;
    Write("example.xml", block.text);
    const Answer answer = Smile("check example.xml");
    EXPECT_EQ(answer.exit_code, 0) << GetParam() << ":\n" << block.text << answer.err;
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
  const std::vector<Block> blocks = BlocksOf("docs/motion.md");
  const auto example = std::find_if(blocks.begin(), blocks.end(),
                                    [](const Block& block) { return block.language == "cpp"; });
  ASSERT_NE(example, blocks.end());
  EXPECT_EQ(example->text, ReadFile(SMILE_SOURCE_DIR "/tests/motion/example.cc", 1 << 16));
}

// A reader who leaves out the tutorial finds its brain among the examples.
TEST_F(ProgramTest, TheRobotProgramOfTheTutorialIsAnExample) {
  std::map<std::string, std::string> last_version;
  for (const Block& block : BlocksOf("docs/tutorials/robot-program.md")) {
    if (IsFile(block)) last_version[block.purpose] = block.text;
  }
  EXPECT_FALSE(last_version.empty());
  for (const auto& [file, text] : last_version) {
    EXPECT_EQ(text, ReadFile(Shipped("python/examples/" + file), 1 << 16)) << file;
  }
}

INSTANTIATE_TEST_SUITE_P(
    All, Documents,
    ::testing::Values(
        "README.md", "docs/architecture.md", "docs/brains.md", "docs/brain-protocol.md",
        "docs/commands.md", "docs/demonstrators.md", "docs/analysis.md", "docs/corrections.md",
        "docs/editing.md", "docs/experiments.md", "docs/generation.md", "docs/glossary.md",
        "docs/importing.md", "docs/learner.md", "docs/motion.md", "docs/other-simulators.md",
        "docs/python.md", "docs/performance.md", "docs/recording-format.md", "docs/results.md",
        "docs/robot.md", "docs/robots.md", "docs/scene-format.md", "docs/scenes.md",
        "docs/studies.md", "docs/studio.md", "docs/studio-protocol.md", "docs/translating.md",
        "docs/tutorials/first-demonstration.md", "docs/tutorials/robot-program.md",
        "docs/tutorials/evaluate-two-learners.md", "docs/tutorials/scene-with-a-mechanism.md"));

}  // namespace
}  // namespace smile
