#include <gtest/gtest.h>

#include <string>

#include "base/files.h"
#include "base/temporary_directory.h"
#include "mesh/import_mesh.h"
#include "scene_import/import_scene.h"

// SDFormat and URDF: models of links.

namespace smile::scene_import {
namespace {

constexpr const char* kBoxOfSdf =
    "<collision name=\"c\"><geometry><box><size>0.1 0.2 0.3</size></box></geometry></collision>";

ImportedScene OfSdf(const std::string& content) {
  return ImportSceneText("<sdf version=\"1.9\"><world name=\"w\">" + content + "</world></sdf>",
                         "sdf", "model.sdf");
}

ImportedScene OfUrdf(const std::string& content) {
  return ImportSceneText("<robot name=\"r\">" + content + "</robot>", "urdf", "model.urdf");
}

/// Returns the message with which a model is refused.
template <class Read>
std::string ReasonAgainst(const Read& read, const std::string& content) {
  try {
    (void)read(content);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(SdfImport, ResolvesFramesOfLinksAndJoints) {
  const ImportedScene imported =
      OfSdf(std::string(R"(<model name="m"><pose degrees="true">1 0 0 0 0 90</pose>
    <frame name="f" attached_to="a"><pose>0 0 0.5 0 0 0</pose></frame>
    <link name="b"><pose relative_to="f">0.1 0 0 0 0 0</pose>)") +
            kBoxOfSdf + R"(</link><link name="a"><pose>0 0 0.25 0 0 0</pose>)" + kBoxOfSdf +
            R"(</link><joint name="j" type="prismatic"><parent>a</parent><child>b</child>
    <axis><xyz expressed_in="__model__">0 1 0</xyz><limit><lower>-0.1</lower><upper>0.2</upper></limit>
    </axis></joint></model>)");
  ASSERT_EQ(imported.scene.sliders.size(), 1u);
  EXPECT_EQ(imported.scene.objects.at(0).id(), "a");
  const Vector3 p = imported.scene.objects.at(1).pose_in_world().translation();
  EXPECT_LT((p - Vector3(1, 0.1, 0.75)).norm(), 1e-12);
  scene::SliderSpec open = imported.scene.sliders[0];
  EXPECT_EQ(open.max_offset, 0.2);
  // The model's y is -x of the world.
  open.initial_offset = 0.2;
  EXPECT_LT((open.pose_of_second().translation() - Vector3(0.8, 0.1, 0.75)).norm(), 1e-12);
}

TEST(SdfImport, StaticModelsStandFastAndOthersWeighOneKilogram) {
  const ImportedScene imported =
      OfSdf("<model name=\"wall\"><static>true</static><link name=\"l\">" + std::string(kBoxOfSdf) +
            "</link></model><model name=\"toy\"><link name=\"l\">" + kBoxOfSdf + "</link></model>");
  EXPECT_EQ(imported.scene.objects.at(0).id(), "wall");
  EXPECT_TRUE(imported.scene.objects.at(0).is_static());
  EXPECT_EQ(imported.scene.objects.at(1).mass, 1);
  EXPECT_EQ(imported.scene.objects.at(1).surface.friction, 1);
}

TEST(SdfImport, RefusesCirclesAndUnknownFrames) {
  const auto with = [](const std::string& pose) {
    return "<model name=\"m\"><link name=\"a\">" + pose + kBoxOfSdf + "</link></model>";
  };
  EXPECT_NE(ReasonAgainst(OfSdf, with("<pose relative_to=\"a\">0 0 0 0 0 0</pose>"))
                .find("not relative to itself"),
            std::string::npos);
  EXPECT_NE(ReasonAgainst(OfSdf, with("<pose>0 0 0</pose>")).find("expected 6 numbers"),
            std::string::npos);
  const std::string circle =
      std::string("<model name=\"m\"><link name=\"a\">") + kBoxOfSdf + "</link><link name=\"b\">" +
      kBoxOfSdf +
      "</link><joint name=\"j\" type=\"fixed\"><parent>a</parent><child>b</child></joint>"
      "<joint name=\"k\" type=\"fixed\"><parent>b</parent><child>a</child></joint></model>";
  EXPECT_NE(ReasonAgainst(OfSdf, circle).find("found joints in a circle"), std::string::npos);
}

constexpr const char* kMug = R"(
  <material name="tin"><color rgba="0.4 0.6 0.8 1"/></material>
  <link name="mug"><inertial><mass value="0.4"/></inertial>
    <visual><geometry><cylinder radius="0.04" length="0.1"/></geometry><material name="tin"/></visual>
    <collision><geometry><cylinder radius="0.04" length="0.1"/></geometry></collision></link>
  <link name="handle"><inertial><mass value="0.1"/></inertial>
    <collision><geometry><mesh filename="package://mugs/meshes/handle.stl" scale="0.1 0.1 0.2"/></geometry></collision></link>
  <joint name="glue" type="fixed"><parent link="mug"/><child link="handle"/><origin xyz="0.05 0 0"/></joint>)";

TEST(UrdfImport, AnObjectOfTwoLinksIsOneWithItsMesh) {
  const TemporaryDirectory folder;
  MakeDirectories(folder.path() / "meshes");
  mesh::WriteStl({.vertices = {{0, 0, 0}, {0, -1, 0}, {1, 0, 0}, {0, 0, 1}},
                  .triangles = {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}}},
                 folder.path() / "meshes/handle.stl");
  const auto file = folder.path() / "mug.urdf";
  WriteFile(file, "<robot name=\"mug\">" + std::string(kMug) + "</robot>");
  const scene::SceneSpec scene = ImportScene(file, "urdf").scene;
  ASSERT_EQ(scene.objects.size(), 1u);
  EXPECT_EQ(scene.objects[0].mass, 0.5);
  EXPECT_LT((scene.objects[0].center_of_mass - Vector3(0.01, 0, 0)).norm(), 1e-12);
  const auto& parts = std::get<scene::Composite>(scene.objects[0].whole.shape).parts;
  ASSERT_EQ(parts.size(), 2u);
  EXPECT_EQ(parts[0].color, (Color{0.4, 0.6, 0.8}));
  // The mesh stands as in its file: the corners 1 m along its axes are scaled by 0.1, 0.1, 0.2.
  Vector3 most = Vector3::Zero();
  for (const auto& vertex : std::get<scene::Custom>(parts[1].shape).mesh->surface.vertices) {
    most = most.cwiseMax((parts[1].X_PE * vertex.cast<double>()).eval());
  }
  EXPECT_LT((most - Vector3(0.15, 0.1, 0.2)).norm(), 1e-6) << most;
}

TEST(UrdfImport, RefusesWhatIsNoTree) {
  EXPECT_NE(ReasonAgainst(OfUrdf, R"(<link name="a"/><link name="b"/>)").find("expected one tree"),
            std::string::npos);
  EXPECT_NE(ReasonAgainst(OfUrdf, R"(<link name="a"/><link name="b"/><link name="c"/>
      <joint name="j" type="fixed"><parent link="b"/><child link="c"/></joint>
      <joint name="k" type="fixed"><parent link="c"/><child link="b"/></joint>)")
                .find("found joints in a circle"),
            std::string::npos);
  EXPECT_NE(ReasonAgainst(OfUrdf, kMug).find("expected one in the folder of the model"),
            std::string::npos);
}

}  // namespace
}  // namespace smile::scene_import
