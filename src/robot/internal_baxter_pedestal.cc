#include <algorithm>
#include <cmath>
#include <numbers>

#include "robot/internal_baxter_links.h"

namespace smile::robot::internal {
namespace {

using Eigen::Vector2d;
using mesh::Outline;
using scene::SurfaceMesh;

/// The flat casting with four legs, seen from above.
Outline LegsOutline() {
  const std::vector<Vector2d> front{
      {0.182, 0.0},   {0.195, 0.07},  {0.235, 0.13}, {0.30, 0.172},  {0.41, 0.228}, {0.41, 0.40},
      {0.305, 0.40},  {0.292, 0.31},  {0.20, 0.235}, {0.09, 0.195},  {0.0, 0.184},  {-0.10, 0.178},
      {-0.18, 0.19},  {-0.29, 0.232}, {-0.36, 0.28}, {-0.388, 0.40}, {-0.48, 0.40}, {-0.495, 0.205},
      {-0.35, 0.106}, {-0.29, 0.05},  {-0.278, 0.0}};
  Outline outline = front;
  for (auto p = front.rbegin(); p != front.rend(); ++p) {
    if (p->y() > 0) outline.emplace_back(p->x(), -p->y());
  }
  return mesh::RoundedOutline(outline, 0.05, 2);
}

/// The casting lies lower towards its tips and arches underneath.
SurfaceMesh Legs() {
  struct Level {
    double share, inset;  ///< from the underside (0) to the top (1)
  };
  const Outline outline = LegsOutline();
  std::vector<mesh::Section> sections;
  for (const auto& [share, inset] :
       {Level{0, 0.006}, Level{0.10, 0}, Level{0.84, 0}, Level{0.95, 0.006}, Level{1.0, 0.020}}) {
    mesh::Section section;
    for (const Vector2d& p : outline) {
      const double reach = p.norm(), out = std::clamp((reach - 0.18) / 0.4, 0.0, 1.0);
      const double top = -0.655 - 0.045 * out * out;
      const double bottom = -0.735 - 0.058 * out * out * out;
      const Vector2d at = p * (1 - inset / reach);
      section.emplace_back(at.x(), at.y(), bottom + share * (top - bottom));
    }
    sections.push_back(std::move(section));
  }
  return mesh::Skin(sections);
}

SurfaceMesh Column() {
  return mesh::Lathe({{0.165, -0.672},
                      {0.160, -0.662},
                      {0.140, -0.652},
                      {0.118, -0.644},
                      {0.107, -0.634},
                      {0.104, -0.620},
                      {0.104, -0.165}},
                     32);
}

/// The clamp the robot stands in: a drum of twelve faces.
SurfaceMesh Collar() {
  const Outline drum = mesh::RoundedOutline(mesh::CircleOutline(0.196, 12), 0.05, 2);
  return mesh::Extrusion(drum, -0.176, -0.060, 0.006, 2);
}

std::vector<SurfaceMesh> Clamps() {
  std::vector<SurfaceMesh> clamps;
  for (int k = 0; k < 4; ++k) {
    const double angle = std::numbers::pi / 2 * k;
    clamps.push_back(mesh::Placed(
        {Eigen::AngleAxisd(angle, Vector3::UnitZ()).toRotationMatrix(), Vector3(0, 0, -0.118)},
        mesh::Placed(RigidTransform(Vector3(0.184, 0, 0)),
                     mesh::RoundedBox({0.034, 0.05, 0.132}, 0.006, 0.004))));
  }
  return clamps;
}

SurfaceMesh At(const Vector3& place, const SurfaceMesh& what) {
  return mesh::Placed(RigidTransform(place), what);
}

SurfaceMesh Wheel() {
  const SurfaceMesh tyre = mesh::Lathe(
      {{0.045, -0.0135}, {0.060, -0.010}, {0.063, 0.0}, {0.060, 0.010}, {0.045, 0.0135}}, 16);
  return mesh::Placed(AlongMinusY(), tyre);
}

SurfaceMesh Hub() {
  return mesh::Placed(AlongMinusY(),
                      mesh::Lathe({{0, -0.038}, {0.034, -0.036}, {0.034, 0.036}, {0, 0.038}}, 24));
}

/// The hand wheel of a foot: a star of six lobes.
SurfaceMesh StarKnob() {
  Outline star;
  for (int k = 0; k < 24; ++k) {
    const double angle = 2 * std::numbers::pi * k / 24;
    const double radius = 0.0335 + 0.0045 * std::cos(6 * angle);
    star.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
  }
  return mesh::Extrusion(star, -0.010, 0.010, 0.003, 1);
}

}  // namespace

LinkLook PedestalLook() {
  std::vector<SurfaceMesh> castings{Legs(), Column(), Collar()}, black, steel;
  for (const SurfaceMesh& clamp : Clamps()) castings.push_back(clamp);
  for (const double side : {-1.0, 1.0}) {
    for (const Vector2d& caster : {Vector2d(0.33, 0.285), Vector2d(-0.37, 0.262)}) {
      const Vector3 axle(caster.x(), side * caster.y(), -0.8605);
      for (const double y : {-0.0235, 0.0235}) {
        black.push_back(At(axle + Vector3(0, y, 0), Wheel()));
      }
      steel.push_back(At(axle, Hub()));
      // The fork between the twin wheels, up to the leg.
      castings.push_back(
          At(axle + Vector3(0, 0, 0.045), mesh::RoundedBox({0.04, 0.018, 0.11}, 0.006, 0.003)));
      castings.push_back(
          At(axle + Vector3(0, 0, 0.085), mesh::RoundedBox({0.075, 0.07, 0.05}, 0.015, 0.006)));
    }
    for (const Vector2d& foot : {Vector2d(0.352, 0.365), Vector2d(-0.435, 0.365)}) {
      const Vector3 floor(foot.x(), side * foot.y(), -0.924);
      steel.push_back(At(floor, mesh::Lathe({{0.011, 0.01}, {0.011, 0.262}}, 16)));
      castings.push_back(At(floor, mesh::Lathe({{0.024, 0},
                                                {0.024, 0.010},
                                                {0.012, 0.022},
                                                {0.012, 0.07},
                                                {0.018, 0.072},
                                                {0.018, 0.13}},
                                               20)));
      black.push_back(At(floor + Vector3(0, 0, 0.269), StarKnob()));
    }
  }
  // Where the column opens, in front and behind.
  for (const double x : {-0.104, 0.104}) {
    black.push_back(At({x, 0, -0.40}, mesh::RoundedBox({0.003, 0.007, 0.44}, 0.0012, 0.001)));
  }
  return {PieceOf(kDarkGray, castings), PieceOf(kRubberBlack, black), PieceOf(kSteel, steel)};
}

}  // namespace smile::robot::internal
