#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "scene_xml/scene_writer.h"
#include "scene_xml/test/scene_text.h"

namespace smile::scene_xml {
namespace {

template <class Shape>
Shape MustReadShape(const std::string& element) {
  return std::get<Shape>(MustReadObject(element).whole.shape);
}

std::string FaultOfShape(const std::string& element) { return FaultOf(SceneText(element)); }

TEST(Frustum, HasTheDefaultsOfTheLanguage) {
  EXPECT_EQ(MustReadShape<scene::Frustum>("<frustum location='(0,0,0)'/>"),
            (scene::Frustum{.radius_top = 0.05, .radius_bottom = 0.05, .height = 0.1, .sides = 3}));
}

TEST(Frustum, MayEndInAPoint) {
  const std::string at = "<frustum location='(0,0,0)' ";
  EXPECT_EQ(MustReadShape<scene::Frustum>(at + "radiusTop='0' sides='4'/>"),
            (scene::Frustum{.radius_top = 0, .sides = 4}));
  EXPECT_EQ(MustReadShape<scene::Frustum>(at + "radiusBottom='-0'/>"),
            (scene::Frustum{.radius_bottom = 0}));
  EXPECT_EQ(FaultOfShape(at + "radiusTop='0' radiusBottom='0'/>"),
            "test.xml:3: <frustum>: found radiusTop=\"0\", expected radiusTop or radiusBottom "
            "above 0");
}

TEST(Ring, HasTheDefaultsOfTheLanguage) {
  EXPECT_EQ(MustReadShape<scene::Ring>("<ring location='(0,0,0)'/>"),
            (scene::Ring{.radius_outer = 0.1, .radius_inner = 0.05, .height = 0.1, .sides = 32}));
}

TEST(Ring, IsWiderOutsideThanInside) {
  const std::string at = "<ring location='(0,0,0)' ";
  const std::string expected = ", expected less than radiusOuter";
  EXPECT_EQ(FaultOfShape(at + "radiusInner='1'/>"),
            "test.xml:3: <ring>: found radiusInner=\"1\"" + expected);
  EXPECT_EQ(FaultOfShape(at + "radiusOuter='0.4'/>"),
            "test.xml:3: <ring>: found the default of radiusInner" + expected);
  EXPECT_EQ(MustReadShape<scene::Ring>(at + "radiusInner='0'/>").radius_inner, 0);
}

TEST(FrustumAndRing, AreRefusedWithNumbersOutOfRange) {
  for (const std::string name : {"frustum", "ring"}) {
    for (const std::string bad : {"sides='2'", "sides='1025'", "sides='3.5'", "zspan='0'",
                                  "zspan='nan'", "radius='1'", "thickness='1'"}) {
      const std::string attribute = bad.substr(0, bad.find('='));
      const std::string fault = FaultOfShape("<" + name + " location='(0,0,0)' " + bad + "/>");
      EXPECT_EQ(fault.find("test.xml:3: <" + name + ">: found "), 0u) << fault;
      EXPECT_NE(fault.find(attribute), std::string::npos) << fault;
    }
  }
  for (const std::string bad :
       {"radiusTop='-1'", "radiusTop='0.0001'", "radiusBottom='inf'", "radiusBottom=''"}) {
    EXPECT_NE(FaultOfShape("<frustum location='(0,0,0)' " + bad + "/>").find("a length"),
              std::string::npos);
  }
}

/// Written and read again, over all scales and units.
TEST(FrustumAndRing, RoundTripExactly) {
  std::mt19937 random(1);
  const auto uniform = [&](double least, double most) {
    return std::uniform_real_distribution<>(least, most)(random);
  };
  for (const double unit : {0.1, 1.0, 0.0254, 1e-9, 3.7}) {
    const auto length = [&] { return unit * std::exp2(uniform(-7, 9)); };
    scene::SceneSpec scene{.name = "random", .meters_per_unit = unit};
    scene.table = {20 * unit, 12 * unit, 4 * unit};
    for (int i = 0; i < 200; ++i) {
      scene::ObjectSpec object{.mass = uniform(0, 10)};
      object.whole.id = "object" + std::to_string(i);
      object.whole.X_PE = RigidTransform(Vector3(length(), -length(), 0));
      const int sides = 3 + static_cast<int>(random() % 1022);
      if (i % 2 == 0) {
        object.whole.shape = scene::Frustum{i % 8 == 0 ? 0 : length(), length(), length(), sides};
      } else {
        const double radius = length();
        object.whole.shape = scene::Ring{radius, radius * (i % 7 == 0 ? 0 : 0.6), length(), sides};
      }
      object.descriptions = {{"shape", i % 2 == 0 ? "frustum" : "ring"}};
      scene.objects.push_back(object);
    }
    const std::string text = WriteScene(scene);
    const scene::SceneSpec again = MustRead(text);
    ASSERT_EQ(again.objects.size(), scene.objects.size());
    for (std::size_t i = 0; i < scene.objects.size(); ++i) {
      EXPECT_TRUE(again.objects[i] == scene.objects[i]) << "object " << i << ", unit " << unit;
    }
    EXPECT_EQ(WriteScene(again), text);
  }
}

}  // namespace
}  // namespace smile::scene_xml
