#include "mesh/convex_pieces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <stdexcept>

#include "mesh/import_mesh.h"
#include "mesh/primitives.h"
#include "mesh/test/mesh_files.h"

namespace smile::mesh {
namespace {

bool Contains(const scene::Hull& hull, const Vector3& point) {
  const scene::Polyhedron& p = hull.polyhedron();
  return std::ranges::all_of(p.faces, [&](const scene::Polyhedron::Face& face) {
    return p.AreaVectorOf(face).dot(point - p.corners[face[0]]) < 0;
  });
}

bool Contain(const std::vector<scene::Hull>& pieces, const Vector3& point) {
  return std::ranges::any_of(pieces,
                             [&](const scene::Hull& piece) { return Contains(piece, point); });
}

/// Expects a closed hull with convex faces outwards, as mass properties and rendering require.
void ExpectValid(const std::vector<scene::Hull>& pieces) {
  EXPECT_LE(pieces.size(), 64u);
  for (const scene::Hull& piece : pieces) {
    const scene::Polyhedron& p = piece.polyhedron();
    EXPECT_LE(p.corners.size(), 128u);
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
    for (const scene::Polyhedron::Face& face : p.faces) {
      const Vector3 normal = p.AreaVectorOf(face).normalized();
      EXPECT_TRUE(normal.allFinite());
      for (const Vector3& corner : p.corners) {
        EXPECT_LT(normal.dot(corner - p.corners[face[0]]), 1e-4);
      }
      for (std::size_t k = 0; k < face.size(); ++k) {
        ++edges[{face[k], face[(k + 1) % face.size()]}];
      }
    }
    for (const auto& [edge, uses] : edges) {
      EXPECT_EQ(uses, 1);
      EXPECT_TRUE(edges.contains({edge.second, edge.first}));
    }
  }
}

/// Returns a torus of n times m quadrilaterals, rotated off the axes.
scene::SurfaceMesh Torus(std::uint32_t n, std::uint32_t m) {
  using std::numbers::pi;
  const Eigen::Matrix3d R = Eigen::AngleAxisd(0.5, Vector3(1, 2, 3).normalized()).matrix();
  scene::SurfaceMesh mesh;
  for (std::uint32_t i = 0; i < n; ++i) {
    for (std::uint32_t j = 0; j < m; ++j) {
      const double a = 2 * pi * i / n, b = 2 * pi * j / m, r = 1 + 0.3 * std::cos(b);
      mesh.vertices.push_back(
          (R * Vector3(r * std::cos(a), r * std::sin(a), 0.3 * std::sin(b))).cast<float>());
      const std::uint32_t next_i = (i + 1) % n * m, next_j = (j + 1) % m;
      mesh.triangles.push_back({i * m + j, next_i + j, next_i + next_j});
      mesh.triangles.push_back({i * m + j, next_i + next_j, i * m + next_j});
    }
  }
  return mesh;
}

TEST(ConvexPieces, MakesAConvexMeshOneExactHull) {
  const Eigen::Vector3f low(-0.1f, 0.2f, 0.3f), high(0.7f, 0.9f, 1.1f);
  const std::vector<scene::Hull> pieces = ConvexPieces(Cuboid(low, high));
  ASSERT_EQ(pieces.size(), 1u);
  const scene::Polyhedron& p = pieces[0].polyhedron();
  EXPECT_EQ(p.corners.size(), 8u);
  EXPECT_EQ(p.faces.size(), 6u) << "two triangles of a side are one face";
  for (const Vector3& corner : p.corners) {
    for (int i = 0; i < 3; ++i) {
      EXPECT_TRUE(corner[i] == double{low[i]} || corner[i] == double{high[i]});
    }
  }
  ExpectValid(pieces);
}

TEST(ConvexPieces, MakesABallOneHullOfAFewCorners) {
  const TriangleMesh round = MakeMesh({.kind = UnitMesh::Kind::kSphere, .facets = 60});
  const std::vector<scene::Hull> pieces = ConvexPieces({round.positions, round.triangles});
  EXPECT_EQ(pieces.size(), 1u);
  ExpectValid(pieces);
}

TEST(ConvexPieces, CutsABracketWhereItsFacesAre) {
  const std::vector<scene::Hull> pieces =
      ConvexPieces(ImportMesh(DataFile("scenes/meshes/bracket.obj")));
  ASSERT_EQ(pieces.size(), 2u);
  double volume = 0;
  for (const scene::Hull& piece : pieces) {
    EXPECT_EQ(piece.polyhedron().corners.size(), 8u);
    volume += MomentsOf(piece).volume;
  }
  EXPECT_NEAR(volume, 0.264, 1e-7);
  ExpectValid(pieces);
}

TEST(ConvexPieces, LeavesACupHollow) {
  const std::vector<scene::Hull> pieces =
      ConvexPieces(ImportMesh(DataFile("scenes/meshes/cup.stl")));
  ExpectValid(pieces);
  EXPECT_GT(pieces.size(), 8u);
  for (int k = 0; k < 16; ++k) {
    const double angle = 2 * std::numbers::pi * (k + 0.3) / 16;
    const Vector3 out(std::cos(angle), std::sin(angle), 0);
    for (const double z : {-0.4, 0.0, 0.5}) {
      const double inner = 0.45 + 0.07 * (z - 0.05) / 0.55, outer = inner + 0.075;
      EXPECT_FALSE(Contain(pieces, 0.9 * inner * out + Vector3(0, 0, z))) << k << " " << z;
      EXPECT_TRUE(Contain(pieces, (inner + outer) / 2 * out + Vector3(0, 0, z))) << k << " " << z;
    }
    EXPECT_TRUE(Contain(pieces, 0.3 * out + Vector3(0, 0, -0.55))) << "the floor";
  }
}

TEST(ConvexPieces, LeavesTheHoleOfARingInAnyPosition) {
  const scene::SurfaceMesh torus = Torus(48, 16);
  const std::vector<scene::Hull> pieces = ConvexPieces(torus);
  ExpectValid(pieces);
  EXPECT_FALSE(Contain(pieces, Vector3::Zero()));
  double volume = 0;
  for (const scene::Hull& piece : pieces) volume += MomentsOf(piece).volume;
  EXPECT_NEAR(volume, 2 * std::numbers::pi * std::numbers::pi * 0.09, 0.06);
  // The same mesh gives the same bits.
  EXPECT_TRUE(ConvexPieces(Torus(48, 16)) == pieces);
}

TEST(ConvexPieces, DoNotDependOnWhichSideIsOutside) {
  scene::SurfaceMesh torus = Torus(24, 8);
  const auto pieces = ConvexPieces(torus);
  for (auto& triangle : torus.triangles) std::swap(triangle[1], triangle[2]);
  EXPECT_EQ(ConvexPieces(torus).size(), pieces.size());
  ExpectValid(ConvexPieces(torus));
}

TEST(ConvexPieces, MakesAnOpenSurfaceItsHullAndRefusesAFlatOne) {
  scene::SurfaceMesh open = Cuboid({0, 0, 0}, {1, 1, 1});
  open.triangles.resize(10);
  const auto pieces = ConvexPieces(open);
  ASSERT_EQ(pieces.size(), 1u);
  EXPECT_NEAR(MomentsOf(pieces[0]).volume, 1, 1e-12);

  const scene::SurfaceMesh flat = Cuboid({0, 0, 0}, {1, 1, 0});
  const auto message = [](const scene::SurfaceMesh& mesh, const PieceLimits& limits) {
    try {
      ConvexPieces(mesh, limits);
    } catch (const std::invalid_argument& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_EQ(message(flat, {}), "found all triangles in a plane, expected a body with a volume");
  EXPECT_EQ(message(flat, {.max_triangles = 11}),
            "found 12 triangles, expected at most 11 to make convex pieces of");
}

TEST(ConvexPieces, KeepsToTheNumberOfPieces) {
  const auto pieces = ConvexPieces(Torus(48, 16), {.max_pieces = 6, .max_corners = 20});
  EXPECT_LE(pieces.size(), 6u);
  for (const scene::Hull& piece : pieces) EXPECT_LE(piece.polyhedron().corners.size(), 20u);
}

}  // namespace
}  // namespace smile::mesh
