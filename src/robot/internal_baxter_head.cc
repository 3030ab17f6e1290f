#include "math/angles.h"
#include "robot/internal_baxter_face.h"
#include "robot/internal_baxter_links.h"

namespace smile::robot::internal {
namespace {

using scene::SurfaceMesh;

constexpr Color kBezel{0.30, 0.30, 0.31};

/// The middle of the screen's slab S in the head's frame: x to the robot's left, y up along the
/// slab, z out of it, 25.3 degrees below the horizon.
RigidTransform X_HeadS() {
  const double pitch = DegreesToRadians(25.3);
  const double c = std::cos(pitch), s = std::sin(pitch);
  Matrix3 R;
  R.col(0) = Vector3::UnitY();
  R.col(1) = Vector3(s, 0, c);
  R.col(2) = Vector3(c, 0, -s);
  return {R, Vector3(0.104, 0, -0.011)};
}

mesh::Outline ScreenOutline(double width, double height, double corner_radius) {
  const double x = width / 2, y = height / 2;
  return mesh::RoundedOutline({{-x, -y}, {x, -y}, {x, y}, {-x, y}}, corner_radius, 4);
}

/// The red slab; its back is domed.
SurfaceMesh Slab() {
  const auto level = [](double width, double height, double z) {
    return mesh::SectionAt(ScreenOutline(width, height, 0.024), z);
  };
  return mesh::Skin({level(0.150, 0.090, -0.0205), level(0.215, 0.140, -0.0190),
                     level(0.246, 0.168, -0.0160), level(0.260, 0.181, -0.0110),
                     level(0.266, 0.187, -0.0040), level(0.268, 0.189, 0.0040),
                     level(0.2665, 0.1875, 0.0100), level(0.262, 0.183, 0.0140),
                     level(0.2555, 0.1765, 0.0158), level(0.248, 0.169, 0.0158)});
}

/// Below the cap; the cap itself is the torso's.
SurfaceMesh Bowl() {
  return mesh::Lathe({{0, -0.066},
                      {0.028, -0.065},
                      {0.044, -0.0605},
                      {0.0535, -0.054},
                      {0.0605, -0.046},
                      {0.0645, -0.037},
                      {0.0665, -0.025},
                      {0.0690, -0.013},
                      {0.0720, 0.007},
                      {0.0745, 0.030}},
                     32);
}

}  // namespace

LinkLook HeadLook() {
  const RigidTransform X = X_HeadS();
  const SurfaceMesh boss = mesh::Placed(
      X, mesh::Extrusion(ScreenOutline(0.052, 0.044, 0.008), -0.075, -0.015, 0.002, 1));
  LinkLook look{
      PieceOf(kCharcoal, {Bowl(), boss}), PieceOf(kBrickRed, {mesh::Placed(X, Slab())}),
      PieceOf(kBezel, {mesh::Placed(X, mesh::Extrusion(ScreenOutline(0.2475, 0.1685, 0.014), 0.012,
                                                       0.0164))})};
  for (const Mood mood : kMoods) {
    for (LookPiece& piece : FaceLook(mood, X * RigidTransform(Vector3(0, 0, 0.0166)))) {
      look.push_back(std::move(piece));
    }
  }
  return look;
}

}  // namespace smile::robot::internal
