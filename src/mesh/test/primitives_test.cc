#include "mesh/primitives.h"

#include <gtest/gtest.h>

#include <map>
#include <numbers>
#include <stdexcept>
#include <tuple>

namespace smile::mesh {
namespace {

const scene::VisualShape kBlock = scene::Block{{0.1, 0.2, 0.3}};
const scene::VisualShape kCylinder = scene::Cylinder{.radius = 0.05, .length = 0.3, .sides = 32};
const scene::VisualShape kPrism = scene::Cylinder{.radius = 0.05, .length = 0.3, .sides = 3};
const scene::VisualShape kSphere = scene::Sphere{0.08};

scene::VisualShape HullOf(const scene::Shape& shape) {
  return scene::VisualsOf({.shape = shape}).at(0).shape;
}
const scene::VisualShape kStump =
    HullOf(scene::Frustum{.radius_top = 0.02, .radius_bottom = 0.06, .height = 0.1, .sides = 5});
const scene::VisualShape kCone = HullOf(scene::Frustum{.radius_top = 0, .sides = 24});
const scene::VisualShape kRingPiece = HullOf(scene::Ring{.sides = 6});

class MeshOfShape : public testing::TestWithParam<scene::VisualShape> {};

INSTANTIATE_TEST_SUITE_P(Primitives, MeshOfShape,
                         testing::Values(kBlock, kCylinder, kPrism, kSphere, kStump, kCone));

/// Returns a number for each place, independent of the number of corners there.
std::vector<int> Places(const TriangleMesh& mesh) {
  std::map<std::tuple<float, float, float>, int> known;
  std::vector<int> places;
  for (const auto& p : mesh.positions) {
    const auto next = static_cast<int>(known.size());
    places.push_back(known.try_emplace({p.x(), p.y(), p.z()}, next).first->second);
  }
  return places;
}

double VolumeOf(const TriangleMesh& mesh) {
  double volume = 0;
  for (const auto& [a, b, c] : mesh.triangles) {
    volume += mesh.positions[a].cross(mesh.positions[b]).dot(mesh.positions[c]) / 6.0;
  }
  return volume;
}

TEST_P(MeshOfShape, IsAClosedSurface) {
  const TriangleMesh mesh = MeshOf(GetParam());
  const std::vector<int> places = Places(mesh);
  std::map<std::pair<int, int>, int> uses_of_edge;
  for (const auto& [a, b, c] : mesh.triangles) {
    ++uses_of_edge[{places[a], places[b]}];
    ++uses_of_edge[{places[b], places[c]}];
    ++uses_of_edge[{places[c], places[a]}];
  }
  for (const auto& [edge, uses] : uses_of_edge) {
    EXPECT_EQ(uses, 1);
    EXPECT_TRUE(uses_of_edge.contains({edge.second, edge.first}));
  }
}

TEST_P(MeshOfShape, TurnsTrianglesAndNormalsOutwards) {
  const TriangleMesh mesh = MeshOf(GetParam());
  ASSERT_EQ(mesh.normals.size(), mesh.positions.size());
  for (const auto& [a, b, c] : mesh.triangles) {
    const auto& [p, q, r] = std::tie(mesh.positions[a], mesh.positions[b], mesh.positions[c]);
    const Eigen::Vector3f across = (q - p).cross(r - p);
    EXPECT_GT(across.norm(), 0) << "a triangle without area";
    EXPECT_GT(across.dot(p + q + r), 0) << "the shapes are convex about the origin";
    for (const auto corner : {a, b, c}) {
      EXPECT_NEAR(mesh.normals[corner].norm(), 1, 1e-6);
      EXPECT_GT(mesh.normals[corner].dot(across), 0);
    }
  }
}

TEST_P(MeshOfShape, StaysWithinItsBoundingRadius) {
  for (const auto& position : MeshOf(GetParam()).positions) {
    EXPECT_LE(position.norm(), BoundingRadiusOf(GetParam()) + 1e-7);
  }
}

TEST(Primitives, ReachTheExtentsOfTheirShape) {
  for (const auto& shape : {kBlock, kCylinder, kSphere}) {
    Eigen::Vector3f most = Eigen::Vector3f::Zero();
    for (const auto& position : MeshOf(shape).positions) most = most.cwiseMax(position.cwiseAbs());
    EXPECT_TRUE(most.isApprox(0.5f * ScaleOf(shape).cast<float>(), 1e-6f));
  }
}

TEST(Primitives, HaveTheVolumeOfTheirShape) {
  using std::numbers::pi;
  EXPECT_NEAR(VolumeOf(MeshOf(kBlock)), 0.1 * 0.2 * 0.3, 1e-8);
  // A round shape's corners lie on it, so its mesh is a little smaller.
  const double cylinder = pi * 0.05 * 0.05 * 0.3, sphere = 4.0 / 3.0 * pi * 0.08 * 0.08 * 0.08;
  EXPECT_NEAR(VolumeOf(MeshOf(kCylinder)) / cylinder, 0.9936, 1e-4);
  EXPECT_NEAR(VolumeOf(MeshOf(kSphere)) / sphere, 1, 0.02);
  EXPECT_LT(VolumeOf(MeshOf(kSphere)), sphere);
  for (const auto& shape : {kStump, kCone, kRingPiece}) {
    EXPECT_NEAR(VolumeOf(MeshOf(shape)), MomentsOf(std::get<scene::Hull>(shape)).volume, 1e-9);
  }
}

TEST(Primitives, UseAsFewTrianglesAsTheShapeNeeds) {
  EXPECT_EQ(MeshOf(kBlock).triangles.size(), 12u);
  EXPECT_EQ(MeshOf(kCylinder).triangles.size(), 4u * 32u);
  EXPECT_EQ(MakeMesh({UnitMesh::Kind::kSphere, 16}).triangles.size(), 2u * 16u * 7u);
}

TEST(Primitives, SideNormalsOfACylinderPointAwayFromItsAxis) {
  const TriangleMesh mesh = MeshOf(kCylinder);
  for (std::size_t k = 0; k < 2 * 32; ++k) {
    EXPECT_EQ(mesh.normals[k].y(), 0);
    EXPECT_NEAR(mesh.normals[k].dot(mesh.positions[k]), 0.05, 1e-6);
  }
}

TEST(Primitives, ShareAUnitMeshWhenOnlyTheSizeDiffers) {
  EXPECT_EQ(UnitMeshOf(scene::Block{{1, 2, 3}}), UnitMeshOf(scene::Block{{3, 2, 1}}));
  EXPECT_NE(UnitMeshOf(kCylinder), UnitMeshOf(kPrism));
}

TEST(Primitives, ShareTheMeshOfEqualHulls) {
  const auto ring_of = [](double height) {
    return scene::VisualsOf({.shape = scene::Ring{.height = height, .sides = 8}});
  };
  const UnitMesh first = UnitMeshOf(ring_of(0.1).front().shape);
  EXPECT_EQ(UnitMeshOf(ring_of(0.1).back().shape), first) << "a ring's pieces are equal";
  EXPECT_NE(UnitMeshOf(ring_of(0.2).front().shape), first);
  EXPECT_TRUE((UnitMeshOf(ring_of(0.2).front().shape) <=> first) != 0);
}

TEST(Primitives, BoundTheFacetsOfHostileCylinders) {
  EXPECT_EQ(UnitMeshOf(scene::Cylinder{.sides = 0}).facets, 3);
  EXPECT_EQ(UnitMeshOf(scene::Cylinder{.sides = 2'000'000'000}).facets, kMaxFacets);
  EXPECT_THROW(MakeMesh({UnitMesh::Kind::kSphere, 2}), std::invalid_argument);
}

TEST(Scaled, RefusesToFlattenAMesh) {
  EXPECT_THROW(Scaled(MakeMesh({}), {1, 0, 1}), std::invalid_argument);
}

}  // namespace
}  // namespace smile::mesh
