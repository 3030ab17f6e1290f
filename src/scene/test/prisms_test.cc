#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "scene/solid.h"

namespace smile::scene {
namespace {

constexpr double kTolerance = 1e-12;  // [m]

const Polyhedron& PolyhedronOf(const Solid& solid) {
  return std::get<Hull>(solid.shape).polyhedron();
}

bool Contains(const std::vector<Solid>& solids, const Vector3& p_BQ) {
  return std::ranges::any_of(solids, [&](const Solid& solid) {
    const Polyhedron& polyhedron = PolyhedronOf(solid);
    const Vector3 p_SQ = solid.X_BS.inverse() * p_BQ;
    return std::ranges::all_of(polyhedron.faces, [&](const Polyhedron::Face& face) {
      return polyhedron.AreaVectorOf(face).dot(p_SQ - polyhedron.corners[face[0]]) <= kTolerance;
    });
  });
}

TEST(Solids, OfAFrustumAreOneHullWhoseFirstCornersPointToX) {
  const std::vector<Solid> solids = SolidsOf(
      {.id = "stump", .shape = Frustum{.radius_top = 0.2, .radius_bottom = 0.5, .height = 1}});
  ASSERT_EQ(solids.size(), 1u);
  EXPECT_EQ(solids[0].part_id, "stump");
  const Polyhedron& polyhedron = PolyhedronOf(solids[0]);
  ASSERT_EQ(polyhedron.corners.size(), 6u);
  EXPECT_EQ(polyhedron.corners[0], Vector3(0.5, 0, -0.5));
  EXPECT_EQ(polyhedron.corners[3], Vector3(0.2, 0, 0.5));
  EXPECT_EQ(polyhedron.faces.size(), 5u);
}

TEST(Solids, OfAFrustumWithoutATopComeToAPoint) {
  for (const Frustum& frustum : {Frustum{0, 0.5, 1, 4}, Frustum{0.5, 0, 1, 4}}) {
    const std::vector<Solid> solids = SolidsOf({.shape = frustum});
    EXPECT_EQ(PolyhedronOf(solids[0]).corners.size(), 5u);
    EXPECT_EQ(PolyhedronOf(solids[0]).faces.size(), 5u);
    // A square pyramid: base 2 r r, height 1.
    EXPECT_NEAR(MomentsOf(std::get<Hull>(solids[0].shape)).volume, 0.5 / 3, kTolerance);
  }
}

TEST(Solids, OfARingLeaveItsHoleFree) {
  for (const int sides : {3, 4, 32, 64, 65, 127, 1024}) {
    const Ring ring{.radius_outer = 0.4, .radius_inner = 0.1, .height = 0.1, .sides = sides};
    const std::vector<Solid> solids = SolidsOf({.id = "ring", .shape = ring});
    EXPECT_EQ(solids.size(), static_cast<std::size_t>(std::min(sides, 64)));
    // Within a polygon is within the circle through its corners, and holds the one in its sides.
    const double in_sides = std::cos(std::numbers::pi / std::min(sides, 32));
    for (int k = 0; k < 1000; ++k) {
      const double angle = 2 * std::numbers::pi * k / 1000;
      const auto at = [&](double radius) {
        return Vector3(radius * std::cos(angle), radius * std::sin(angle), 0.04);
      };
      EXPECT_FALSE(Contains(solids, at(0.1 * in_sides - 1e-6))) << sides << " sides, " << angle;
      EXPECT_TRUE(Contains(solids, at(0.1 + 1e-6))) << sides << " sides, " << angle;
      EXPECT_TRUE(Contains(solids, at(0.4 * in_sides - 1e-6))) << sides << " sides, " << angle;
      EXPECT_FALSE(Contains(solids, at(0.4 + 1e-6))) << sides << " sides, " << angle;
    }
  }
}

TEST(Solids, OfARingFillTheSpaceBetweenItsPolygons) {
  const int sides = 12;
  const Ring ring{.radius_outer = 0.4, .radius_inner = 0.3, .height = 0.1, .sides = sides};
  double volume = 0;
  for (const Solid& solid : SolidsOf({.shape = ring})) {
    volume += MomentsOf(std::get<Hull>(solid.shape)).volume;
  }
  const double of_unit_polygon = sides / 2.0 * std::sin(2 * std::numbers::pi / sides);
  EXPECT_NEAR(volume, of_unit_polygon * (0.4 * 0.4 - 0.3 * 0.3) * 0.1, kTolerance);
}

TEST(Solids, OfARingWithoutAHoleAreADisc) {
  const std::vector<Solid> solids = SolidsOf({.shape = Ring{.radius_inner = 0, .sides = 6}});
  ASSERT_EQ(solids.size(), 1u);
  EXPECT_TRUE(Contains(solids, Vector3::Zero()));
}

TEST(Hull, RefusesFacesThatAreNone) {
  const std::vector<Vector3> corners{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  EXPECT_THROW(Hull({corners, {{0, 1, 4}}}), std::invalid_argument);
  EXPECT_THROW(Hull({corners, {{0, 1}}}), std::invalid_argument);
  EXPECT_THROW(Hull({{{0, 0, NAN}}, {}}), std::invalid_argument);
}

}  // namespace
}  // namespace smile::scene
