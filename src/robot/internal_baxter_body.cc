#include <cmath>
#include <numbers>

#include "robot/internal_baxter_links.h"

namespace smile::robot::internal {
namespace {

using Eigen::Vector2d;
using mesh::Outline;
using scene::SurfaceMesh;

constexpr Color kScreenPrint{0.769, 0.769, 0.761};  ///< the strip on the chest

/// The outline whose left half (y > 0) is given, from the front to the back.
Outline BothHalves(const std::vector<Vector2d>& left) {
  Outline outline = left;
  for (auto p = left.rbegin(); p != left.rend(); ++p) {
    if (p->y() > 0) outline.emplace_back(p->x(), -p->y());
  }
  return outline;
}

std::vector<SurfaceMesh> OnBothSides(const SurfaceMesh& left) {
  return {left, mesh::Mirrored(left)};
}

/// A rectangle about the origin.
Outline Rectangle(double length, double width) {
  const double x = length / 2, y = width / 2;
  return {{-x, -y}, {x, -y}, {x, y}, {-x, y}};
}

/// The rucksack: flat flanks, round edges, a back that bulges most at shoulder height.
SurfaceMesh BackBody() {
  const Outline outline = mesh::RoundedOutline(BothHalves({{-0.028, 0.118},
                                                           {-0.048, 0.168},
                                                           {-0.075, 0.1765},
                                                           {-0.175, 0.172},
                                                           {-0.204, 0.110},
                                                           {-0.2045, 0.0}}),
                                               0.03, 3);
  struct Level {
    double z, inset, bulge;
  };
  std::vector<mesh::Section> sections;
  for (const auto& [z, inset, bulge] :
       {Level{0.006, 0.030, 0.0}, Level{0.016, 0.010, 0.0}, Level{0.04, 0, 0.0},
        Level{0.25, 0, 0.0}, Level{0.36, 0, 0.008}, Level{0.50, 0, 0.016},
        Level{0.530, 0.005, 0.013}, Level{0.552, 0.018, 0.011}, Level{0.563, 0.044, 0.010}}) {
    mesh::Section section = mesh::SectionAt(outline, z);
    for (Vector3& p : section) {
      const double out = std::max(0.0, -p.x() - 0.1) / 0.1;
      p.x() -= bulge * out * std::cos(7 * p.y());
      // Towards the middle by `inset`, in proportion, so that no edge folds over.
      p.x() += -inset * (p.x() + 0.118) / 0.09;
      p.y() -= inset * p.y() / 0.176;
    }
    sections.push_back(std::move(section));
  }
  return mesh::Skin(sections);
}

/// The chest: a keel in front of the rucksack, its top sloping forward.
SurfaceMesh Keel() {
  const Outline outline = mesh::RoundedOutline(
      BothHalves({{0.127, 0.036}, {0.114, 0.0645}, {0.036, 0.0625}, {-0.09, 0.0640}}), 0.016, 3);
  const auto slope = [](double x) { return 0.584 - 0.26 * (x + 0.03); };
  std::vector<mesh::Section> sections{mesh::SectionAt(outline, 0.150)};
  struct Level {
    double below, inset;
  };
  for (const auto& [below, inset] : {Level{0.026, 0}, Level{0.014, 0.003}, Level{0.006, 0.009},
                                     Level{0.001, 0.017}, Level{0, 0.024}}) {
    mesh::Section section;
    for (const Vector2d& p : outline) {
      const double x = p.x() - inset * (p.x() - 0.018) / 0.108;
      section.emplace_back(x, p.y() * (1 - inset / 0.065), slope(x) - below);
    }
    sections.push_back(std::move(section));
  }
  return mesh::Skin(sections);
}

/// The scoops between keel and rucksack, which give the upper arms room.
SurfaceMesh Scoops() {
  const Outline outline = mesh::RoundedOutline(BothHalves({{0.034, 0.050},
                                                           {0.028, 0.064},
                                                           {0.012, 0.070},
                                                           {-0.008, 0.100},
                                                           {-0.040, 0.163},
                                                           {-0.070, 0.163}}),
                                               0.02, 3);
  return mesh::Extrusion(outline, 0.150, 0.553, 0.018, 2);
}

/// What the upper arms pass over, at both sides of the keel's foot.
SurfaceMesh Shelf() {
  const Outline outline = mesh::RoundedOutline(
      BothHalves({{0.126, 0.052}, {0.108, 0.098}, {0.030, 0.140}, {-0.04, 0.172}, {-0.15, 0.172}}),
      0.03, 3);
  return mesh::Extrusion(outline, 0.14, 0.225, 0.018, 2);
}

SurfaceMesh Waist() {
  const Outline outline = mesh::RoundedOutline(
      BothHalves({{0.1275, 0.092}, {0.112, 0.110}, {0.02, 0.150}, {-0.15, 0.150}, {-0.19, 0.10}}),
      0.02, 4);
  return mesh::Extrusion(outline, 0.012, 0.19, 0.012, 1);
}

/// The left arm stands on it: a disc with a web to the waist, rounded upwards underneath.
SurfaceMesh ShoulderPod() {
  constexpr double kX = 0.064, kY = 0.259, kRadius = 0.077;
  Outline outline{{-0.035, 0.09}, {0.112, 0.09}};
  for (int k = 0; k <= 18; ++k) {
    const double angle = std::numbers::pi * k / 18;
    outline.emplace_back(kX + kRadius * std::cos(angle), kY + kRadius * std::sin(angle));
  }
  struct Level {
    double z, inset;
  };
  std::vector<mesh::Section> sections;
  for (const auto& [z, inset] :
       {Level{0.022, 0.055}, Level{0.028, 0.036}, Level{0.038, 0.018}, Level{0.052, 0.006},
        Level{0.070, 0.0}, Level{0.150, 0.0}, Level{0.154, 0.001}, Level{0.156, 0.004}}) {
    mesh::Section section;
    for (const Vector2d& p : outline) {
      const double far = std::clamp((p.y() - 0.09) / 0.246, 0.0, 1.0);
      section.emplace_back(p.x() - inset * (p.x() - kX) / 0.11, p.y() - 1.3 * inset * far, z);
    }
    sections.push_back(std::move(section));
  }
  return mesh::Skin(sections);
}

SurfaceMesh Turret() {
  return mesh::Lathe({{0.180, -0.062},
                      {0.182, -0.055},
                      {0.180, -0.038},
                      {0.153, -0.032},
                      {0.150, -0.006},
                      {0.156, -0.004},
                      {0.156, 0.013}},
                     32);
}

SurfaceMesh Neck() {
  return mesh::Loft({{0.520, -0.212, -0.045, -0.100, 0.100, 3},
                     {0.560, -0.205, -0.040, -0.088, 0.088, 3},
                     {0.590, -0.193, -0.046, -0.078, 0.078, 2.8},
                     {0.606, -0.184, -0.055, -0.071, 0.071, 2.6},
                     {0.618, -0.176, -0.058, -0.058, 0.058, 2.4},
                     {0.632, -0.167, -0.058, -0.046, 0.046, 2.2},
                     {0.648, -0.156, -0.052, -0.040, 0.040, 2},
                     {0.668, -0.143, -0.036, -0.0385, 0.0385, 2},
                     {0.690, -0.127, -0.014, -0.0385, 0.0385, 2},
                     {0.712, -0.109, 0.008, -0.0385, 0.0385, 2},
                     {0.735, -0.089, 0.030, -0.038, 0.038, 2},
                     {0.757, -0.066, 0.045, -0.036, 0.036, 2},
                     {0.772, -0.043, 0.050, -0.032, 0.032, 2},
                     {0.780, -0.020, 0.050, -0.024, 0.024, 2}},
                    24);
}

constexpr double kPanX = 0.0595;  ///< where the head pans, and the middle of its cap

SurfaceMesh HeadCap() {
  const SurfaceMesh cap = mesh::Lathe({{0.0740, 0.712},
                                       {0.0755, 0.735},
                                       {0.0775, 0.765},
                                       {0.0795, 0.805},
                                       {0.0825, 0.829},
                                       {0.0830, 0.840},
                                       {0.0815, 0.852},
                                       {0.0770, 0.862},
                                       {0.0690, 0.869},
                                       {0.0500, 0.873},
                                       {0.0250, 0.8748},
                                       {0, 0.8753}},
                                      40);
  return mesh::Placed(RigidTransform(Vector3(kPanX, 0, 0)), cap);
}

/// The twelve ears of the sonar, around the cap.
std::vector<SurfaceMesh> SonarDots() {
  const SurfaceMesh dot =
      mesh::Placed(AlongX(), mesh::Lathe({{0.0060, 0.075}, {0.0060, 0.0834}}, 10));
  std::vector<SurfaceMesh> dots;
  for (int k = 0; k < 12; ++k) {
    const double angle = std::numbers::pi * (2 * k + 1) / 12;
    dots.push_back(mesh::Placed(
        {Eigen::AngleAxisd(angle, Vector3::UnitZ()).toRotationMatrix(), Vector3(kPanX, 0, 0.829)},
        dot));
  }
  return dots;
}

std::vector<SurfaceMesh> TubeFrame() {
  constexpr double kRadius = 0.0135, kBend = 0.05;
  constexpr int kSides = 13;
  std::vector<SurfaceMesh> tubes = OnBothSides(mesh::Tube({{-0.070, 0.185, 0.000},
                                                           {-0.155, 0.212, 0.020},
                                                           {-0.165, 0.212, 0.490},
                                                           {-0.152, 0.165, 0.555},
                                                           {-0.135, 0.070, 0.592}},
                                                          kRadius, kBend, kSides));
  std::vector<Vector3> bumper{{-0.16, 0.206, 0.188}, {0.13, 0.157, 0.188},
                              {0.185, 0.105, 0.188}, {0.185, -0.105, 0.188},
                              {0.13, -0.157, 0.188}, {-0.16, -0.206, 0.188}};
  tubes.push_back(mesh::Tube(bumper, kRadius, kBend, kSides));
  const SurfaceMesh bolt =
      mesh::Tube({{-0.155, 0.118, 0.565}, {-0.155, 0.128, 0.602}}, 0.005, 0, 12);
  for (const SurfaceMesh& each : OnBothSides(bolt)) tubes.push_back(each);
  return tubes;
}

/// An oval pad with a knob on the left flank, like the forearm's; `what` drawn with x upwards.
SurfaceMesh OnLeftFlank(const Outline& what, double proud, double edge_radius) {
  Matrix3 R;
  R.col(0) = Vector3::UnitZ();
  R.col(1) = Vector3::UnitX();
  R.col(2) = Vector3::UnitY();
  return mesh::Placed({R, Vector3(-0.1, 0, 0.385)},
                      mesh::Extrusion(what, 0.165, proud, edge_radius, 2));
}

SurfaceMesh ChestPlate(double half_width, double z_min, double z_max, double x_front) {
  const Outline outline = mesh::RoundedOutline(
      {{-half_width, z_min}, {half_width, z_min}, {half_width, z_max}, {-half_width, z_max}},
      half_width * 0.55, 6);
  return mesh::Placed(AlongX(), mesh::Extrusion(outline, 0.115, x_front, 0.0008, 1));
}

/// Slots of the vent at the neck's root, and seams between the shells.
std::vector<SurfaceMesh> Slots() {
  std::vector<SurfaceMesh> slots;
  for (int k = 0; k < 5; ++k) {
    const double z = 0.526 + 0.0125 * k;
    slots.push_back(
        mesh::Placed(RigidTransform(Vector3(-0.2075 + 0.0045 * k, 0, z)),
                     mesh::RoundedBox({0.012, 0.126 - 0.006 * k, 0.0055}, 0.002, 0.001)));
  }
  // Recesses beside the strip, where the waist is bolted.
  for (const double y : {-0.072, 0.072}) {
    for (const double z : {0.05, 0.105}) {
      slots.push_back(mesh::Placed(
          AlongX() * RigidTransform(Vector3(y, z, 0.1265)),
          mesh::Extrusion(mesh::RoundedOutline(Rectangle(0.018, 0.028), 0.005, 3), -0.01, 0.0016)));
    }
  }
  return slots;
}

}  // namespace

LinkLook TorsoLook() {
  std::vector<SurfaceMesh> shells{BackBody(), Keel(),   Scoops(), Shelf(),
                                  Waist(),    Turret(), Neck(),   HeadCap()};
  for (const SurfaceMesh& pod : OnBothSides(ShoulderPod())) shells.push_back(pod);

  std::vector<SurfaceMesh> frame = TubeFrame();
  for (const SurfaceMesh& pad :
       OnBothSides(OnLeftFlank(mesh::StadiumOutline(0.125, 0.052, 20), 0.1805, 0.002))) {
    frame.push_back(pad);
  }
  std::vector<SurfaceMesh> black = Slots();
  for (const SurfaceMesh& dot : SonarDots()) black.push_back(dot);
  black.push_back(ChestPlate(0.0475, 0.110, 0.5225, 0.1290));
  std::vector<SurfaceMesh> knobs =
      OnBothSides(OnLeftFlank(mesh::CircleOutline(0.0175, 18), 0.193, 0.004));

  return {PieceOf(kCharcoal, shells), PieceOf(kDarkGray, frame), PieceOf(kRubberBlack, black),
          PieceOf(kSteel, knobs),
          PieceOf(kScreenPrint, {ChestPlate(0.0435, 0.114, 0.5185, 0.1305)})};
}

}  // namespace smile::robot::internal
