#include "mesh/modeling.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numbers>
#include <stdexcept>

namespace smile::mesh {
namespace {

constexpr double kPi = std::numbers::pi;

double Enclosed(const scene::SurfaceMesh& surface) {
  double volume = 0;
  for (const auto& [a, b, c] : surface.triangles) {
    volume += surface.vertices[a]
                  .cast<double>()
                  .cross(surface.vertices[b].cast<double>())
                  .dot(surface.vertices[c].cast<double>()) /
              6.0;
  }
  return volume;
}

/// Returns true if each edge is used once in each direction: no holes, and all triangles face the
/// same side.
bool IsClosed(const scene::SurfaceMesh& surface) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> uses;
  for (const auto& [a, b, c] : surface.triangles) {
    ++uses[{a, b}];
    ++uses[{b, c}];
    ++uses[{c, a}];
  }
  for (const auto& [edge, count] : uses) {
    const auto back = uses.find({edge.second, edge.first});
    if (count != 1 || back == uses.end()) return false;
  }
  return !uses.empty();
}

/// Expects a closed surface with this volume [m3]: positive only if the triangles face outwards.
void ExpectSolid(const scene::SurfaceMesh& surface, double volume, double tolerance) {
  EXPECT_TRUE(IsClosed(surface));
  EXPECT_NEAR(Enclosed(surface), volume, tolerance * volume);
}

/// Returns the area of a regular polygon with its corners at `radius`.
double AreaOfPolygon(double radius, int sides) {
  return sides / 2.0 * radius * radius * std::sin(2 * kPi / sides);
}

const Outline kLetterL{{0, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 4}, {0, 4}};  // area 6

TEST(Modeling, ALatheMakesConesAndDrums) {
  ExpectSolid(Lathe({{0.5, 0}, {0, 2}}, 24), AreaOfPolygon(0.5, 24) * 2 / 3, 1e-5);
  ExpectSolid(Lathe({{0, -1}, {0.5, -1}, {0.5, 2}, {0, 2}}, 24), AreaOfPolygon(0.5, 24) * 3, 1e-5);
  ExpectSolid(Lathe({{0.5, -1}, {0.5, 2}}, 24), AreaOfPolygon(0.5, 24) * 3, 1e-5);
}

TEST(Modeling, AnExtrusionMayBeConcave) { ExpectSolid(Extrusion(kLetterL, -1, 1), 12, 1e-6); }

TEST(Modeling, RoundEdgesTakeAwayLittleAndStayWithin) {
  const scene::SurfaceMesh block = Extrusion(RoundedOutline(kLetterL, 0.3, 4), 0, 2, 0.1, 3);
  EXPECT_TRUE(IsClosed(block));
  EXPECT_LT(Enclosed(block), 12);
  EXPECT_GT(Enclosed(block), 11.5);
  for (const Eigen::Vector3f& p : block.vertices) {
    EXPECT_GE(p.minCoeff(), -1e-6f);
    EXPECT_LE(p.z(), 2 + 1e-6f);
  }
}

TEST(Modeling, ALoftPassesThroughItsCuts) {
  const scene::SurfaceMesh egg =
      Loft({{0, -1, 1, -1, 1, 2}, {1, -1, 3, -2, 2, 3}, {2, 0, 1, 0, 1, 2}}, 32);
  EXPECT_TRUE(IsClosed(egg));
  EXPECT_GT(Enclosed(egg), 0);
  Eigen::Vector3f low = egg.vertices[0], high = low;
  for (const Eigen::Vector3f& p : egg.vertices) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  EXPECT_TRUE(low.isApprox(Eigen::Vector3f(-1, -2, 0), 1e-6f)) << low;
  EXPECT_TRUE(high.isApprox(Eigen::Vector3f(3, 2, 2), 1e-6f)) << high;
}

TEST(Modeling, ASuperellipseOfAHighPowerIsARectangle) {
  const Cut cut{.x_min = 0, .x_max = 4, .y_min = -1, .y_max = 1, .exponent = 60};
  const scene::SurfaceMesh slab = Extrusion(SuperellipseOutline(cut, 64), 0, 1);
  ExpectSolid(slab, 8, 0.03);
}

TEST(Modeling, ARoundedBoxFillsItsSizeButItsCorners) {
  const scene::SurfaceMesh box = RoundedBox({2, 3, 4}, 0.2, 0.1);
  EXPECT_TRUE(IsClosed(box));
  EXPECT_LT(Enclosed(box), 24);
  EXPECT_GT(Enclosed(box), 23.4);
}

TEST(Modeling, ATubeFollowsItsPathWithoutWinding) {
  constexpr double kRadius = 0.1, kBend = 0.5;
  const scene::SurfaceMesh tube =
      Tube({{0, 0, 0}, {2, 0, 0}, {2, 3, 0}, {2, 3, 1}}, kRadius, kBend, 16);
  // Each right angle is 2 r shorter as two straight ends, and a quarter circle longer.
  const double length = 6 + 2 * (kPi / 2 - 2) * kBend;
  ExpectSolid(tube, AreaOfPolygon(kRadius, 16) * length, 0.01);
}

TEST(Modeling, AStadiumIsARectangleBetweenHalfCircles) {
  const double area = 2 * 1 + AreaOfPolygon(0.5, 64);
  ExpectSolid(Extrusion(StadiumOutline(3, 1, 64), 0, 1), area, 1e-5);
}

TEST(Modeling, PlacingAndMirroringKeepTheInsideInside) {
  const scene::SurfaceMesh letter = Extrusion(kLetterL, 0, 1);
  const RigidTransform X(Quaternion(Eigen::AngleAxisd(1, Vector3(1, 2, 3).normalized())),
                         Vector3(4, 5, 6));
  ExpectSolid(Placed(X, letter), 6, 1e-5);
  ExpectSolid(Mirrored(letter), 6, 1e-6);
  ExpectSolid(Joined({letter, Mirrored(letter)}), 12, 1e-6);
}

TEST(Modeling, AFlatPieceIsSeenFromAbove) {
  const scene::SurfaceMesh piece = FlatPiece(kLetterL, 1);
  double area = 0;
  for (const auto& [a, b, c] : piece.triangles) {
    const Eigen::Vector3f normal =
        (piece.vertices[b] - piece.vertices[a]).cross(piece.vertices[c] - piece.vertices[a]);
    EXPECT_GT(normal.z(), 0);
    area += static_cast<double>(normal.z()) / 2;
  }
  EXPECT_NEAR(area, 6, 1e-6);
}

TEST(Modeling, SectionsThatDoNotFitAreRefused) {
  const Section three = SectionAt(CircleOutline(1, 3), 0), four = SectionAt(CircleOutline(1, 4), 1);
  EXPECT_THROW(Skin({three}), std::invalid_argument);
  EXPECT_THROW(Skin({three, four}), std::invalid_argument);
}

}  // namespace
}  // namespace smile::mesh
