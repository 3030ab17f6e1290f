#include "robot/internal_baxter_links.h"

namespace smile::robot::internal {
namespace {

using scene::SurfaceMesh;

/// A rounded box between two corners, its smooth edges along z.
SurfaceMesh BoxBetween(const Vector3& low, const Vector3& high, double corner_radius,
                       double edge_radius) {
  return mesh::Placed(RigidTransform(Vector3((low + high) / 2)),
                      mesh::RoundedBox(high - low, corner_radius, edge_radius));
}

}  // namespace

LinkLook ClassicPalmLook() {
  // The motor's housing fills the space between the cuff and the fingers' rail.
  const SurfaceMesh housing =
      BoxBetween({-0.030, -0.050, -0.0125}, {0.0285, 0.050, 0.0195}, 0.016, 0.006);
  const SurfaceMesh plate =
      BoxBetween({-0.032, -0.045, -0.0155}, {0.0225, 0.045, -0.011}, 0.018, 0.001);
  const SurfaceMesh rail = mesh::Tube({{0, -0.128, 0}, {0, 0.128, 0}}, 0.0135, 0, 18);
  std::vector<SurfaceMesh> shells{housing};
  for (int side : {-1, 1}) {
    const double y = side * 0.1245;
    shells.push_back(mesh::Placed(
        AlongMinusY(),
        mesh::Extrusion(mesh::CircleOutline(0.0185, 24), -y - 0.006, -y + 0.006, 0.003, 2)));
  }
  return {PieceOf(kBrickRed, shells), PieceOf(kPale, {plate}), PieceOf(kRubberBlack, {rail})};
}

LinkLook ClassicFingerLook(bool is_left) {
  const SurfaceMesh carriage =
      BoxBetween({-0.020, 0.0004, -0.075}, {0.020, 0.030, -0.030}, 0.006, 0.004);
  // The blade grows slim towards the tip; its inner face stays in the plane where fingers meet.
  const auto cut = [](double z, double half_x, double y_max) {
    return mesh::SectionAt(
        mesh::RoundedOutline(
            {{-half_x, 0.0005}, {half_x, 0.0005}, {half_x, y_max}, {-half_x, y_max}}, 0.003, 3),
        z);
  };
  const SurfaceMesh blade =
      mesh::Skin({cut(-0.034, 0.0165, 0.026), cut(-0.02, 0.016, 0.020), cut(0.03, 0.0145, 0.0135),
                  cut(0.070, 0.0135, 0.0115), cut(0.0744, 0.0115, 0.0095)});
  const SurfaceMesh pad =
      BoxBetween({-0.0185, 0.0, 0.022}, {0.0185, 0.0062, 0.0750}, 0.0025, 0.0025);
  std::vector<SurfaceMesh> reds{carriage}, blacks{blade, pad};
  if (!is_left) {
    for (auto* surfaces : {&reds, &blacks}) {
      for (SurfaceMesh& surface : *surfaces) surface = mesh::Mirrored(std::move(surface));
    }
  }
  return {PieceOf(kBrickRed, reds), PieceOf(kRubberBlack, blacks)};
}

}  // namespace smile::robot::internal
