#include <gtest/gtest.h>
#include <libxml/parser.h>
#include <libxml/xmlschemas.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <memory>

#include "base/files.h"
#include "base/wording.h"
#include "scene_xml/scene_writer.h"
#include "scene_xml/test/scene_text.h"
#include "scene_xml/value_ranges.h"
#include "value_schema.h"

namespace smile::scene_xml {
namespace {

/// One of the schemas in scenes/schema.
class Schema {
 public:
  explicit Schema(const std::string& name) {
    const std::string path = DataFile("scenes/schema/" + name).string();
    const std::unique_ptr<xmlSchemaParserCtxt, decltype(&xmlSchemaFreeParserCtxt)> parser(
        xmlSchemaNewParserCtxt(path.c_str()), &xmlSchemaFreeParserCtxt);
    schema_.reset(xmlSchemaParse(parser.get()));
    EXPECT_NE(schema_, nullptr) << name;
  }

  bool Accepts(const std::string& xml) const {
    const std::unique_ptr<xmlDoc, decltype(&xmlFreeDoc)> document(
        xmlReadMemory(xml.data(), static_cast<int>(xml.size()), "scene.xml", nullptr,
                      XML_PARSE_NONET),
        &xmlFreeDoc);
    const std::unique_ptr<xmlSchemaValidCtxt, decltype(&xmlSchemaFreeValidCtxt)> validation(
        xmlSchemaNewValidCtxt(schema_.get()), &xmlSchemaFreeValidCtxt);
    xmlSchemaSetValidErrors(validation.get(), Ignore, Ignore, nullptr);
    return xmlSchemaValidateDoc(validation.get(), document.get()) == 0;
  }

 private:
  static void Ignore(void*, const char*, ...) {}

  std::unique_ptr<xmlSchema, decltype(&xmlSchemaFree)> schema_{nullptr, &xmlSchemaFree};
};

const std::string kPoint = " location='(0, -.5,1.0E-4)'";

TEST(Schemas, AcceptWhatTheReaderAccepts) {
  const Schema written("scene.xsd"), expanded("expanded.xsd");
  EXPECT_TRUE(written.Accepts(SceneOfEverything()));
  EXPECT_TRUE(expanded.Accepts(SceneOfEverything()));
  EXPECT_TRUE(expanded.Accepts(WriteScene(MustRead(SceneOfEverything()))));
}

TEST(Schemas, AcceptEveryShippedScene) {
  const Schema written("scene.xsd"), expanded("expanded.xsd");
  int num_scenes = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(DataFile("scenes"))) {
    if (entry.path().extension() != ".xml") continue;
    ++num_scenes;
    const std::string text = ReadFile(entry.path(), 1 << 20);
    EXPECT_TRUE(written.Accepts(text)) << entry.path();
    EXPECT_TRUE(expanded.Accepts(WriteScene(LoadScene(entry.path())))) << entry.path();
  }
  EXPECT_GE(num_scenes, 7);
}

TEST(Schemas, AcceptTemplatesOnlyInScenesAsWritten) {
  const Schema written("scene.xsd"), expanded("expanded.xsd");
  for (const std::string& content : std::vector<std::string>{
           "<include file='a.xml'/>",
           "<def name='t'><var name='x' value='1'/><state><light id='$x$'/></state></def>",
           "<sliderJoint" + kPoint + " max='$x - 1$'><instance def='both'/></sliderJoint>",
           "<block location='$p$' color='$c$' mass='$m * 2$'/>",
           "<customControl" + kPoint + "><instance def='s'/></customControl>"}) {
    EXPECT_TRUE(written.Accepts(SceneText(content))) << content;
    EXPECT_FALSE(expanded.Accepts(SceneText(content))) << content;
  }
}

TEST(Schemas, RefuseWhatTheReaderRefuses) {
  const Schema written("scene.xsd"), expanded("expanded.xsd");
  for (const std::string& content : std::vector<std::string>{
           "<blok" + kPoint + "/>",
           "<block/>",
           "<block location='(0,0)'/>",
           "<block" + kPoint + " mass='-1'/>",
           "<block" + kPoint + " mass='INF'/>",
           "<block" + kPoint + " colour='red'/>",
           "<block" + kPoint + " color='Red'/>",
           "<block" + kPoint + " xspan='0'/>",
           "<block" + kPoint + " nextStateWhenTriggered='0'/>",
           "<sphere" + kPoint + "><block" + kPoint + "/></sphere>",
           "<composite" + kPoint + "><block mass='1'" + kPoint + "/></composite>",
           "<customControl" + kPoint + "><state><toggleSwitch" + kPoint +
               "/></state></customControl>",
           "<chain start='(0,0,1)'/>",
           "<camera id='c' target='(0,0,1)'/>",
           "<guestBondPoint type='a'/>",
           "<sliderJoint" + kPoint + "/>",
           "<toggleSwitch" + kPoint + " numStates='0'/>",
       }) {
    EXPECT_FALSE(written.Accepts(SceneText(content))) << content;
    EXPECT_FALSE(expanded.Accepts(SceneText(content))) << content;
    EXPECT_FALSE(ReadSceneText(SceneText(content), "test.xml").scene.has_value()) << content;
  }
}

/// A scene in which `%` stands for a number of this range.
struct RangeInScene {
  std::string content;
  double least, most;
  double step = 1;  ///< beyond the ends, nearly nothing for what is not counted
};

template <class Number>
RangeInScene Real(const std::string& content, const Range<Number>& range) {
  return {content, static_cast<double>(range.least), static_cast<double>(range.most), 1e-6};
}

RangeInScene Whole(const std::string& content, const Range<int>& range) {
  return {content, static_cast<double>(range.least), static_cast<double>(range.most)};
}

std::vector<RangeInScene> RangesInScenes() {
  const std::string chain = "<chain start='(0,0,1)' end='(0,1,1)' ";
  std::string states, lights = "<indicatorLights numLights='256'" + kPoint + "><state>";
  for (int i = 0; i < kMaxStates; ++i) states += "<state/>";
  return {
      Real("<block" + kPoint + " mass='%'/>", kMassKilograms),
      Real("<block" + kPoint + " xspan='%'/>", kSpanUnits),
      Real("<block" + kPoint + " friction='%'/>", kFriction),
      Real("<block" + kPoint + " restitution='%'/>", kProportion),
      Real("<toggleSwitch" + kPoint + " angle='%'/>", kButtonDegrees),
      Real("<toggleSwitch" + kPoint + " pressForce='%'/>", kPressNewtons),
      Real("<toggleSwitch" + kPoint + " pressAngle='%'/>", kPressDegrees),
      Real("<camera id='c' location='(0,0,1)' target='(0,1,0)' fov='%'/>", kFieldOfViewDegrees),
      Real(chain + "linkMass='%'/>", kLinkMassKilograms),
      Real("<sliderJoint" + kPoint + " min='%' max='1e6'><block" + kPoint + "/><block" + kPoint +
               "/></sliderJoint>",
           kLocationUnits),
      Whole(chain + "linkCount='%'/>", kNumLinks),
      Whole("<cylinder" + kPoint + " sides='%'/>", kCylinderSides),
      Whole("<ring" + kPoint + " sides='%'/>", kPolygonSides),
      Whole("<toggleSwitch" + kPoint + " numStates='%'/>", kNumStates),
      Whole("<toggleSwitch" + kPoint + " numStates='256' initState='%'/>", kStates),
      Whole("<indicatorLights" + kPoint + " numLights='%'><state/></indicatorLights>", kNumLights),
      Whole(lights + "<light id='%'/></state></indicatorLights>", kLights),
      Whole("<customControl" + kPoint + "><state><block" + kPoint +
                " nextStateWhenTriggered='%'/></state>" + states.substr(8) + "</customControl>",
            kNextStates)};
}

TEST(Schemas, EndEveryRangeWhereTheReaderDoes) {
  const Schema written("scene.xsd"), expanded("expanded.xsd");
  for (const RangeInScene& range : RangesInScenes()) {
    const double below = range.least - range.step * std::max(1.0, std::abs(range.least));
    const double above = range.most + range.step * std::max(1.0, std::abs(range.most));
    for (const double value : {below, range.least, range.most, above}) {
      std::string content = range.content;
      content.replace(content.find('%'), 1, NumberText(value));
      const std::string text = SceneText(content);
      const bool is_inside = value >= range.least && value <= range.most;
      EXPECT_EQ(ReadSceneText(text, "test.xml").scene.has_value(), is_inside) << content;
      EXPECT_EQ(written.Accepts(text), is_inside) << content;
      EXPECT_EQ(expanded.Accepts(text), is_inside) << content;
    }
  }
}

TEST(Schemas, AcceptZeroButNoTinyLengthWhereTheReaderDoes) {
  const Schema written("scene.xsd"), expanded("expanded.xsd");
  for (const auto& [value, is_length] :
       {std::pair("0", true), {"0.0", true}, {"0.001", true}, {"0.0005", false}}) {
    const std::string text =
        SceneText("<block" + kPoint + " rollingFriction='" + std::string(value) + "'/>");
    EXPECT_EQ(ReadSceneText(text, "test.xml").scene.has_value(), is_length) << value;
    EXPECT_EQ(written.Accepts(text), is_length) << value;
    EXPECT_EQ(expanded.Accepts(text), is_length) << value;
  }
}

TEST(Schemas, OfValuesAreGeneratedFromTheReadersRanges) {
  for (const auto& [name, allows_expressions] :
       {std::pair("values.xsd", false), {"values_or_expressions.xsd", true}}) {
    const std::filesystem::path file =
        std::filesystem::path(SMILE_SOURCE_DIR) / "scenes/schema" / name;
    const std::string generated = ValueSchema(allows_expressions);
    if (std::getenv("SMILE_APPROVE")) WriteFile(file, generated);
    EXPECT_EQ(ReadFile(file, 1 << 20), generated)
        << "SMILE_APPROVE=1 in the environment of this test writes " << file;
  }
}

}  // namespace
}  // namespace smile::scene_xml
