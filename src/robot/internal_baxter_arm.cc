#include <cmath>
#include <numbers>

#include "robot/internal_baxter_links.h"

namespace smile::robot::internal {
namespace {

using mesh::Outline;
using scene::SurfaceMesh;
using Profile = std::vector<Eigen::Vector2d>;

constexpr int kBottleSides = 22, kDiscSides = 26;

/// A flat body around the next joint, drawn in (x, z), from y_min to y_max.
SurfaceMesh Web(const Outline& outline, double y_min, double y_max, double edge_radius) {
  return mesh::Placed(AlongMinusY(), mesh::Extrusion(outline, -y_max, -y_min, edge_radius, 1));
}

SurfaceMesh RingBody(double x, double z, double radius, double y_min, double y_max) {
  Outline circle = mesh::CircleOutline(radius, kDiscSides);
  for (Eigen::Vector2d& p : circle) p += Eigen::Vector2d(x, z);
  return Web(circle, y_min, y_max, 0.003);
}

/// A cheek of a fork: round about z, with straight flanks to where the stub begins.
/// @param flank  half of its width there [m].
Outline CheekOutline(double radius, double flank, double x_end) {
  const double open = std::asin(flank / radius);  // where the flanks leave the circle
  constexpr int kSides = 22;
  Outline outline;
  for (int k = 0; k <= kSides; ++k) {
    const double angle = open + (2 * std::numbers::pi - 2 * open) * k / kSides;
    outline.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
  }
  outline.emplace_back(x_end, -flank);
  outline.emplace_back(x_end, flank);
  return outline;
}

/// From the cheeks of a fork to the round flange of the next bottle: cuts in (y, z), along x.
SurfaceMesh Stub(const std::vector<mesh::Cut>& cuts) {
  return mesh::Placed(AlongX(), mesh::Loft(cuts, kBottleSides));
}

mesh::Cut Square(double at, double half_y, double half_z, double exponent) {
  return {at, -half_y, half_y, -half_z, half_z, exponent};
}

/// The black disc that covers a cheek: edge round, face dished within a rim. Its outer face looks
/// to +z.
SurfaceMesh DishedDisc(double radius, double z_min, double z_max) {
  const double top = z_max;
  return mesh::Lathe({{radius, z_min},
                      {radius, top - 0.008},
                      {radius - 0.0025, top - 0.0025},
                      {radius - 0.008, top},
                      {radius - 0.015, top},
                      {radius - 0.019, top - 0.0045},
                      {0, top - 0.0045}},
                     kDiscSides);
}

/// What lies at -z as its image lies at +z.
SurfaceMesh TurnedOver(const SurfaceMesh& surface) {
  return mesh::Placed(
      {Eigen::AngleAxisd(std::numbers::pi, Vector3::UnitX()).toRotationMatrix(), Vector3::Zero()},
      surface);
}

/// Upright along `from` to `to`, seen in link axes.
RigidTransform Standing(const Vector3& from, const Vector3& to) {
  return {Quaternion::FromTwoVectors(Vector3::UnitZ(), to - from).toRotationMatrix(), from};
}

/// A coil spring, as the rings one sees of it.
SurfaceMesh Coil(const Vector3& from, const Vector3& to, double radius, int rings) {
  const double length = (to - from).norm(), pitch = length / rings;
  Profile profile{{0, 0}};
  for (int k = 0; k < rings; ++k) {
    profile.emplace_back(radius - 0.003, pitch * k);
    profile.emplace_back(radius, pitch * (k + 0.5));
  }
  profile.emplace_back(radius - 0.003, length);
  profile.emplace_back(0, length);
  return mesh::Placed(Standing(from, to), mesh::Lathe(profile, 10));
}

/// Where the coils of a shoulder are held, at one side.
struct SpringPlace {
  Vector3 foot, waist, head;
};
SpringPlace SpringAt(int side) {
  return {{0.046, side * 0.118, 0.118}, {0.088, side * 0.118, 0.265}, {0.122, side * 0.118, 0.362}};
}

SurfaceMesh SpringBoot(int side) {
  const SpringPlace at = SpringAt(side);
  const double length = (at.head - at.waist).norm();
  return mesh::Placed(Standing(at.waist, at.head), mesh::Lathe({{0, 0},
                                                                {0.011, 0},
                                                                {0.0145, 0.012},
                                                                {0.0195, 0.03},
                                                                {0.020, length - 0.02},
                                                                {0.017, length - 0.006},
                                                                {0.011, length},
                                                                {0, length}},
                                                               18));
}

/// The left half of the bumper on the elbow's back edge: a little larger than the bottle it
/// covers, open in the middle.
SurfaceMesh Bumper() {
  constexpr double kGap = 0.005;
  constexpr int kArc = 9;
  std::vector<mesh::Section> sections;
  // Each cut is one of the whole elbow; only its rear quarter is used.
  const auto add = [&](double z, double x_min, double half_y, double x_front) {
    const mesh::Cut cut{z, x_min, -0.004, -half_y, half_y, 3};
    const Outline whole = mesh::SuperellipseOutline(cut, 4 * kArc);
    mesh::Section section{{x_front, kGap, z}};
    section.emplace_back(x_front, whole[kArc].y(), z);
    for (int k = kArc + 1; k <= 2 * kArc; ++k) {
      section.emplace_back(std::min(whole[k].x(), x_front), std::max(whole[k].y(), kGap), z);
    }
    sections.push_back(std::move(section));
  };
  add(0.250, -0.0915, 0.0765, -0.062);
  add(0.251, -0.0930, 0.0780, -0.060);
  add(0.275, -0.0925, 0.0770, -0.048);
  add(0.288, -0.0900, 0.0740, -0.043);
  add(0.297, -0.0845, 0.0680, -0.040);
  add(0.3025, -0.0765, 0.0600, -0.040);
  add(0.3045, -0.0680, 0.0500, -0.041);
  return mesh::Skin(sections);
}

/// Something flat on the back of the forearm, drawn with x along the arm; `proud` is its face [m].
SurfaceMesh OnBack(const Outline& outline, double z, double proud, double edge_radius) {
  Matrix3 R;
  R.col(0) = Vector3::UnitZ();
  R.col(1) = Vector3::UnitY();
  R.col(2) = -Vector3::UnitX();
  return mesh::Placed({R, Vector3(0, 0, z)},
                      mesh::Extrusion(outline, 0.050, proud, edge_radius, 1));
}

}  // namespace

LinkLook UpperShoulderLook() {
  const SurfaceMesh bottle = mesh::Loft({{0.031, -0.076, 0.076, -0.0755, 0.0755, 2},
                                         {0.064, -0.076, 0.075, -0.075, 0.075, 2.1},
                                         {0.094, -0.081, 0.068, -0.0745, 0.0745, 2.3},
                                         {0.118, -0.084, 0.046, -0.075, 0.075, 2.5},
                                         {0.150, -0.086, 0.041, -0.076, 0.076, 2.5},
                                         {0.182, -0.088, 0.041, -0.078, 0.078, 2.6},
                                         {0.198, -0.088, 0.034, -0.0795, 0.0795, 2.8},
                                         {0.206, -0.088, 0.010, -0.080, 0.080, 3},
                                         {0.230, -0.088, -0.002, -0.081, 0.081, 3},
                                         {0.265, -0.088, -0.006, -0.081, 0.081, 3},
                                         {0.283, -0.0865, -0.008, -0.079, 0.079, 3},
                                         {0.295, -0.082, -0.012, -0.073, 0.073, 3},
                                         {0.302, -0.074, -0.018, -0.062, 0.062, 3},
                                         {0.305, -0.062, -0.026, -0.048, 0.048, 3}},
                                        kBottleSides);
  const SurfaceMesh web =
      Web({{-0.045, 0.17}, {0.035, 0.17}, {0.050, 0.21}, {0.045, 0.330}, {-0.045, 0.300}}, -0.0355,
          0.0355, 0.003);
  const SurfaceMesh wedge = mesh::Extrusion({{0.028, -0.094},
                                             {0.052, -0.094},
                                             {0.056, -0.05},
                                             {0.056, 0.05},
                                             {0.052, 0.094},
                                             {0.028, 0.094}},
                                            0.117, 0.140, 0.002, 1);
  const SurfaceMesh wedge_top = mesh::Skin(
      {mesh::SectionAt({{0.03, -0.08}, {0.054, -0.08}, {0.054, 0.08}, {0.03, 0.08}}, 0.138),
       mesh::SectionAt({{0.03, -0.04}, {0.048, -0.04}, {0.048, 0.04}, {0.03, 0.04}}, 0.186)});
  std::vector<SurfaceMesh> coils, boots{wedge, wedge_top};
  for (int side : {-1, 1}) {
    const SpringPlace at = SpringAt(side);
    coils.push_back(Coil(at.foot, at.waist, 0.0095, 9));
    boots.push_back(SpringBoot(side));
    boots.push_back(
        mesh::Placed(Standing(at.foot - Vector3(0.004, 0, 0.012), at.foot),
                     mesh::Lathe({{0, 0}, {0.014, 0}, {0.014, 0.022}, {0, 0.022}}, 14)));
  }
  boots.push_back(mesh::Tube({{0.046, -0.135, 0.121}, {0.046, 0.135, 0.121}}, 0.0075, 0, 12));
  return {PieceOf(kCharcoal, {bottle, web, RingBody(0.069, 0.27035, 0.066, -0.0355, 0.0355)}),
          PieceOf(kRubberBlack, boots), PieceOf(kSteel, coils)};
}

LinkLook LowerShoulderLook() {
  const Outline cheek = CheekOutline(0.073, 0.061, 0.080);
  const SurfaceMesh stub = Stub({Square(0.0735, 0.0609, 0.0970, 8),
                                 Square(0.090, 0.0635, 0.0970, 6), Square(0.100, 0.067, 0.0955, 4),
                                 Square(0.107, 0.071, 0.0900, 3), Square(0.113, 0.075, 0.0800, 2.2),
                                 Square(0.116, 0.076, 0.076, 2), Square(0.121, 0.076, 0.076, 2)});
  return {PieceOf(kBrickRed, {mesh::Extrusion(cheek, 0.0362, 0.0975, 0.006, 2),
                              mesh::Extrusion(cheek, -0.0975, -0.0362, 0.006, 2), stub})};
}

LinkLook UpperElbowLook() {
  const SurfaceMesh bottle = mesh::Loft({{0.0124, -0.0757, 0.0757, -0.0757, 0.0757, 2},
                                         {0.016, -0.0765, 0.0765, -0.0765, 0.0765, 2},
                                         {0.040, -0.079, 0.077, -0.078, 0.078, 2},
                                         {0.070, -0.083, 0.078, -0.079, 0.079, 2.1},
                                         {0.097, -0.085, 0.077, -0.079, 0.079, 2.2},
                                         {0.108, -0.086, 0.073, -0.079, 0.079, 2.2},
                                         {0.142, -0.088, 0.057, -0.079, 0.079, 2.4},
                                         {0.170, -0.089, 0.044, -0.078, 0.078, 2.5},
                                         {0.186, -0.089, 0.036, -0.078, 0.078, 2.6},
                                         {0.194, -0.089, 0.012, -0.0775, 0.0775, 3},
                                         {0.215, -0.0895, 0.000, -0.077, 0.077, 3},
                                         {0.250, -0.0905, -0.004, -0.0755, 0.0755, 3},
                                         {0.275, -0.090, -0.006, -0.0745, 0.0745, 3},
                                         {0.291, -0.086, -0.010, -0.0695, 0.0695, 3},
                                         {0.299, -0.077, -0.018, -0.060, 0.060, 3},
                                         {0.302, -0.066, -0.026, -0.048, 0.048, 3}},
                                        kBottleSides);
  const SurfaceMesh web =
      Web({{-0.045, 0.16}, {0.038, 0.165}, {0.060, 0.21}, {0.050, 0.322}, {-0.045, 0.298}}, -0.035,
          0.035, 0.003);
  return {PieceOf(kBrickRed, {bottle, web, RingBody(0.069, 0.26242, 0.0635, -0.035, 0.035)}),
          PieceOf(kRubberBlack, {Bumper(), mesh::Mirrored(Bumper())})};
}

LinkLook LowerElbowLook() {
  const Outline cheek = CheekOutline(0.068, 0.0555, 0.070);
  const SurfaceMesh stub = Stub({Square(0.0640, 0.0554, 0.0802, 8), Square(0.072, 0.059, 0.0800, 5),
                                 Square(0.079, 0.064, 0.0780, 3), Square(0.086, 0.069, 0.0725, 2.2),
                                 Square(0.089, 0.070, 0.070, 2), Square(0.0925, 0.070, 0.070, 2)});
  const SurfaceMesh disc = DishedDisc(0.0691, 0.080, 0.0946);
  return {PieceOf(kBrickRed, {mesh::Extrusion(cheek, 0.0357, 0.0806, 0.002, 1),
                              mesh::Extrusion(cheek, -0.0806, -0.0357, 0.002, 1), stub}),
          PieceOf(kRubberBlack, {disc, TurnedOver(disc)})};
}

LinkLook UpperForearmLook() {
  const SurfaceMesh bottle = mesh::Loft({{-0.018, -0.0690, 0.0690, -0.0690, 0.0690, 2},
                                         {-0.013, -0.0700, 0.0700, -0.0700, 0.0700, 2},
                                         {0.011, -0.072, 0.072, -0.072, 0.072, 2},
                                         {0.060, -0.0735, 0.072, -0.074, 0.074, 2.1},
                                         {0.105, -0.074, 0.0705, -0.074, 0.074, 2.2},
                                         {0.140, -0.074, 0.0665, -0.0735, 0.0735, 2.3},
                                         {0.160, -0.073, 0.058, -0.0725, 0.0725, 2.4},
                                         {0.178, -0.071, 0.046, -0.071, 0.071, 2.6},
                                         {0.190, -0.069, 0.038, -0.069, 0.069, 2.8},
                                         {0.200, -0.063, 0.036, -0.063, 0.063, 3},
                                         {0.207, -0.054, 0.035, -0.056, 0.056, 3},
                                         {0.210, -0.045, 0.034, -0.050, 0.050, 3}},
                                        kBottleSides);
  const SurfaceMesh web = Web({{-0.037, 0.19},
                               {0.033, 0.19},
                               {0.040, 0.222},
                               {0.060, 0.262},
                               {-0.042, 0.262},
                               {-0.039, 0.225}},
                              -0.031, 0.015, 0.002);
  constexpr double kPad = 0.1157;
  Outline button = mesh::CircleOutline(0.011, 14);
  for (Eigen::Vector2d& p : button) p.y() *= 1.35;
  return {
      PieceOf(kBrickRed, {bottle, web, RingBody(0.010, 0.2707, 0.053, -0.031, 0.015)}),
      PieceOf(kPale, {OnBack(mesh::StadiumOutline(0.113, 0.053, 24), kPad, 0.0768, 0.002)}),
      PieceOf(kRubberBlack, {OnBack(mesh::StadiumOutline(0.099, 0.039, 24), kPad, 0.0778, 0)}),
      PieceOf(kSteel, {OnBack(button, 0.0805, 0.0792, 0.001), OnBack(button, 0.151, 0.0792, 0.001),
                       OnBack(mesh::CircleOutline(0.0175, 18), kPad, 0.0905, 0.004)})};
}

LinkLook LowerForearmLook() {
  const Outline cheek = CheekOutline(0.058, 0.050, 0.054);
  const SurfaceMesh stub = Stub({{0.0535, -0.0500, 0.0500, -0.0660, 0.0655, 5},
                                 {0.0580, -0.0545, 0.0555, -0.0668, 0.0663, 3.5},
                                 {0.0700, -0.0575, 0.0595, -0.0662, 0.0662, 2.6},
                                 {0.0850, -0.0585, 0.0615, -0.0655, 0.0655, 2.3},
                                 {0.105, -0.059, 0.062, -0.065, 0.065, 2.1},
                                 {0.125, -0.0585, 0.0605, -0.0635, 0.0635, 2},
                                 {0.145, -0.058, 0.059, -0.061, 0.061, 2},
                                 {0.164, -0.057, 0.057, -0.0575, 0.0575, 2},
                                 {0.168, -0.056, 0.056, -0.056, 0.056, 2}});
  const SurfaceMesh upper = DishedDisc(0.0591, 0.068, 0.0826);
  const SurfaceMesh lower = TurnedOver(DishedDisc(0.0591, 0.071, 0.0856));
  return {PieceOf(kCharcoal, {mesh::Extrusion(cheek, 0.0157, 0.0700, 0.002, 1),
                              mesh::Extrusion(cheek, -0.0730, -0.0317, 0.002, 1), stub}),
          PieceOf(kRubberBlack, {upper, lower})};
}

LinkLook WristLook() {
  const auto rounded = [](double x_min, double x_max, double half_y, double radius) {
    return mesh::RoundedOutline(
        {{x_min, -half_y}, {x_max, -half_y}, {x_max, half_y}, {x_min, half_y}}, radius, 5);
  };
  const SurfaceMesh cuff =
      mesh::Extrusion(rounded(-0.038, 0.054, 0.0385, 0.030), 0.0565, 0.1100, 0.003, 1);
  const SurfaceMesh pod =
      mesh::Extrusion(rounded(0.023, 0.055, 0.037, 0.010), 0.100, 0.1390, 0.005, 1);
  const RigidTransform X_Lens(Vector3(0.038, 0.012, 0.1385)), X_Window(Vector3(0.038, -0.018, 0));
  return {
      PieceOf(kPale, {mesh::Lathe({{0.0565, 0.0535}, {0.0565, 0.0570}}, kDiscSides),
                      mesh::Placed(X_Lens, mesh::Lathe({{0.0075, 0}, {0.0075, 0.0012}}, 16))}),
      PieceOf(kRubberBlack,
              {cuff, pod, mesh::Placed(X_Lens, mesh::Lathe({{0.0055, 0}, {0.0055, 0.0018}}, 16))}),
      PieceOf(kSteel,
              {mesh::Placed(X_Window, mesh::Extrusion(mesh::StadiumOutline(0.014, 0.007, 16), 0.13,
                                                      0.1396))})};
}

}  // namespace smile::robot::internal
