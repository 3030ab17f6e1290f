#include "program.h"

namespace smile {
namespace {

class Check : public ProgramTest {};

TEST_F(Check, AcceptsEveryShippedScene) {
  const Answer answer = Smile("check --json " + Shipped("scenes/*.xml"));
  EXPECT_EQ(answer.exit_code, 0) << answer.err;
  EXPECT_TRUE(answer.json()["ok"]);
  EXPECT_GT(answer.json()["objects"], 20);
}

TEST_F(Check, CountsWhatIsInAScene) {
  Write("mechanisms.xml",
        SceneOf("<sliderJoint location=\"(0,0,1)\"><block location=\"(0,0,0)\" mass=\"0\"/>"
                "<composite location=\"(0,0,0)\"><composite location=\"(0,0,0)\">"
                "<toggleSwitch location=\"(0,0,0)\"/><guestBondPoint type=\"a\" "
                "initBondHostId=\"H\" initBondTightness=\"1\"/></composite></composite>"
                "</sliderJoint>"
                "<composite location=\"(0,0,0)\"><hostBondPoint id=\"H\" type=\"a\">"
                "<tightness/></hostBondPoint></composite>"
                "<chain start=\"(0,0,1)\" end=\"(0,3,1)\"/>"));
  const Json result = Smile("check mechanisms.xml --json").json();
  EXPECT_EQ(result["objects"], 3 + 5);
  EXPECT_EQ(result["static"], 1 + 2);
  EXPECT_EQ(result["controls"], 1);
  EXPECT_EQ(result["joints"], 1 + 1 + 4);
  EXPECT_EQ(Smile("check mechanisms.xml").out,
            "mechanisms.xml: ok, 8 objects (3 fixed), 1 control, 6 joints\n");
}

TEST_F(Check, NamesEveryFaultWithItsAddress) {
  Write("bad.xml", SceneOf("<block id=\"a\" location=\"(0, 0)\"/>\n"
                           "<blok id=\"b\" location=\"(0,0,0)\"/>\n"
                           "<block id=\"c\" location=\"(0,0,0)\" mass=\"-1\"/>"));
  const Answer answer = Smile("check bad.xml --json");
  EXPECT_EQ(answer.exit_code, 1);
  const Json result = answer.json();
  EXPECT_FALSE(result["ok"]);
  ASSERT_EQ(result["diagnostics"].size(), 3u);
  for (int i = 0; i < 3; ++i) {
    EXPECT_EQ(result["diagnostics"][i]["file"], "bad.xml");
    EXPECT_EQ(result["diagnostics"][i]["line"], i + 2);
  }
  EXPECT_NE(answer.err.find("bad.xml:3: <blok id=\"b\">: "), std::string::npos) << answer.err;
}

TEST_F(Check, AMissingFileIsAnErrorWithALine) {
  const Answer answer = Smile("check nowhere.xml --json");
  EXPECT_EQ(answer.exit_code, 1);
  EXPECT_FALSE(answer.json()["ok"]);
  EXPECT_GT(answer.json()["diagnostics"][0]["line"], 0);
}

TEST_F(Check, ExpandedScenesReadBackTheSame) {
  // But for the comments, which name the file each object came from.
  const std::string without_comments = " | grep -v '<!--'";
  const Answer first = Smile("check --expand " + Shipped("scenes/shapes.xml") + without_comments);
  Write("shapes.xml", first.out);
  EXPECT_EQ(Smile("check --expand shapes.xml" + without_comments).out, first.out);
}

TEST_F(Check, FindsIncludedFilesUnderThePath) {
  Write("parts/tablesetup/pair.xml", PairOfBlocks());
  Write("main.xml", SceneOf("<include file=\"tablesetup/pair.xml\"/>"));
  EXPECT_EQ(Smile("check main.xml").exit_code, 1);
  EXPECT_EQ(Smile("check main.xml --path parts --json").json()["objects"], 2);
  EXPECT_EQ(Smile("run main.xml --path parts --seconds 0 --json").json()["objects"].size(), 2u);
}

TEST_F(Check, WrongUseIsExitCodeTwo) {
  EXPECT_EQ(Smile("").exit_code, 2);
  EXPECT_EQ(Smile("chekc x.xml").exit_code, 2);
  EXPECT_EQ(Smile("check").exit_code, 2);
  EXPECT_EQ(Smile("--help").exit_code, 0);
}

}  // namespace
}  // namespace smile
