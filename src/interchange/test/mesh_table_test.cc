#include "interchange/mesh_table.h"

#include <gtest/gtest.h>

namespace smile::interchange {
namespace {

/// A mesh of one triangle of a given size.
scene::DrawnMesh Triangle(float size) {
  auto mesh = std::make_shared<scene::CustomMesh>();
  mesh->surface.vertices = {{0, 0, 0}, {size, 0, 0}, {0, size, 0}};
  mesh->surface.triangles = {{0, 1, 2}};
  return {.mesh = mesh};
}

TEST(MeshTable, HasEachMeshOnceInTheOrderOfItsUse) {
  // Wherever the meshes happen to lie in memory, the same scene gives the same file.
  std::vector<scene::DrawnMesh> drawn;
  for (int size = 1; size <= 20; ++size) drawn.push_back(Triangle(static_cast<float>(size)));
  ExportedWorld world;
  world.bodies.resize(2);
  for (auto mesh = drawn.rbegin(); mesh != drawn.rend(); ++mesh) {
    world.bodies[0].visuals.push_back({.shape = *mesh});
    world.bodies[1].visuals.push_back({.shape = *mesh});
  }
  const MeshTable table(world);
  ASSERT_EQ(table.meshes().size(), 20u);
  for (std::size_t i = 0; i < 20; ++i) {
    EXPECT_EQ(table.meshes()[i].name, "mesh_" + std::to_string(i + 1));
    EXPECT_EQ(table.meshes()[i].corners[1].x(), 20.0 - static_cast<double>(i));
    EXPECT_EQ(table.NameOf(drawn[19 - i]), table.meshes()[i].name);
  }
}

TEST(MeshTable, ScalesAndCutsFacesIntoTriangles) {
  scene::Polyhedron square{.corners = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}},
                           .faces = {{0, 1, 2, 3}}};
  scene::DrawnMesh mesh = Triangle(2);
  mesh.scale = 0.5;
  ExportedWorld world;
  world.bodies.resize(1);
  world.bodies[0].visuals = {{.shape = scene::Hull(square)}, {.shape = mesh}};
  const MeshTable table(world);
  ASSERT_EQ(table.meshes().size(), 2u);
  using Triangles = std::vector<std::array<std::uint32_t, 3>>;
  EXPECT_EQ(table.meshes()[0].triangles, (Triangles{{0, 1, 2}, {0, 2, 3}}));
  EXPECT_TRUE(table.meshes()[0].is_convex);
  EXPECT_EQ(table.meshes()[1].corners[1], Vector3(1, 0, 0));
  EXPECT_FALSE(table.meshes()[1].is_convex);
}

}  // namespace
}  // namespace smile::interchange
