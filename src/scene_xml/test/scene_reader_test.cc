#include "scene_xml/scene_reader.h"

#include <gtest/gtest.h>

#include <numbers>
#include <variant>

#include "math/angles.h"
#include "scene_xml/test/scene_text.h"

namespace smile::scene_xml {
namespace {

using scene::Description;

std::vector<std::string> IdsOf(const scene::SceneSpec& scene) {
  std::vector<std::string> ids;
  for (const scene::ObjectSpec& object : scene.objects) ids.push_back(object.id());
  return ids;
}

TEST(SceneReader, NamesTheSceneAfterItsFile) {
  EXPECT_EQ(ReadSceneText(SceneText(""), "some/where/my.tower.xml").scene->name, "my.tower");
}

TEST(SceneReader, FillsInTheDefaultsOfTheTable) {
  const scene::SceneSpec scene = MustRead(SceneText(""));
  EXPECT_EQ(scene.table, (scene::TableSpec{.x_span = 2.0, .y_span = 1.2, .thickness = 0.4}));
  EXPECT_EQ(scene.meters_per_unit, 0.1);
  EXPECT_TRUE(scene.objects.empty());
}

TEST(SceneReader, HonoursTheSizeOfTheTableExactly) {
  const scene::SceneSpec scene = MustRead(SceneText("", " xspan=\"30\" yspan=\"5\""));
  EXPECT_EQ(scene.table.x_span, 3.0);
  EXPECT_EQ(scene.table.y_span, 0.5);
}

TEST(SceneReader, FillsInTheDefaultsOfABlock) {
  const scene::ObjectSpec block = MustReadObject("<block location='(1,2,3)'/>");
  EXPECT_EQ(block.id(), "obj");
  EXPECT_EQ(block.mass, 1);
  EXPECT_FALSE(block.whole.is_pointable);
  EXPECT_EQ(block.whole.color, (Color{0.5, 0.5, 0.5}));
  EXPECT_EQ(block.pose_in_world(), RigidTransform(Vector3(0.1, 0.2, 0.3)));
  EXPECT_EQ(std::get<scene::Block>(block.whole.shape).size, Vector3(0.1, 0.1, 0.1));
  EXPECT_EQ(block.descriptions, (std::vector<Description>{{"shape", "block"}}));
}

TEST(SceneReader, FillsInTheDefaultsOfTheOtherShapes) {
  EXPECT_EQ(MustReadObject("<cylinder location='(0,0,0)'/>").whole.shape,
            scene::Shape(scene::Cylinder{.radius = 0.05, .length = 0.1, .sides = 32}));
  EXPECT_EQ(MustReadObject("<sphere location='(0,0,0)'/>").whole.shape,
            scene::Shape(scene::Sphere{.radius = 0.05}));
  EXPECT_EQ(MustReadObject("<box location='(0,0,0)'/>").whole.shape,
            scene::Shape(scene::Box{.size = {0.1, 0.1, 0.1}, .thickness = 0.005}));
  EXPECT_EQ(MustReadObject("<composite location='(0,0,0)'/>").whole.shape,
            scene::Shape(scene::Composite{}));
}

TEST(SceneReader, ReadsEveryAttributeOfAShape) {
  const scene::ObjectSpec cylinder = MustReadObject(
      "<cylinder id='Can' location='(0,0,0)' color=' #Ff8000 ' radius='2' yspan='.5' sides='6'"
      " mass='0' pointable='1'/>");
  EXPECT_EQ(cylinder.id(), "Can");
  EXPECT_TRUE(cylinder.is_static());
  EXPECT_TRUE(cylinder.whole.is_pointable);
  EXPECT_EQ(cylinder.whole.color, (Color{1, 128 / 255.0, 0}));
  EXPECT_EQ(cylinder.whole.shape,
            scene::Shape(scene::Cylinder{.radius = 0.2, .length = 0.05, .sides = 6}));
}

TEST(SceneReader, AcceptsEveryUsualWayToWriteANumber) {
  const Vector3 expected(0.05, -0.025, 0.00001);
  for (const char* text : {"(.5,-.25,1.0E-4)", " ( 0.5 , -0.25 , 1e-4 ) ", "(+.5,-2.5e-1,0.0001)",
                           "(5.e-1,-0.250,\t1E-4)"}) {
    const auto block = MustReadObject("<block location='" + std::string(text) + "'/>");
    EXPECT_EQ(block.pose_in_world().translation(), expected) << text;
  }
}

TEST(SceneReader, TurnsAboutFixedAxesInDegrees) {
  const scene::ObjectSpec block =
      MustReadObject("<block location='(0,0,0)' rotation='(30,-45,60)'/>");
  using Turn = Eigen::AngleAxisd;
  const Matrix3 expected =
      (Turn(DegreesToRadians(60), Vector3::UnitZ()) *
       Turn(DegreesToRadians(-45), Vector3::UnitY()) * Turn(DegreesToRadians(30), Vector3::UnitX()))
          .toRotationMatrix();
  EXPECT_TRUE(block.pose_in_world().rotation().isApprox(expected, 1e-15));
}

TEST(SceneReader, ReadsPartsInTheFrameOfTheirComposite) {
  const scene::ObjectSpec hammer = MustReadObject(
      "<composite id='hammer' location='(0,0,1)' mass='10'>"
      "  <composite id='head' location='(-0.2,0,0)'><sphere location='(0,9,0)'/></composite>"
      "  <cylinder location='(2,0,0)' rotation='(0,0,90)' pointable='true'/>"
      "</composite>");
  EXPECT_EQ(hammer.mass, 10);
  const auto& parts = std::get<scene::Composite>(hammer.whole.shape).parts;
  ASSERT_EQ(parts.size(), 2u);
  EXPECT_EQ(parts[0].id, "head");
  EXPECT_EQ(parts[0].X_PE.translation(), Vector3(-0.02, 0, 0));
  const auto& head = std::get<scene::Composite>(parts[0].shape).parts;
  ASSERT_EQ(head.size(), 1u);
  EXPECT_EQ(head[0].id, "") << "a part that cannot be pointed at keeps its id";
  EXPECT_EQ(head[0].X_PE.translation(), Vector3(0, 0.9, 0));
  EXPECT_EQ(parts[1].id, "obj") << "a part one can point at has an id of its own";
}

TEST(SceneReader, MakesIdsUniqueWithOneCounter) {
  const std::string at = " location='(0,0,0)'/>";
  EXPECT_EQ(
      IdsOf(MustRead(SceneText("<block" + at + "<block id=''" + at + "<block id='a'" + at +
                               "<block id='a'" + at + "<block" + at + "<block id='obj'" + at))),
      (std::vector<std::string>{"obj", "obj#0", "a", "a#1", "obj#2", "obj#3"}));
}

TEST(SceneReader, ClaimsTheIdOfACompositeBeforeThoseOfItsParts) {
  const scene::SceneSpec scene =
      MustRead(SceneText("<composite id='a' location='(0,0,0)'>"
                         "  <block id='a' location='(0,0,0)' pointable='true'/>"
                         "  <block id='a' location='(0,0,0)'/>"
                         "</composite>"
                         "<block id='a' location='(0,0,0)'/>"));
  EXPECT_EQ(IdsOf(scene), (std::vector<std::string>{"a", "a#1"}));
  const auto& parts = std::get<scene::Composite>(scene.objects[0].whole.shape).parts;
  EXPECT_EQ(parts[0].id, "a#0");
  EXPECT_EQ(parts[1].id, "a");
}

TEST(SceneReader, AcceptsGeneratedIds) {
  const std::string at = " location='(0,0,0)'/>";
  EXPECT_EQ(IdsOf(MustRead(SceneText("<block id='obj#7'" + at + "<block id='obj#0'" + at +
                                     "<block" + at + "<block" + at))),
            (std::vector<std::string>{"obj#7", "obj#0", "obj", "obj#1"}));
}

TEST(SceneReader, KeepsTheLastValueOfADescriptionInItsFirstPlace) {
  const scene::ObjectSpec object = MustReadObject(
      "<composite location='(0,0,0)'>"
      "  <description name='category' value='tool'/>"
      "  <block location='(0,0,0)'/>"
      "  <description name='shape' value='a hammer, nearly'/>"
      "  <description name='weight' value=''/>"
      "  <description name='category' value='toy'/>"
      "</composite>");
  EXPECT_EQ(object.descriptions,
            (std::vector<Description>{
                {"shape", "a hammer, nearly"}, {"category", "toy"}, {"weight", ""}}));
}

TEST(SceneReader, MeasuresInTheUnitOfTheFile) {
  const scene::SceneSpec scene = MustRead(
      SceneText("<sphere location='(1,-2,0.5)' radius='0.25'/>", " metersPerUnit='10' xspan='4'"));
  EXPECT_EQ(scene.meters_per_unit, 10);
  EXPECT_EQ(scene.table, (scene::TableSpec{.x_span = 40, .y_span = 120, .thickness = 40}));
  EXPECT_EQ(scene.objects[0].pose_in_world().translation(), Vector3(10, -20, 5));
  EXPECT_EQ(std::get<scene::Sphere>(scene.objects[0].whole.shape).radius, 2.5);
}

TEST(SceneReader, ToleratesWhatToolsPutIntoAFile) {
  const scene::SceneSpec scene = MustRead(
      "\xEF\xBB\xBF<?xml version='1.0' encoding='utf-8' standalone='yes'?>\n"
      "<!-- = a <b c='d comment --><?editor fold?>\n"
      "<t:tabletop xmlns:t='http://synapse.cs.umd.edu/tabletop-xml' xml:lang='en'"
      " xmlns:xsi='http://www.w3.org/2001/XMLSchema-instance' xsi:schemaLocation='a b'>\n"
      "  <t:block id='B' location='(0,0,0)'><!-- inside --></t:block>\r\n"
      "</t:tabletop>");
  EXPECT_EQ(IdsOf(scene), (std::vector<std::string>{"B"}));
}

TEST(LoadScene, ThrowsEverythingThatIsWrong) {
  try {
    LoadScene("no/such/scene.xml");
    FAIL() << "expected an InputError";
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(), "no/such/scene.xml:1: no such file");
  }
}

}  // namespace
}  // namespace smile::scene_xml
