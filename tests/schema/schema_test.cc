#include <gtest/gtest.h>
#include <libxml/parser.h>
#include <libxml/xmlschemas.h>

#include <filesystem>
#include <memory>

#include "base/files.h"
#include "scene_xml/scene_writer.h"
#include "scene_xml/test/scene_text.h"

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

}  // namespace
}  // namespace smile::scene_xml
