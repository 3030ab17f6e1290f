#include "scene/shrunk_hull.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "scene/parts.h"

namespace smile::scene {
namespace {

TEST(Shrink, MovesEveryFaceInwardsByTheMargin) {
  for (const Shape& shape : std::initializer_list<Shape>{
           Frustum{}, Frustum{.radius_top = 0, .sides = 1024},
           Frustum{.radius_top = 1e-4, .radius_bottom = 0.05, .sides = 7},
           Frustum{.radius_top = 0.05, .radius_bottom = 0.05, .height = 1e-4}, Ring{},
           Ring{.radius_inner = 0.0999, .sides = 1024}}) {
    const SolidShape solid = SolidsOf({.shape = shape}).front().shape;
    const Polyhedron& polyhedron = std::get<Hull>(solid).polyhedron();
    const ShrunkHull shrunk = Shrink(polyhedron, 0.0005);
    EXPECT_GT(shrunk.margin, 0);
    EXPECT_LE(shrunk.margin, 0.0005);
    for (const Polyhedron::Face& face : polyhedron.faces) {
      const Vector3 normal = polyhedron.AreaVectorOf(face).normalized();
      double nearest = 1;
      for (const Vector3& corner : shrunk.corners) {
        nearest = std::min(nearest, normal.dot(polyhedron.corners[face[0]] - corner));
      }
      EXPECT_NEAR(nearest, shrunk.margin, 1e-9);
    }
  }
}

}  // namespace
}  // namespace smile::scene
