#include "picture/hand_anatomy.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>

#include "mesh/modeling.h"

// The shape of the demonstrator's arms and how they bend. A hand has a frame H with its origin in
// the grip (see the header). Posture is given by where fingertips are; all joint angles follow by
// inverse kinematics.

namespace smile::picture {
namespace {

constexpr int kAround = 20;  ///< corners of round sections

/// Thumb or finger: three bones from its first joint on.
struct Digit {
  Vector3 p_HRoot;  ///< of a right hand
  std::array<double, 3> lengths;
  std::array<double, 4> radii;  ///< at the joints and the tip
  double tip_y;                 ///< y of its contact in a grip
};

/// Thumb, index, middle, ring and little finger of a right hand [m]; lengths are of an average man.
const std::array<Digit, kDigits>& Digits() {
  static const std::array<Digit, kDigits> kAll{{
      {{-0.058, 0.024, 0.074}, {0.044, 0.034, 0.024}, {0.0155, 0.012, 0.0105, 0.0085}, 0.010},
      {{0.022, 0.030, 0.074}, {0.046, 0.027, 0.019}, {0.0105, 0.0095, 0.0085, 0.0072}, 0.020},
      {{0.027, 0.010, 0.077}, {0.050, 0.030, 0.020}, {0.0108, 0.0098, 0.0088, 0.0075}, 0.003},
      {{0.023, -0.010, 0.075}, {0.046, 0.028, 0.020}, {0.0103, 0.0093, 0.0083, 0.0070}, -0.013},
      {{0.013, -0.029, 0.070}, {0.037, 0.022, 0.018}, {0.0092, 0.0082, 0.0072, 0.0062}, -0.027},
  }};
  return kAll;
}

const Vector3 kWrist(-0.078, 0, 0.082);              ///< in the hand's frame H
constexpr double kForearm = 0.40, kUpperArm = 0.45;  ///< from joint to joint [m]

/// Returns a point for this side: left hands mirror right hands.
Vector3 OfSide(HandSide side, Vector3 p) {
  if (side == HandSide::kLeft) p.y() = -p.y();
  return p;
}

/// Returns a frame at a point with its z axis along a direction, and its x axis as near as possible
/// to `x_hint`.
RigidTransform FrameAlong(const Vector3& p, const Vector3& z_direction, const Vector3& x_hint) {
  Matrix3 R;
  R.col(2) = z_direction.normalized();
  R.col(1) = R.col(2).cross(x_hint).normalized();
  R.col(0) = R.col(1).cross(R.col(2));
  return {R, p};
}

/// Returns a tapered rod along z from the origin, with hemispherical ends.
scene::SurfaceMesh Bone(double length, double radius_at_0, double radius_at_end) {
  constexpr int kSteps = 5;
  // Radius and height along the rod, from tip to tip: a quarter circle, the cone between, and
  // another quarter circle.
  std::vector<Eigen::Vector2d> profile;
  for (int k = 0; k <= kSteps; ++k) {
    const double angle = std::numbers::pi / 2 * k / kSteps;
    profile.emplace_back(k == 0 ? 0 : radius_at_0 * std::sin(angle),
                         -radius_at_0 * std::cos(angle));
  }
  for (int k = kSteps; k >= 0; --k) {
    const double angle = std::numbers::pi / 2 * k / kSteps;
    profile.emplace_back(k == 0 ? 0 : radius_at_end * std::sin(angle),
                         length + radius_at_end * std::cos(angle));
  }
  return mesh::Lathe(profile, kAround);
}

/// Returns a cross section of a limb: a superellipse with these diameters along x and y [m].
mesh::Cut Across(double z, double width, double thickness, double exponent = 2.3) {
  return {.z = z,
          .x_min = -width / 2,
          .x_max = width / 2,
          .y_min = -thickness / 2,
          .y_max = thickness / 2,
          .exponent = exponent};
}

/// Returns the palm, from the wrist along z to the knuckles; its width is along x, the thumb's side
/// at +x.
scene::SurfaceMesh Palm() {
  std::vector<mesh::Cut> cuts{
      Across(-0.024, 0.030, 0.020), Across(-0.018, 0.046, 0.032), Across(0.000, 0.053, 0.037),
      Across(0.020, 0.064, 0.037),  Across(0.045, 0.076, 0.034),  Across(0.070, 0.081, 0.029),
      Across(0.092, 0.080, 0.024),  Across(0.102, 0.074, 0.018),  Across(0.107, 0.060, 0.010)};
  // The ball of the thumb.
  cuts[3].x_max += 0.006;
  cuts[4].x_max += 0.004;
  // The little finger's knuckle is behind the others.
  for (std::size_t k = 7; k < cuts.size(); ++k) cuts[k].x_min += 0.008;
  return mesh::Loft(cuts, 2 * kAround);
}

/// Returns the forearm, from the wrist along z to the elbow.
scene::SurfaceMesh BareForearm() {
  return mesh::Loft(
      {Across(-0.022, 0.026, 0.018), Across(-0.016, 0.044, 0.032), Across(0.000, 0.053, 0.038),
       Across(0.030, 0.053, 0.040), Across(0.100, 0.064, 0.053), Across(0.200, 0.080, 0.072),
       Across(0.260, 0.082, 0.076), Across(0.270, 0.060, 0.056)},
      2 * kAround);
}

/// Returns the sleeve over the upper part of the forearm and the elbow, in the forearm's frame.
scene::SurfaceMesh Sleeve() {
  return mesh::Loft(
      {Across(0.158, 0.078, 0.070), Across(0.160, 0.088, 0.081), Across(0.166, 0.092, 0.085),
       Across(0.186, 0.091, 0.084), Across(0.189, 0.087, 0.080), Across(0.280, 0.098, 0.092),
       Across(0.360, 0.104, 0.100), Across(0.400, 0.104, 0.102), Across(0.430, 0.088, 0.086),
       Across(0.447, 0.050, 0.050)},
      2 * kAround);
}

/// Returns the joints and the tip of a digit that reaches for a point, bent away from the palm:
/// planar inverse kinematics with one unknown, the bend of the middle joint.
std::array<Vector3, 4> BentTo(const Vector3& root, const std::array<double, 3>& lengths,
                              const Vector3& tip, const Vector3& outward) {
  // The last joint bends 0.7 times as far as the one before.
  constexpr double kFollows = 0.7, kMost = 1.9;
  const auto chain = [&](double bend) {
    std::array<Eigen::Vector2d, 4> points;
    points[0].setZero();
    const std::array<double, 3> turns{0, bend, (1 + kFollows) * bend};
    for (std::size_t k = 0; k < 3; ++k) {
      points[k + 1] =
          points[k] + lengths[k] * Eigen::Vector2d(std::cos(turns[k]), -std::sin(turns[k]));
    }
    return points;
  };
  const double distance = (tip - root).norm();
  // Bisection: the distance from root to tip decreases as the bend grows. Points out of reach get a
  // straight or fully bent digit in their direction.
  double low = 0, high = kMost;
  for (int k = 0; k < 40; ++k) {
    const double middle = (low + high) / 2;
    (chain(middle)[3].norm() > distance ? low : high) = middle;
  }
  const std::array<Eigen::Vector2d, 4> points = chain(low);
  // Rotates the planar chain so that its tip lies on the line to the target.
  const Eigen::Vector2d along = points[3].normalized();
  const Vector3 e1 = (tip - root).normalized();
  const Vector3 e2 = (outward - outward.dot(e1) * e1).normalized();
  std::array<Vector3, 4> joints;
  for (std::size_t k = 0; k < 4; ++k) {
    const double x = points[k].dot(along);
    const double y = along.x() * points[k].y() - along.y() * points[k].x();
    joints[k] = root + x * e1 + y * e2;
  }
  return joints;
}

/// Returns the center of a fingertip of a right hand that grips, in H.
Vector3 GripTip(std::size_t digit, const HandPosture& posture) {
  const double at = posture.reach[digit] + Digits()[digit].radii[3];
  return GripLine(HandSide::kRight, digit) + Vector3(digit == 0 ? -at : at, 0, 0);
}

/// Returns the center of a fingertip of a right hand that points, in H.
Vector3 PointingTip(std::size_t digit) {
  switch (digit) {
    case 0:
      return {0.008, 0.006, 0.040};
    case 1:
      return {0.090, 0.028, 0.016};
    default:
      return {0.004, Digits()[digit].tip_y * 0.8, 0.044};
  }
}

/// Returns the fingertip of a right hand between gripping and pointing.
Vector3 TipOf(std::size_t digit, const HandPosture& posture) {
  return (1 - posture.pointing) * GripTip(digit, posture) + posture.pointing * PointingTip(digit);
}

}  // namespace

Vector3 GripLine(HandSide side, std::size_t digit) {
  // The little finger is short.
  constexpr std::array<double, kDigits> kHeights{0, 0, 0, 0.002, 0.010};
  return OfSide(side, {0, Digits()[digit].tip_y, kHeights[digit]});
}

Vector3 IndexTip(HandSide side) { return OfSide(side, PointingTip(1)); }

std::array<Vector3, kDigits> FingertipsInHand(HandSide side, const HandPosture& posture) {
  std::array<Vector3, kDigits> tips;
  for (std::size_t k = 0; k < tips.size(); ++k) tips[k] = OfSide(side, TipOf(k, posture));
  return tips;
}

std::vector<ArmPiece> PiecesOf(HandSide side) {
  std::vector<ArmPiece> pieces;
  const auto add = [&](scene::SurfaceMesh surface, bool is_sleeve = false) {
    auto mesh = std::make_shared<scene::CustomMesh>();
    mesh->surface = std::move(surface);
    pieces.push_back({.mesh = {.mesh = std::move(mesh)}, .is_sleeve = is_sleeve});
  };
  // The palm's frame has x towards the thumb. Mirroring x is mirroring y after a half turn about z.
  scene::SurfaceMesh palm = Palm();
  if (side == HandSide::kLeft) {
    const Matrix3 half_turn = Eigen::AngleAxisd(std::numbers::pi, Vector3::UnitZ()).matrix();
    palm = mesh::Mirrored(mesh::Placed({half_turn, Vector3::Zero()}, std::move(palm)));
  }
  add(std::move(palm));
  for (const Digit& digit : Digits()) {
    for (std::size_t k = 0; k < 3; ++k) {
      add(Bone(digit.lengths[k], digit.radii[k], digit.radii[k + 1]));
    }
  }
  add(BareForearm());
  add(Sleeve(), true);
  add(Bone(kUpperArm, 0.050, 0.068), true);
  return pieces;
}

Vector3 ShoulderAt(HandSide side, double table_edge) {
  return {side == HandSide::kLeft ? 0.19 : -0.19, table_edge + 0.25, 0.46};
}

std::array<RigidTransform, kArmPieces> PiecePoses(HandSide side, const HandPosture& posture,
                                                  double table_edge) {
  std::array<RigidTransform, kArmPieces> poses;
  const RigidTransform& X_WH = posture.X_WH;
  const auto to_thumb = OfSide(side, Vector3::UnitY());
  const Vector3 knuckles = (Digits()[2].p_HRoot + Digits()[3].p_HRoot) / 2;
  // The palm, from the wrist to the middle of the knuckles.
  poses[0] =
      X_WH * FrameAlong(kWrist, Vector3(knuckles.x(), 0, knuckles.z()) - kWrist, Vector3::UnitY());
  for (std::size_t digit = 0; digit < Digits().size(); ++digit) {
    const Digit& d = Digits()[digit];
    // The side to which the joints bend: away from the object and up.
    const Vector3 outward = digit == 0 ? Vector3(-1, 0.5, 0.2) : Vector3(1, 0, 1);
    const auto joints = BentTo(d.p_HRoot, d.lengths, TipOf(digit, posture), outward);
    for (std::size_t k = 0; k < 3; ++k) {
      const Vector3 from = OfSide(side, joints[k]), to = OfSide(side, joints[k + 1]);
      poses[1 + 3 * digit + k] = X_WH * FrameAlong(from, to - from, to_thumb);
    }
  }
  // Moves the shoulder horizontally towards the wrist until the arm, almost stretched, is long
  // enough.
  constexpr double kStretched = 0.985 * (kForearm + kUpperArm);
  const Vector3 wrist = X_WH * kWrist;
  Vector3 shoulder = ShoulderAt(side, table_edge);
  Vector3 back = shoulder - wrist;
  const double drop = std::clamp(back.z(), -0.8 * kStretched, 0.8 * kStretched);
  const double most_level = std::sqrt(kStretched * kStretched - drop * drop);
  const double level = std::max(std::hypot(back.x(), back.y()), 1e-6);
  const double share = std::min(1.0, most_level / level);
  shoulder = wrist + Vector3(back.x() * share, back.y() * share, drop);
  back = shoulder - wrist;
  // Two-bone inverse kinematics: the distances determine the elbow up to a rotation about the line
  // from wrist to shoulder; it hangs down and outward. `along` follows from the law of cosines.
  const double reach = std::clamp(back.norm(), 0.2, kForearm + kUpperArm);
  const double along = (reach * reach + kForearm * kForearm - kUpperArm * kUpperArm) / (2 * reach);
  const double aside = std::sqrt(std::max(0.0, kForearm * kForearm - along * along));
  const Vector3 e1 = back.normalized();
  const Vector3 hang(side == HandSide::kLeft ? 0.8 : -0.8, 0, -0.6);
  const Vector3 e2 = (hang - hang.dot(e1) * e1).normalized();
  const Vector3 elbow = wrist + along * e1 + aside * e2;
  const Vector3 across = X_WH.rotation().col(1);
  poses[kHandPieces] = FrameAlong(wrist, elbow - wrist, across);
  poses[kHandPieces + 1] = poses[kHandPieces];
  poses[kHandPieces + 2] = FrameAlong(elbow, shoulder - elbow, across);
  return poses;
}

}  // namespace smile::picture
