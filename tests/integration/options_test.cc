// Options that may be repeated, before and after the positional arguments.

#include "program.h"

namespace smile {
namespace {

class Options : public ProgramTest {
 protected:
  Options() {
    Write("pair.xml", PairOfBlocks());
    Write("here/blocks.xml", SceneOf("<block id=\"a\" color=\"red\" location=\"(0, -3, 0.5)\"/>"));
    Write("there/more.xml", "");
    Write("scene.xml", SceneOf("<include file=\"blocks.xml\"/>\n"
                               "<block id=\"b\" color=\"blue\" location=\"(2, -3, 0.5)\"/>"));
  }
};

TEST_F(Options, ARepeatableOptionTakesOneValueEachTime) {
  for (const char* command :
       {"run --path here scene.xml --seconds 0 --json", "check --path here scene.xml",
        "check --path there --path here scene.xml", "check scene.xml --path there --path here",
        "render --size 16x12 --no-robot --out picture.png --path here scene.xml",
        "layout --seed 1 --out laid.xml --path here scene.xml"}) {
    const Answer answer = Smile(command);
    EXPECT_EQ(answer.exit_code, 0) << command << ": " << answer.err;
  }
}

TEST_F(Options, ARepeatableOptionLeavesDemonstrationAndSceneAlone) {
  Write("stack.jsonl", StackPair());
  ASSERT_EQ(Smile("run pair.xml --commands stack.jsonl --record demo --no-pictures").exit_code, 0);
  // They get as far as the brain, which is missing.
  for (const char* command :
       {"imitate --brain nowhere --out out --path here demo scene.xml",
        "evaluate --scene pair.xml --out ev --brain nowhere demo",
        "evaluate --scene pair.xml --out ev --brain nowhere --demonstrators ghost,forearm demo"}) {
    const Answer answer = Smile(command);
    EXPECT_EQ(answer.exit_code, 1) << command;
    EXPECT_NE(answer.err.find("nowhere"), std::string::npos) << answer.err;
  }
}

TEST_F(Options, EarlierNamesWorkAndHelpDoesNotListThem) {
  for (const std::string option : {"--timeout", "--patience"}) {
    const Answer answer = Smile("run pair.xml --brain nowhere " + option + " 2");
    EXPECT_EQ(answer.exit_code, 1) << answer.err;
    EXPECT_NE(answer.err.find("nowhere: no such brain"), std::string::npos) << answer.err;
  }
  for (const char* command : {"--help", "--help-all", "run --help", "evaluate --help"}) {
    const std::string help = Smile(command).out;
    EXPECT_EQ(help.find("patience"), std::string::npos) << help;
    EXPECT_EQ(help.find("\ndress"), std::string::npos) << help;
    EXPECT_EQ(help.find("  dress"), std::string::npos) << help;
  }
}

TEST_F(Options, ABlankTitleIsRefused) {
  const Answer answer = Smile("run pair.xml --seconds 0 --record demo --title '  '");
  EXPECT_EQ(answer.exit_code, 2);
  EXPECT_EQ(answer.err, "smile: recording: title is blank, expected text or no title\n");
  EXPECT_FALSE(Exists("demo"));
  EXPECT_EQ(Smile("import nothing --out demo --title ' '").exit_code, 2);
}

}  // namespace
}  // namespace smile
