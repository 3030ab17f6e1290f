#include <gtest/gtest.h>

#include "scene_xml/test/scene_text.h"

namespace smile::scene_xml {
namespace {

/// The fault of a file whose line 3 is this object.
std::string FaultOfObject(const std::string& object) { return FaultOf(SceneText(object)); }

TEST(SceneFaults, ReportsAllFaultsInOnePassInTheOrderOfTheFile) {
  EXPECT_EQ(
      FaultsOf(SceneText("<blok id='B1' location='(0,0,0)'/>\n"
                         "<block id='B2'/>\n"
                         "<block id='B3' location='(0,0,0)' mass='-1' color='rde'/>\n"
                         "stray\n"
                         "<composite location='(0,0,0)'>\n"
                         "  <sphere location='(0,0,0)' radius='0'/>\n"
                         "</composite>")),
      (std::vector<std::string>{
          "test.xml:3: <blok id=\"B1\">: found an unknown element, expected block, box, camera, "
          "cameraOffset, chain, composite, custom, customControl, cylinder, frustum, "
          "indicatorLights, lighting, ring, sliderJoint, "
          "sphere or toggleSwitch; did you mean \"block\"?",
          "test.xml:4: <block id=\"B2\">: found no location, expected location=\"(x,y,z)\"",
          "test.xml:5: <block id=\"B3\">: found color=\"rde\", expected #RRGGBB, black, blue, "
          "brown, cyan, darkgray, gray, green, lightgray, magenta, orange, pink, red, white "
          "or yellow; did you mean \"red\"?",
          "test.xml:5: <block id=\"B3\">: found mass=\"-1\", expected a number from 0 to "
          "1000000",
          "test.xml:6: <tabletop>: found text \"stray\", expected only elements",
          "test.xml:8: <sphere>: found radius=\"0\", expected a length from 0.001 to 1000000 "
          "units"}));
}

TEST(SceneFaults, SuggestsTheAttributeThatWasMeant) {
  EXPECT_EQ(FaultOfObject("<sphere location='(0,0,0)' colour='red'/>"),
            "test.xml:3: <sphere>: found attribute \"colour\", expected centerOfMass, color, "
            "friction, id, "
            "location, mass, pointable, radius, restitution, rollingFriction, rotation or "
            "rotationMatrix; did you mean \"color\"?");
}

TEST(SceneFaults, NamesTheLineWhereALongTagBegins) {
  EXPECT_EQ(FaultOfObject("<block\n  id='B'\n  location='(0,0,0)'\n  mass='heavy'\n/>"),
            "test.xml:3: <block id=\"B\">: found mass=\"heavy\", expected a number from 0 to "
            "1000000");
}

TEST(SceneFaults, NamesLinesBeyondSixtyFiveThousand) {
  EXPECT_EQ(FaultOf(SceneText(std::string(99'997, '\n') + "<block/><block location='(0,0,0)'/>")),
            "test.xml:100000: <block>: found no location, expected location=\"(x,y,z)\"");
}

TEST(SceneFaults, ReportsTheExpectedNamespace) {
  const std::string expected = ", expected xmlns=\"http://synapse.cs.umd.edu/tabletop-xml\"";
  EXPECT_EQ(FaultOf("<tabletop><block/></tabletop>"),
            "test.xml:1: <tabletop>: found no namespace" + expected);
  EXPECT_EQ(FaultOf("<tabletop xmlns='http://example.org/table'/>"),
            "test.xml:1: <tabletop>: found namespace \"http://example.org/table\"" + expected);
  EXPECT_EQ(FaultOfObject("<block xmlns='urn:x' location='(0,0,0)'/>"),
            "test.xml:3: <block>: found namespace \"urn:x\"" + expected);
}

TEST(SceneFaults, RefusesAnotherRoot) {
  EXPECT_EQ(FaultOf("<scene xmlns='http://synapse.cs.umd.edu/tabletop-xml'/>"),
            "test.xml:1: <scene>: found this element, expected <tabletop>");
}

TEST(SceneFaults, RefusesNumbersThatAreNone) {
  for (const char* number : {"", "x", "nan", "inf", "-Infinity", "1e999", "0x10", "1,5", "1 2",
                             "--1", "+-1", "1e", "1d"}) {
    EXPECT_EQ(FaultOfObject("<block location='(0,0,0)' mass='" + std::string(number) + "'/>"),
              "test.xml:3: <block>: found mass=\"" + std::string(number) +
                  "\", expected a number from 0 to 1000000");
  }
}

TEST(SceneFaults, RefusesVectorsThatAreNone) {
  for (const char* vector : {"", "0,0,0", "(0,0)", "(0,0,0,0)", "(0,0,)", "(0,0,0", "((0,0,0))",
                             "(0,0,nan)", "(0,0,2e6)", "(0;0;0)"}) {
    EXPECT_EQ(FaultOfObject("<block location='" + std::string(vector) + "'/>"),
              "test.xml:3: <block>: found location=\"" + std::string(vector) +
                  "\", expected (x,y,z), three numbers from -1000000 to 1000000");
  }
}

TEST(SceneFaults, RefusesAWrongRotation) {
  EXPECT_EQ(FaultOfObject("<block location='(0,0,0)' rotation='(0,90)'/>"),
            "test.xml:3: <block>: found rotation=\"(0,90)\", expected (a,b,c), three angles in "
            "degrees from -1000000 to 1000000");
  EXPECT_EQ(FaultOfObject("<block location='(0,0,0)' rotationMatrix='(1,0,0,0,1,0,0,0,-1)'/>"),
            "test.xml:3: <block>: found rotationMatrix=\"(1,0,0,0,1,0,0,0,-1)\", expected nine "
            "numbers in parentheses, row by row, that make a rotation");
  EXPECT_EQ(FaultOfObject("<block location='(0,0,0)' rotation='(0,0,0)'"
                          " rotationMatrix='(1,0,0,0,1,0,0,0,1)'/>"),
            "test.xml:3: <block>: found rotation=\"(0,0,0)\", expected either rotation or "
            "rotationMatrix, not both");
}

TEST(SceneFaults, RefusesOtherValuesOfTheWrongKind) {
  EXPECT_EQ(FaultOfObject("<block id='b-1' location='(0,0,0)'/>"),
            "test.xml:3: <block id=\"b-1\">: found id=\"b-1\", expected letters A-Z and a-z, "
            "digits and _, at most 100");
  EXPECT_EQ(FaultOfObject("<block location='(0,0,0)' pointable='yes'/>"),
            "test.xml:3: <block>: found pointable=\"yes\", expected true, false, 1 or 0");
  for (const char* sides : {"2", "-3", "4097", "8.5", "99999999999", ""}) {
    EXPECT_EQ(FaultOfObject("<cylinder location='(0,0,0)' sides='" + std::string(sides) + "'/>"),
              "test.xml:3: <cylinder>: found sides=\"" + std::string(sides) +
                  "\", expected a whole number from 3 to 4096");
  }
}

TEST(SceneFaults, RefusesARenamedIdThatIsInUse) {
  EXPECT_EQ(FaultOf(SceneText("<block id='a#1' location='(0,0,0)'/>\n"
                              "<block id='a#1' location='(0,0,0)'/>")),
            "test.xml:4: <block id=\"a#1\">: found id=\"a#1\", expected one that is not used yet: "
            "an id with # is never changed");
}

TEST(SceneFaults, RefusesWallsThickerThanTheirBox) {
  const std::string expected = ", expected less than half of xspan and yspan, and less than zspan";
  EXPECT_EQ(FaultOfObject("<box location='(0,0,0)' thickness='0.5'/>"),
            "test.xml:3: <box>: found thickness=\"0.5\"" + expected);
  EXPECT_EQ(FaultOfObject("<box location='(0,0,0)' zspan='0.05'/>"),
            "test.xml:3: <box>: found the default of thickness" + expected);
  EXPECT_EQ(FaultsOf(SceneText("<box location='(0,0,0)' zspan='0.01' thickness='thin'/>")).size(),
            1u)
      << "a thickness that is none is not also too thick";
}

TEST(SceneFaults, RefusesMassAndDescriptionsOfParts) {
  EXPECT_EQ(FaultsOf(SceneText("<composite location='(0,0,0)'>\n"
                               "<block location='(0,0,0)' mass='1'>\n"
                               "<description name='a' value='b'/></block></composite>")),
            (std::vector<std::string>{
                "test.xml:4: <block>: found mass=\"1\", expected mass only on the whole object",
                "test.xml:5: <description>: found a description of a part, expected it in the "
                "whole object"}));
}

TEST(SceneFaults, RefusesElementsInsideSimpleShapes) {
  EXPECT_EQ(
      FaultOfObject("<block location='(0,0,0)'><descripton/></block>"),
      "test.xml:3: <descripton>: found an unknown element, expected description or tool; did you "
      "mean \"description\"?");
  EXPECT_EQ(FaultOfObject("<composite location='(0,0,0)'><block location='(0,0,0)'><block/>"
                          "</block></composite>"),
            "test.xml:3: <block>: found an element that does not belong here, expected nothing "
            "inside this element");
}

TEST(SceneFaults, RefusesIncompleteDescriptions) {
  EXPECT_EQ(FaultsOf(SceneText("<block location='(0,0,0)'>\n<description value='v'/>\n"
                               "<description name='two words'/></block>")),
            (std::vector<std::string>{
                "test.xml:4: <description>: found no name, expected name=\"…\"",
                "test.xml:5: <description>: found name=\"two words\", expected letters A-Z and "
                "a-z, digits and _, 1 to 100",
                "test.xml:5: <description>: found no value, expected value=\"…\""}));
}

TEST(SceneFaults, RefusesAUnitOfZero) {
  EXPECT_EQ(FaultOf(SceneText("", " metersPerUnit='0'")),
            "test.xml:2: <tabletop>: found metersPerUnit=\"0\", expected a number from "
            "0.000000000001 to 1000");
}

}  // namespace
}  // namespace smile::scene_xml
