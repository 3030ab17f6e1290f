#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <string>

#include "base/files.h"
#include "base/temporary_directory.h"
#include "interchange/exported_motion.h"
#include "scene_import/import_scene.h"

namespace smile::scene_import {
namespace {

ImportedScene OfWorldBody(const std::string& content, const std::string& before = "") {
  return ImportSceneText(
      "<mujoco>" + before + "\n<worldbody>\n" + content + "\n</worldbody></mujoco>", "mjcf",
      "model.xml");
}

/// Returns the message with which a model is refused.
std::string RefusalOf(const std::string& content, const std::string& before = "") {
  try {
    (void)OfWorldBody(content, before);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

bool Says(const ImportedScene& imported, const std::string& words) {
  return std::ranges::any_of(imported.remarks, [&words](const Diagnostic& remark) {
    return ToString(remark).find(words) != std::string::npos;
  });
}

std::string RemarksOf(const ImportedScene& imported) {
  std::string text;
  for (const Diagnostic& remark : imported.remarks) text += ToString(remark) + "\n";
  return text;
}

constexpr const char* kTower = R"(
  <geom name="ground" type="plane" size="0 0 0.1"/>
  <body name="table" pos="0.5 0 0.4">
    <geom name="table_top" type="box" size="0.4 0.3 0.02" rgba="0.6 0.4 0.2 1"/>
    <geom name="leg" type="cylinder" size="0.02 0.19" pos="0.3 0.2 -0.21"/>
  </body>
  <body name="low" pos="0.5 0 0.445"><freejoint/><geom type="box" size="0.025 0.025 0.025" mass="0.2"/></body>
  <body name="mid" pos="0.5 0 0.495"><freejoint/><geom class="red" type="box" size="0.025 0.025 0.025"/></body>
  <body name="top" pos="0.5 0.001 0.535"><freejoint/><geom type="cylinder" size="0.02 0.015" mass="0.1"/></body>)";
constexpr const char* kRed =
    R"(<default><geom density="500"/><default class="red"><geom rgba="1 0 0 1"/></default></default>)";

TEST(MjcfImport, ATowerStandsForTenSeconds) {
  const ImportedScene imported = OfWorldBody(kTower, kRed);
  ASSERT_EQ(imported.scene.objects.size(), 3u) << RemarksOf(imported);
  EXPECT_EQ(imported.scene.table.x_span, 0.8);
  EXPECT_EQ(imported.scene.objects[1].whole.color, (Color{1, 0, 0}));
  EXPECT_NEAR(imported.scene.objects[1].mass, 500 * 0.05 * 0.05 * 0.05, 1e-12);
  const auto after = interchange::SceneAfter(
      10, std::make_shared<const model::Model>(imported.scene, std::nullopt));
  for (const scene::ObjectSpec& object : imported.scene.objects) {
    const auto body =
        std::ranges::find(after.world.bodies, object.id(), &interchange::ExportedBody::name);
    ASSERT_NE(body, after.world.bodies.end());
    const Vector3 moved = body->spec.X_WB.translation() - object.pose_in_world().translation();
    EXPECT_LT(moved.norm(), 0.002) << object.id();
  }
}

TEST(MjcfImport, TheTopOfTheTableBecomesTheOrigin) {
  const ImportedScene imported = OfWorldBody(kTower, kRed);
  const Vector3 low = imported.scene.objects[0].pose_in_world().translation();
  EXPECT_LT((low - Vector3(0, 0, 0.025)).norm(), 1e-12);
  EXPECT_TRUE(Says(imported, "where SMILE has its own table and floor (also in line 7)"))
      << RemarksOf(imported);
  EXPECT_TRUE(
      Says(imported,
           R"(<geom name="table_top">: changed: the center of this table's top, (0.5, 0, 0.42) m)"))
      << RemarksOf(imported);
  EXPECT_TRUE(Says(imported, R"(<geom name="ground">: left out: it lies below)"))
      << RemarksOf(imported);
}

TEST(MjcfImport, NestedBodiesAreOneObjectAndSlidesAreSliders) {
  const ImportedScene imported = OfWorldBody(R"(
    <body name="chest" pos="0 0 0.1"><freejoint/><geom type="box" size="0.1 0.1 0.01" mass="2"/>
      <body name="knob" pos="0 0 0.03"><geom size="0.02" mass="1"/></body>
      <body name="drawer" pos="0 -0.05 0.05"><joint type="slide" axis="0 -2 0" range="-0.05 0.1" damping="1"/>
        <geom type="box" size="0.05 0.05 0.01" mass="0.5"/></body>
      <body name="door" pos="0 0.2 0"><joint name="h" type="hinge"/><geom type="box" size="0.05 0.05 0.01" mass="1"/></body>
    </body>)");
  ASSERT_EQ(imported.scene.objects.size(), 2u) << RemarksOf(imported);
  const scene::ObjectSpec& chest = imported.scene.objects[0];
  EXPECT_EQ(std::get<scene::Composite>(chest.whole.shape).parts.size(), 3u);
  EXPECT_EQ(chest.mass, 4);
  EXPECT_LT((chest.center_of_mass - Vector3(0, 0.05, 0.0075)).norm(), 1e-12);
  ASSERT_EQ(imported.scene.sliders.size(), 1u);
  const scene::SliderSpec& slider = imported.scene.sliders[0];
  EXPECT_EQ(slider.min_offset, -0.05);
  EXPECT_EQ(slider.max_offset, 0.1);
  EXPECT_NEAR(slider.damping, 1 - std::exp(-2.0), 1e-12);
  // An offset of 0.1 m moves the drawer by that along the axis, which points to -y.
  scene::SliderSpec open = slider;
  open.initial_offset = 0.1;
  EXPECT_LT((open.pose_of_second().translation() - Vector3(0, -0.15, 0.15)).norm(), 1e-12);
  EXPECT_TRUE(Says(imported, R"(<joint name="h">: changed: SMILE has no joint like this hinge)"))
      << RemarksOf(imported);
}

TEST(MjcfImport, UnderstandsAllWaysToWriteAPose) {
  const std::string head = R"(<compiler angle="degree" eulerseq="XYZ"/>)";
  const double half = std::numbers::sqrt2 / 2;
  for (const std::string turn : {R"(euler="90 0 90")", R"(quat="0.5 0.5 0.5 0.5")",
                                 R"(axisangle="1 1 1 120")", R"(xyaxes="0 2 0 0 1 3")"}) {
    const ImportedScene imported = OfWorldBody(
        "<body><freejoint/><geom type=\"box\" size=\"0.1 0.2 0.3\"/></body>"
        "<body name=\"b\" " +
            turn +
            "><freejoint/>"
            "<geom type=\"box\" size=\"0.1 0.2 0.3\"/></body>",
        head);
    const Matrix3 R = imported.scene.objects.at(1).pose_in_world().rotation();
    EXPECT_LT((R * Vector3::UnitX() - Vector3::UnitY()).norm(), 1e-12) << turn;
    EXPECT_LT((R * Vector3::UnitY() - Vector3::UnitZ()).norm(), 1e-12) << turn;
  }
  const ImportedScene rod = OfWorldBody(
      R"(<body><freejoint/><geom type="cylinder" size="0.01" fromto="0 0 1 1 0 0"/></body>)");
  const scene::ObjectSpec& object = rod.scene.objects.at(0);
  EXPECT_NEAR(std::get<scene::Cylinder>(object.whole.shape).length, std::numbers::sqrt2, 1e-12);
  const Vector3 axis = object.pose_in_world().rotation().col(1);
  EXPECT_NEAR(std::abs(axis.dot(Vector3(half, 0, -half))), 1, 1e-12);
}

TEST(MjcfImport, RefusesHostileModelsWithTheirPlace) {
  const auto box = [](const std::string& attributes) {
    return "<body><freejoint/><geom type=\"box\" " + attributes + "/></body>";
  };
  EXPECT_NE(RefusalOf(box(R"(size="0.1 nan 1")")).find("model.xml:3: <geom>: found size="),
            std::string::npos);
  EXPECT_NE(RefusalOf(box(R"(size="0.1 0 1")")).find("found a length of 0 m"), std::string::npos);
  EXPECT_NE(RefusalOf(box(R"(size="1 1 1" mass="-1")")).find("found a mass of -1 kg"),
            std::string::npos);
  EXPECT_NE(RefusalOf(box(R"(size="1 1 1" class="no")")).find("found the class"),
            std::string::npos);
  EXPECT_NE(RefusalOf(R"(<body pos="1e7 0 0"/>)").find("found a position beyond"),
            std::string::npos);
  EXPECT_NE(RefusalOf(R"(<body quat="0 0 0 0"/>)").find("rotation of length 0"), std::string::npos);
  EXPECT_NE(RefusalOf("<include file=\"/etc/passwd\"/>").find("expected one in the folder"),
            std::string::npos);
  EXPECT_NE(RefusalOf(R"(<body><freejoint/><geom type="mesh" mesh="m"/></body>)",
                      R"(<asset><mesh name="m" file="../../x.stl"/></asset>)")
                .find("expected one in the folder of the model"),
            std::string::npos);
}

TEST(MjcfImport, IncludesFilesOfItsFolderOnce) {
  const TemporaryDirectory folder;
  WriteFile(
      folder.path() / "part.xml",
      R"(<mujocoinclude><body name="b"><freejoint/><geom size="0.1"/></body></mujocoinclude>)");
  WriteFile(folder.path() / "circle.xml", R"(<mujoco><include file="circle.xml"/></mujoco>)");
  const auto file = folder.path() / "model.xml";
  WriteFile(file, R"(<mujoco><worldbody><include file="part.xml"/></worldbody></mujoco>)");
  EXPECT_EQ(ImportScene(file, "mjcf").scene.objects.at(0).id(), "b");
  WriteFile(file, R"(<mujoco><include file="circle.xml"/></mujoco>)");
  EXPECT_THROW((void)ImportScene(file, "mjcf"), InputError);
}

}  // namespace
}  // namespace smile::scene_import
