#include "scene/solid.h"

#include <numbers>

#include "base/overloaded.h"
#include "scene/internal_prisms.h"

namespace smile::scene {
namespace {

void AppendContainer(const Box& box, const Part& part, const RigidTransform& X_BE,
                     std::vector<Solid>* solids) {
  const double X = box.size.x(), Y = box.size.y(), Z = box.size.z(), t = box.thickness;
  const auto wall = [&](const char* name, const Vector3& size, const Vector3& center) {
    solids->push_back(
        {Block{size}, X_BE * RigidTransform(center), part.color, part.id + "(" + name + ")"});
  };
  // The floor spans the full area; the side walls stand on it.
  wall("floor", {X, Y, t}, {0, 0, -Z / 2 + t / 2});
  wall("left", {t, Y - 2 * t, Z - t}, {-(X / 2 - t / 2), 0, t / 2});
  wall("right", {t, Y - 2 * t, Z - t}, {X / 2 - t / 2, 0, t / 2});
  wall("near", {X, t, Z - t}, {0, Y / 2 - t / 2, t / 2});
  wall("far", {X, t, Z - t}, {0, -(Y / 2 - t / 2), t / 2});
}

void AppendSolids(const Part& part, const RigidTransform& X_BE, std::vector<Solid>* solids) {
  const auto simple = [&](const auto& shape) {
    solids->push_back({shape, X_BE, part.color, part.id});
  };
  std::visit(Overloaded{[&](const Box& box) { AppendContainer(box, part, X_BE, solids); },
                        [&](const Composite& composite) {
                          for (const Part& child : composite.parts) {
                            AppendSolids(child, X_BE * child.X_PE, solids);
                          }
                        },
                        [&](const Frustum& frustum) { simple(HullOf(frustum)); },
                        [&](const Ring& ring) {
                          for (const RingPiece& piece : PiecesOf(ring)) {
                            solids->push_back({piece.hull, X_BE * piece.X_RP, part.color, part.id});
                          }
                        },
                        simple},
             part.shape);
}

/// Of a shape about its own origin, along its own axes.
VolumeMoments AboutOrigin(double volume, const Vector3& unit_inertia) {
  return {.volume = volume, .unit_inertia = unit_inertia.asDiagonal()};
}

VolumeMoments VolumeMomentsOf(const SolidShape& shape) {
  using std::numbers::pi;
  return std::visit(
      Overloaded{[](const Block& block) {
                   const Vector3 square = block.size.cwiseAbs2();
                   return AboutOrigin(block.size.prod(),
                                      (Vector3::Constant(square.sum()) - square) / 12.0);
                 },
                 [](const Cylinder& c) {
                   const double across = (3 * c.radius * c.radius + c.length * c.length) / 12.0;
                   return AboutOrigin(pi * c.radius * c.radius * c.length,
                                      {across, c.radius * c.radius / 2.0, across});
                 },
                 [](const Sphere& s) {
                   return AboutOrigin(4.0 / 3.0 * pi * s.radius * s.radius * s.radius,
                                      Vector3::Constant(0.4 * s.radius * s.radius));
                 },
                 [](const Hull& hull) { return MomentsOf(hull); }},
      shape);
}

}  // namespace

std::vector<Solid> SolidsOf(const Part& whole) {
  std::vector<Solid> solids;
  AppendSolids(whole, RigidTransform(), &solids);
  return solids;
}

MassProperties MassPropertiesOf(const std::vector<Solid>& solids, double mass) {
  MassProperties properties{.mass = mass};
  std::vector<VolumeMoments> moments;
  double volume = 0;
  for (const Solid& solid : solids) {
    moments.push_back(VolumeMomentsOf(solid.shape));
    volume += moments.back().volume;
  }
  if (volume <= 0) return properties;
  for (std::size_t i = 0; i < solids.size(); ++i) {
    const double share = mass * moments[i].volume / volume;
    const Matrix3& R = solids[i].X_BS.rotation();
    const Vector3 p = solids[i].X_BS * moments[i].center;
    // Parallel-axis theorem: the piece's own inertia, turned, plus that of its mass at its centre.
    properties.inertia += share * (R * moments[i].unit_inertia * R.transpose());
    properties.inertia += share * (p.squaredNorm() * Matrix3::Identity() - p * p.transpose());
  }
  return properties;
}

}  // namespace smile::scene
