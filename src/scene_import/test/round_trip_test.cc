#include <gtest/gtest.h>

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "base/files.h"
#include "base/temporary_directory.h"
#include "interchange/exported_motion.h"
#include "interchange/world_formats.h"
#include "mesh/import_mesh.h"
#include "scene/solid.h"
#include "scene_import/import_scene.h"
#include "scene_xml/mesh_files.h"
#include "scene_xml/scene_reader.h"
#include "scene_xml/scene_writer.h"

namespace smile::scene_import {
namespace {

const std::filesystem::path kScenes = std::filesystem::path(SMILE_SOURCE_DIR) / "scenes";

/// Writes a scene as another simulator's model, and imports that.
scene::SceneSpec ThereAndBack(const scene::SceneSpec& scene, const std::string& format) {
  const TemporaryDirectory folder;
  const auto model = std::make_shared<const model::Model>(scene, std::nullopt);
  const std::filesystem::path file = folder.path() / "model.xml";
  interchange::WriteScene(interchange::SceneAfter(0, model), format, file);
  return ImportScene(file, format).scene;
}

/// Writes a scene with its meshes and reads it again, as the program and its user do.
scene::SceneSpec Reread(const scene::SceneSpec& scene) {
  const TemporaryDirectory folder;
  for (const scene_xml::MeshFile& file : scene_xml::MeshFilesOf(scene)) {
    const std::filesystem::path meshes = folder.path() / scene_xml::kMeshFolder;
    MakeDirectories(meshes);
    mesh::WriteStl(file.mesh->surface, meshes / file.name);
  }
  WriteFile(folder.path() / "model.xml", scene_xml::WriteScene(scene));
  return scene_xml::LoadScene(folder.path() / "model.xml");
}

/// Expects the same mass, place and inertia, which tell what shapes there are.
void ExpectSameObject(const scene::ObjectSpec& back, const scene::ObjectSpec& object) {
  EXPECT_EQ(back.id(), object.id());
  EXPECT_NEAR(back.mass, object.mass, 1e-12) << object.id();
  const auto solids = scene::SolidsOf(back.whole), its_solids = scene::SolidsOf(object.whole);
  const auto mass = scene::MassPropertiesOf(solids, 1, back.center_of_mass);
  const auto its_mass = scene::MassPropertiesOf(its_solids, 1, object.center_of_mass);
  const RigidTransform& X = back.pose_in_world();
  const RigidTransform& its_X = object.pose_in_world();
  EXPECT_LT((X * mass.center - its_X * its_mass.center).norm(), 1e-9) << object.id();
  const Matrix3 I = X.rotation() * mass.inertia * X.rotation().transpose();
  const Matrix3 its_I = its_X.rotation() * its_mass.inertia * its_X.rotation().transpose();
  EXPECT_LT((I - its_I).norm(), 1e-6 * its_I.norm()) << object.id();
}

class RoundTrip : public ::testing::TestWithParam<std::string_view> {};

TEST_P(RoundTrip, KeepsObjectsWithPosesSizesAndMasses) {
  for (const char* name : {"tower", "box", "row", "mallet"}) {
    SCOPED_TRACE(name);
    const scene::SceneSpec scene = scene_xml::LoadScene(kScenes / (std::string(name) + ".xml"));
    const scene::SceneSpec back = ThereAndBack(scene, std::string(GetParam()));
    ASSERT_EQ(back.objects.size(), scene.objects.size());
    EXPECT_EQ(back.table.x_span, scene.table.x_span);
    EXPECT_EQ(back.table.y_span, scene.table.y_span);
    EXPECT_EQ(back.sliders.size(), scene.sliders.size());
    for (std::size_t i = 0; i < scene.objects.size(); ++i) {
      ExpectSameObject(back.objects[i], scene.objects[i]);
      if (GetParam() == "urdf") continue;  // it has no friction
      EXPECT_NEAR(back.objects[i].surface.friction, scene.objects[i].surface.friction, 1e-12);
    }
    EXPECT_EQ(Reread(back), back);
  }
}

INSTANTIATE_TEST_SUITE_P(Formats, RoundTrip, ::testing::ValuesIn(SceneFormatNames()),
                         [](const auto& format) { return std::string(format.param); });

TEST(RoundTripOfMjcf, KeepsPosesColorsSlidersAndLight) {
  scene::SceneSpec scene = scene_xml::LoadScene(kScenes / "dock.xml");
  scene.lighting = {.brightness = 0.5, .turn = 0.25};
  const scene::SceneSpec back = ThereAndBack(scene, "mjcf");
  EXPECT_NEAR(back.lighting.brightness, 0.5, 1e-6);
  EXPECT_NEAR(back.lighting.turn, 0.25, 1e-9);
  ASSERT_EQ(back.sliders.size(), 1u);
  const scene::SliderSpec& slider = back.sliders[0];
  EXPECT_NEAR(slider.max_offset - slider.min_offset,
              scene.sliders[0].max_offset - scene.sliders[0].min_offset, 1e-9);
  // The export writes no damping that stops at once.
  EXPECT_NEAR(slider.damping, scene.sliders[0].damping, 1.1e-4);
  const auto& drawer = scene.objects[scene.sliders[0].first_object + 1];
  EXPECT_EQ(back.objects[slider.first_object + 1].id(), drawer.id());
  EXPECT_LT((slider.pose_of_second().translation() - drawer.pose_in_world().translation()).norm(),
            1e-9);
  const scene::SceneSpec tower = scene_xml::LoadScene(kScenes / "tower.xml");
  const scene::SceneSpec tower_back = ThereAndBack(tower, "mjcf");
  for (std::size_t i = 0; i < tower.objects.size(); ++i) {
    EXPECT_EQ(tower_back.objects[i].whole.shape, tower.objects[i].whole.shape);
    EXPECT_EQ(tower_back.objects[i].whole.color, tower.objects[i].whole.color);
  }
}

}  // namespace
}  // namespace smile::scene_import
