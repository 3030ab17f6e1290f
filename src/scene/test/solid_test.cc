#include "scene/solid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "base/overloaded.h"
#include "math/angles.h"

namespace smile::scene {
namespace {

constexpr double kLengthTolerance = 1e-15;  // [m]

const Vector3& SizeOf(const Solid& solid) { return std::get<Block>(solid.shape).size; }

TEST(Solids, OfAContainerAreItsFloorAndFourWalls) {
  const Part tray{.id = "tray", .color = {1, 0, 0}, .shape = Box{{0.4, 0.3, 0.15}, 0.02}};
  const std::vector<Solid> solids = SolidsOf(tray);
  struct Wall {
    Vector3 size, center;
  };
  // Floor, left, right, near and far wall for size X, Y, Z = 0.4, 0.3, 0.15 and thickness t = 0.02.
  const std::vector<Wall> expected{
      {{0.4, 0.3, 0.02}, {0, 0, -0.065}},    {{0.02, 0.26, 0.13}, {-0.19, 0, 0.01}},
      {{0.02, 0.26, 0.13}, {0.19, 0, 0.01}}, {{0.4, 0.02, 0.13}, {0, 0.14, 0.01}},
      {{0.4, 0.02, 0.13}, {0, -0.14, 0.01}},
  };
  ASSERT_EQ(solids.size(), expected.size());
  for (std::size_t i = 0; i < solids.size(); ++i) {
    EXPECT_EQ(solids[i].part_id, "tray");
    EXPECT_LT((SizeOf(solids[i]) - expected[i].size).norm(), kLengthTolerance);
    EXPECT_LT((solids[i].X_BS.translation() - expected[i].center).norm(), kLengthTolerance);
    EXPECT_EQ(solids[i].color, tray.color);
  }
}

TEST(Solids, OfACompositeStandInTheFrameOfTheWhole) {
  const RigidTransform X_BE(RotationFromFixedAxes({0, 0, 90}), Vector3(1, 0, 0));
  const RigidTransform X_EF(RotationFromFixedAxes({90, 0, 0}), Vector3(0, 2, 0));
  const Part ball{.id = "ball", .X_PE = X_EF, .shape = Sphere{}};
  const Part arm{.id = "arm", .X_PE = X_BE, .shape = Composite{{ball}}};
  const Part whole{.id = "whole",
                   .X_PE = RigidTransform(Vector3(9, 9, 9)),
                   .shape = Composite{{arm, Part{.id = "rod", .shape = Cylinder{}}}}};
  const std::vector<Solid> solids = SolidsOf(whole);
  ASSERT_EQ(solids.size(), 2u);
  EXPECT_EQ(solids[0].part_id, "ball");
  EXPECT_EQ(solids[0].X_BS, X_BE * X_EF) << "the place of the whole in the world plays no part";
  EXPECT_EQ(solids[0].X_BS.translation(), Vector3(-1, 0, 0));
  EXPECT_EQ(solids[1].part_id, "rod");
  EXPECT_EQ(solids[1].X_BS, RigidTransform());
}

TEST(MassProperties, OfSimpleShapesFollowTheTextbook) {
  const auto inertia_of = [](const Shape& shape) {
    return Vector3(MassPropertiesOf(SolidsOf(Part{.shape = shape}), 12).inertia.diagonal());
  };
  EXPECT_LT((inertia_of(Block{{1, 2, 3}}) - Vector3(13, 10, 5)).norm(), 1e-12);
  EXPECT_LT((inertia_of(Sphere{0.5}) - Vector3::Constant(1.2)).norm(), 1e-12);
  EXPECT_LT((inertia_of(Cylinder{.radius = 1, .length = 4}) - Vector3(19, 6, 19)).norm(), 1e-12)
      << "the axis is y";
}

TEST(MassProperties, OfAnEmptyShapeAreThoseOfAUnitBall) {
  const MassProperties properties = MassPropertiesOf({}, 2);
  EXPECT_EQ(properties.mass, 2);
  const Part ball{.shape = Sphere{0.05}};
  EXPECT_LT((properties.inertia - MassPropertiesOf(SolidsOf(ball), 2).inertia).norm(), 1e-15);
}

bool IsWithin(const Polyhedron& polyhedron, const Vector3& p) {
  return std::ranges::all_of(polyhedron.faces, [&](const Polyhedron::Face& face) {
    return polyhedron.AreaVectorOf(face).dot(p - polyhedron.corners[face[0]]) <= 0;
  });
}

/// The pieces as they are added up by MassPropertiesOf(): each with its own volume, overlaps twice.
class BruteForce {
 public:
  static Matrix3 InertiaOf(const std::vector<Solid>& solids, double mass) {
    Matrix3 second_moment = Matrix3::Zero();
    double volume = 0;
    for (const Solid& solid : solids) {
      const Vector3 half = HalfExtentOf(solid.shape);
      const double cell = 8 * half.prod() / (kSteps * kSteps * kSteps);
      for (int i = 0; i < kSteps * kSteps * kSteps; ++i) {
        const Vector3 grid(i % kSteps, i / kSteps % kSteps, i / kSteps / kSteps);
        const Vector3 unit = (2 * grid + Vector3::Ones()) / kSteps - Vector3::Ones();
        const Vector3 p_SQ = unit.cwiseProduct(half);
        if (!Contains(solid.shape, p_SQ)) continue;
        const Vector3 p_BQ = solid.X_BS * p_SQ;
        volume += cell;
        second_moment +=
            cell * (p_BQ.squaredNorm() * Matrix3::Identity() - p_BQ * p_BQ.transpose());
      }
    }
    return second_moment * (mass / volume);
  }

 private:
  static constexpr int kSteps = 60;

  static Vector3 HalfExtentOf(const SolidShape& shape) {
    return std::visit(
        Overloaded{[](const Block& block) { return Vector3(block.size / 2); },
                   [](const Cylinder& c) { return Vector3(c.radius, c.length / 2, c.radius); },
                   [](const Sphere& s) { return Vector3(Vector3::Constant(s.radius)); },
                   [](const Hull& hull) {
                     Vector3 most = Vector3::Zero();
                     for (const Vector3& corner : hull.polyhedron().corners) {
                       most = most.cwiseMax(corner.cwiseAbs());
                     }
                     return most;
                   }},
        shape);
  }

  static bool Contains(const SolidShape& shape, const Vector3& p) {
    return std::visit(Overloaded{[](const Block&) { return true; },
                                 [&](const Cylinder& c) {
                                   return p.x() * p.x() + p.z() * p.z() <= c.radius * c.radius;
                                 },
                                 [&](const Sphere& s) { return p.norm() <= s.radius; },
                                 [&](const Hull& hull) { return IsWithin(hull.polyhedron(), p); }},
                      shape);
  }
};

TEST(MassProperties, OfACompositeAgreeWithCountingCells) {
  const auto at = [](const Vector3& angles_deg, const Vector3& p) {
    return RigidTransform(RotationFromFixedAxes(angles_deg), p);
  };
  const Part whole{
      .shape = Composite{{
          Part{.X_PE = at({10, 20, 30}, {0.3, 0, 0}), .shape = Block{{0.2, 0.1, 0.4}}},
          Part{.X_PE = at({0, 0, 70}, {-0.1, 0.2, 0}), .shape = Cylinder{0.05, 0.5}},
          Part{.X_PE = at({0, 0, 0}, {0, -0.3, 0.2}), .shape = Sphere{0.12}},
          Part{.X_PE = at({-40, 0, 5}, {0.1, 0.1, -0.3}), .shape = Box{{0.3, 0.3, 0.2}, 0.02}},
      }}};
  const std::vector<Solid> solids = SolidsOf(whole);
  const Matrix3 inertia = MassPropertiesOf(solids, 3).inertia;
  EXPECT_LT((inertia - BruteForce::InertiaOf(solids, 3)).norm() / inertia.norm(), 2e-3);
  EXPECT_LT((inertia - inertia.transpose()).norm(), 1e-15);
}

TEST(MassProperties, OfFrustaAndRingsAgreeWithCountingCells) {
  const auto at = [](const Vector3& angles_deg, const Vector3& p) {
    return RigidTransform(RotationFromFixedAxes(angles_deg), p);
  };
  const Part whole{
      .shape = Composite{{
          Part{.X_PE = at({10, 20, 30}, {0.2, 0, 0}), .shape = Frustum{0.05, 0.2, 0.3, 5}},
          Part{.X_PE = at({0, 50, 0}, {-0.3, 0, 0}), .shape = Frustum{0, 0.2, 0.2, 3}},
          Part{.X_PE = at({0, 0, 70}, {0, 0.3, 0}), .shape = Ring{0.2, 0.12, 0.1, 7}},
      }}};
  const std::vector<Solid> solids = SolidsOf(whole);
  const Matrix3 inertia = MassPropertiesOf(solids, 3).inertia;
  EXPECT_LT((inertia - BruteForce::InertiaOf(solids, 3)).norm() / inertia.norm(), 5e-3);
  EXPECT_LT((inertia - inertia.transpose()).norm(), 1e-15);
}

TEST(MassProperties, OfManySidesApproachThoseOfRoundShapes) {
  const auto inertia_of = [](const Shape& shape) {
    return Vector3(MassPropertiesOf(SolidsOf(Part{.shape = shape}), 12).inertia.diagonal());
  };
  // A cylinder, a cone (base 1, height 2, about the middle of its height) and a tube, axis z.
  EXPECT_LT((inertia_of(Frustum{1, 1, 4, 1024}) - Vector3(19, 19, 6)).norm(), 1e-3);
  const double across_cone = 12 * (3.0 / 20 + 3.0 / 80 * 4 + 0.25);
  EXPECT_LT((inertia_of(Frustum{0, 1, 2, 1024}) - Vector3(across_cone, across_cone, 3.6)).norm(),
            1e-3);
  EXPECT_LT((inertia_of(Ring{2, 1, 1, 1024}) - Vector3(16, 16, 30)).norm(), 0.02);
}

}  // namespace
}  // namespace smile::scene
