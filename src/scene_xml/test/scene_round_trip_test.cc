#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <filesystem>
#include <random>

#include "base/files.h"
#include "math/angles.h"
#include "scene_xml/scene_writer.h"
#include "scene_xml/test/scene_text.h"

namespace smile::scene_xml {
namespace {

/// Written without its meshes, which are looked for where they were.
scene::SceneSpec WrittenAndRead(const scene::SceneSpec& scene) {
  SceneReading reading = ReadSceneText(WriteScene(scene, {}, MeshNames::kWhereTheyAre),
                                       scene.name + ".xml", {.search_roots = {DataFile("scenes")}});
  for (const Diagnostic& diagnostic : reading.diagnostics) ADD_FAILURE() << ToString(diagnostic);
  return reading.scene.value_or(scene::SceneSpec{});
}

/// Makes scenes of everything the language has, with numbers no file would hold.
class SceneMaker {
 public:
  explicit SceneMaker(unsigned seed) : random_(seed) {}

  scene::SceneSpec Scene() {
    // Made from a text first, so that ids and limits are those of the language.
    constexpr double kUnits[] = {0.1, 1, 0.0254, 1e-9, 3.7};
    scene::SceneSpec scene{.name = "random", .meters_per_unit = kUnits[random_() % 5]};
    unit_ = scene.meters_per_unit;
    scene.table = {Length(), Length(), 4 * unit_};
    for (int i = 0; i < 8; ++i) {
      scene::ObjectSpec object{.whole = Part(3), .mass = Uniform(0, 100)};
      object.whole.id = "object#" + std::to_string(i);
      object.descriptions = {{"shape", "thing & <\"part\">\n"}, {"size", "ü 3\t"}};
      scene.objects.push_back(object);
    }
    return scene;
  }

  double Uniform(double least, double most) {
    return std::uniform_real_distribution<>(least, most)(random_);
  }

  Matrix3 Rotation() {
    switch (random_() % 4) {
      case 0:
        return Matrix3::Identity();
      case 1:
        return FromFile({Uniform(-180, 180), Uniform(-90, 90), Uniform(-180, 180)});
      case 2:
        return FromFile({Uniform(-400, 400), random_() % 2 ? 90.0 : -89.95, 30});
      default:
        return Quaternion(Uniform(-1, 1), Uniform(-1, 1), Uniform(-1, 1), Uniform(-1, 1))
            .normalized()
            .toRotationMatrix();
    }
  }

 private:
  static Matrix3 FromFile(const Vector3& angles_deg) {
    return RotationFromFixedAxes(angles_deg).array() + 0.0;
  }

  /// Over all scales, since it is the spacing of doubles that makes this hard.
  double Length() { return unit_ * std::exp2(Uniform(-7, 9)); }
  Vector3 Size() { return {Length(), Length(), Length()}; }

  scene::Part Part(int depth) {
    scene::Part part;
    part.X_PE = {Rotation(), Vector3(Length(), -Length(), 0)};
    part.shape = Shape(depth);
    if (!std::holds_alternative<scene::Composite>(part.shape)) {
      part.color = *ParseColor(random_() % 2 ? "pink" : "#12ab9f");
    }
    return part;
  }

  scene::Shape Shape(int depth) {
    switch (random_() % (depth > 0 ? 5 : 4)) {
      case 0:
        return scene::Block{.size = Size()};
      case 1:
        return scene::Cylinder{Length(), Length(), 3 + static_cast<int>(random_() % 60)};
      case 2:
        return scene::Sphere{Length()};
      case 3: {
        const Vector3 size = Size();
        return scene::Box{size, size.minCoeff() * 0.3};
      }
      default:
        return scene::Composite{{Part(depth - 1), Part(depth - 1)}};
    }
  }

  std::mt19937 random_;
  double unit_ = 0.1;
};

TEST(SceneRoundTrip, GivesBackEveryShippedSceneAndItsText) {
  int num_scenes = 0;
  for (const auto& entry : std::filesystem::directory_iterator(DataFile("scenes"))) {
    if (entry.path().extension() != ".xml") continue;
    ++num_scenes;
    const scene::SceneSpec scene = LoadScene(entry.path());
    const scene::SceneSpec again = WrittenAndRead(scene);
    EXPECT_TRUE(again == scene) << entry.path();
    EXPECT_EQ(WriteScene(again), WriteScene(scene)) << entry.path();
    EXPECT_EQ(WriteScene(scene).find("rotationMatrix"), std::string::npos)
        << entry.path() << ": angles of a file are written as angles";
  }
  EXPECT_GE(num_scenes, 4);
}

TEST(SceneRoundTrip, GivesBackRandomScenesToTheLastBit) {
  for (unsigned seed = 0; seed < 300; ++seed) {
    const scene::SceneSpec scene = SceneMaker(seed).Scene();
    const scene::SceneSpec again = WrittenAndRead(scene);
    ASSERT_TRUE(again.objects == scene.objects) << "seed " << seed << ", written\n"
                                                << WriteScene(scene) << "and again\n"
                                                << WriteScene(again);
    EXPECT_EQ(again.meters_per_unit, scene.meters_per_unit);
    EXPECT_EQ(again.table.x_span, scene.table.x_span);
    EXPECT_EQ(again.table.y_span, scene.table.y_span);
    EXPECT_TRUE(WrittenAndRead(again) == again);
  }
}

TEST(SceneRoundTrip, KeepsTheBitsOfPosesOutOfASimulation) {
  SceneMaker maker(1);
  scene::SceneSpec scene{.name = "poses"};
  for (int i = 0; i < 2'000; ++i) {
    scene::ObjectSpec object;
    object.whole.id = "b" + std::to_string(i);
    object.whole.X_PE = {maker.Rotation(),
                         Vector3(maker.Uniform(-1, 1), maker.Uniform(0.1, 0.125), i * 1e-17)};
    object.descriptions = {{"shape", "block"}};
    scene.objects.push_back(object);
  }
  const scene::SceneSpec again = WrittenAndRead(scene);
  ASSERT_EQ(again.objects.size(), scene.objects.size());
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    const RigidTransform& before = scene.objects[i].pose_in_world();
    const RigidTransform& after = again.objects[i].pose_in_world();
    for (int k = 0; k < 3; ++k) {
      EXPECT_EQ(std::bit_cast<std::uint64_t>(after.translation()[k]),
                std::bit_cast<std::uint64_t>(before.translation()[k]));
    }
    EXPECT_EQ(after.rotation(), before.rotation());
  }
}

TEST(SceneRoundTrip, LeavesNoNegativeZeros) {
  const scene::SceneSpec scene = MustRead(SceneText(
      "<block location='(-0,0,-0.0)' rotation='(0,180,-0)'/><block location='(0,0,0)'/>"));
  for (const scene::ObjectSpec& object : scene.objects) {
    for (int i = 0; i < 9; ++i) {
      const double number = object.pose_in_world().rotation().data()[i];
      EXPECT_FALSE(number == 0 && std::signbit(number));
    }
    for (double number : object.pose_in_world().translation()) EXPECT_FALSE(std::signbit(number));
  }
}

TEST(SceneRoundTrip, KeepsRenamedIds) {
  const std::string at = " location='(0,0,0)'/>";
  const scene::SceneSpec scene = MustRead(
      SceneText("<block" + at + "<block" + at + "<composite id='a' location='(0,0,0)'>" +
                "<block id='a' pointable='true'" + at + "<block id='a'" + at + "</composite>"));
  EXPECT_EQ(scene.objects[1].id(), "obj#0");
  const scene::SceneSpec again = WrittenAndRead(scene);
  EXPECT_TRUE(again.objects == scene.objects);
}

TEST(SceneWriter, WritesAFileAPersonCanRead) {
  const scene::SceneSpec scene =
      MustRead(SceneText("<composite id='tool' location='(1.9994404,-3,0.50036395)' "
                         "rotation='(-0.04983028,-0.06965088,-15.614626)' mass='2'>"
                         "<description name='category' value='a &amp; b'/>"
                         "<sphere location='(0,0,0.3)' color='brown'/></composite>"
                         "<cylinder location='(0,0,0)' rotation='(90,0,0)'/>"));
  EXPECT_EQ(
      WriteScene(scene),
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
      "<tabletop xmlns=\"http://synapse.cs.umd.edu/tabletop-xml\" xspan=\"20\" yspan=\"12\">\n"
      "  <composite id=\"tool\" location=\"(1.9994404,-3,0.50036395)\" "
      "rotation=\"(-0.04983028,-0.06965088,-15.614626)\" mass=\"2\">\n"
      "    <description name=\"category\" value=\"a &amp; b\"/>\n"
      "    <sphere location=\"(0,0,0.3)\" rotation=\"(0,0,0)\" radius=\"0.5\" "
      "color=\"brown\"/>\n"
      "  </composite>\n"
      "  <cylinder id=\"obj\" location=\"(0,0,0)\" rotation=\"(90,0,0)\" radius=\"0.5\" "
      "yspan=\"1\" sides=\"32\" color=\"gray\" mass=\"1\"/>\n"
      "</tabletop>\n");
}

}  // namespace
}  // namespace smile::scene_xml
