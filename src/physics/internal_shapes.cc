#include "physics/internal_shapes.h"

#include <algorithm>
#include <bit>

#include "base/overloaded.h"
#include "scene/shrunk_hull.h"

namespace smile::physics {
namespace {

/// Margin by which Bullet rounds cylinders [m]. Its default of 40 mm is more than the thickness of
/// most parts.
constexpr double kCylinderMargin = 0.0005;

/// Distance by which hulls are shrunk; Bullet adds it again as margin [m].
constexpr double kHullMargin = 0.0005;

/// Returns true for poses of the same bits. 0 and -0 are equal, but lead to other results.
bool HaveEqualBits(const btTransform& a, const btTransform& b) {
  using Bits = std::array<std::uint64_t, 16>;
  std::array<btScalar, 16> p, q;
  a.getOpenGLMatrix(p.data());
  b.getOpenGLMatrix(q.data());
  return std::bit_cast<Bits>(p) == std::bit_cast<Bits>(q);
}

/// Makes a hull whose faces, with Bullet's margin, are those of the polyhedron.
std::unique_ptr<btCollisionShape> MakeHull(const scene::Polyhedron& polyhedron) {
  const scene::ShrunkHull shrunk = scene::Shrink(polyhedron, kHullMargin);
  auto shape = std::make_unique<btConvexHullShape>();
  for (const Vector3& corner : shrunk.corners) {
    shape->addPoint(ToBullet(corner), /*recalculateLocalAabb=*/false);
  }
  shape->setMargin(shrunk.margin);
  shape->recalcLocalAabb();
  return shape;
}

/// Makes the shape of one solid in its own frame S.
std::unique_ptr<btCollisionShape> MakePart(const scene::SolidShape& solid) {
  return std::visit(
      Overloaded{[](const scene::Block& block) -> std::unique_ptr<btCollisionShape> {
                   return std::make_unique<btBoxShape>(ToBullet(Vector3(block.size / 2)));
                 },
                 [](const scene::Cylinder& cylinder) -> std::unique_ptr<btCollisionShape> {
                   auto shape = std::make_unique<btCylinderShape>(
                       btVector3(cylinder.radius, cylinder.length / 2, cylinder.radius));
                   shape->setMargin(
                       std::min({kCylinderMargin, 0.1 * cylinder.radius, 0.05 * cylinder.length}));
                   return shape;
                 },
                 [](const scene::Sphere& sphere) -> std::unique_ptr<btCollisionShape> {
                   return std::make_unique<btSphereShape>(sphere.radius);
                 },
                 [](const scene::Hull& hull) { return MakeHull(hull.polyhedron()); }},
      solid);
}

}  // namespace

std::span<const PosedPart> PosedCompound::PartsAt(const btTransform& X_WA) const {
  if (!parts_.empty() && HaveEqualBits(X_WA, X_WA_)) return parts_;
  X_WA_ = X_WA;
  parts_.resize(getNumChildShapes());
  for (int i = 0; i < getNumChildShapes(); ++i) {
    parts_[i].X_WP = X_WA * getChildTransform(i);
    getChildShape(i)->getAabb(parts_[i].X_WP, parts_[i].min, parts_[i].max);
  }
  return parts_;
}

CollisionShape MakeCollisionShape(const std::vector<scene::Solid>& solids,
                                  const RigidTransform& X_AB) {
  CollisionShape result;
  for (const scene::Solid& solid : solids) result.parts.push_back(MakePart(solid.shape));
  // A single part in the origin needs no compound.
  if (solids.size() == 1 && X_AB * solids.front().X_BS == RigidTransform()) return result;

  result.compound = std::make_unique<PosedCompound>();
  for (std::size_t i = 0; i < solids.size(); ++i) {
    result.compound->addChildShape(ToBullet(X_AB * solids[i].X_BS), result.parts[i].get());
  }
  return result;
}

}  // namespace smile::physics
