#include "task/symmetry.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/overloaded.h"
#include "scene/solid.h"

namespace smile::task {
namespace {

/// Polygons with at least this many sides look round.
constexpr int kRoundSides = 24;
/// Largest deviation at which two pieces coincide [m, and for entries of rotation matrices].
constexpr double kSamePlace = 1e-5;
/// Limits of work. Objects beyond them count as having no symmetry.
constexpr std::size_t kMaxPieces = 200, kMaxHullCorners = 200;
/// Largest tilt between two orientations that counts as standing alike [rad]; a little more than
/// the tolerance of 15 degrees (kAngleTolerance), so that no orientation within tolerance is lost.
constexpr double kSameStand = 0.27;

/// Returns the 24 rotations of a cube: those that map coordinate axes to coordinate axes.
std::vector<Matrix3> QuarterTurns() {
  std::vector<Matrix3> turns;
  for (int x = 0; x < 3; ++x) {
    for (int y = 0; y < 3; ++y) {
      if (x == y) continue;
      // Columns 0 and 1 are free choices of axis and sign; the third follows, as determinants are
      // +1.
      for (int signs = 0; signs < 4; ++signs) {
        Matrix3 turn = Matrix3::Zero();
        turn(x, 0) = signs % 2 == 0 ? 1 : -1;
        turn(y, 1) = signs / 2 == 0 ? 1 : -1;
        turn.col(2) = turn.col(0).cross(turn.col(1));
        turns.push_back(turn);
      }
    }
  }
  return turns;
}

Matrix3 TurnAboutZ(double angle) {
  return Eigen::AngleAxisd(angle, Vector3::UnitZ()).toRotationMatrix();
}

bool FillTheSame(const scene::Block& a, const scene::Block& b, const RigidTransform& X_AB) {
  // |R| must be a permutation matrix, so that the axes are parallel; it permutes the sizes.
  const Matrix3 R = X_AB.rotation().cwiseAbs();
  return ((R.array() < kSamePlace) || (R.array() > 1 - kSamePlace)).all() &&
         (R * b.size - a.size).norm() < kSamePlace;
}

/// The axis of a cylinder is y; either direction will do.
bool FillTheSame(const scene::Cylinder& a, const scene::Cylinder& b, const RigidTransform& X_AB) {
  return std::abs(X_AB.rotation()(1, 1)) > 1 - kSamePlace &&
         std::abs(a.radius - b.radius) + std::abs(a.length - b.length) < kSamePlace;
}

bool FillTheSame(const scene::Sphere& a, const scene::Sphere& b, const RigidTransform&) {
  return std::abs(a.radius - b.radius) < kSamePlace;
}

/// The corners must coincide in any order; faces follow from the corners, as hulls are convex.
bool FillTheSame(const scene::Hull& a, const scene::Hull& b, const RigidTransform& X_AB) {
  const std::vector<Vector3>& corners = a.polyhedron().corners;
  if (corners.size() != b.polyhedron().corners.size() || corners.size() > kMaxHullCorners) {
    return false;
  }
  return std::ranges::all_of(b.polyhedron().corners, [&](const Vector3& p_BQ) {
    const Vector3 p_AQ = X_AB * p_BQ;
    return std::ranges::any_of(
        corners, [&](const Vector3& corner) { return (corner - p_AQ).norm() < kSamePlace; });
  });
}

/// Shapes of different or other kinds never coincide.
template <class A, class B>
bool FillTheSame(const A&, const B&, const RigidTransform&) {
  return false;
}

/// Returns true if a piece, moved by the rotation `turn` of the body, coincides with another piece
/// of the same color, control and variant.
bool ComesTo(const scene::Solid& moved, const RigidTransform& turn, const scene::Solid& other) {
  if (moved.color != other.color || moved.control != other.control ||
      moved.variant != other.variant) {
    return false;
  }
  const RigidTransform X = other.X_BS.inverse() * (turn * moved.X_BS);
  // Corners of hulls are compared in place, so that the origins of their frames do not matter.
  const bool is_hull = std::holds_alternative<scene::Hull>(moved.shape);
  if (!is_hull && X.translation().norm() > kSamePlace) return false;
  return std::visit([&](const auto& a, const auto& b) { return FillTheSame(a, b, X); }, other.shape,
                    moved.shape);
}

/// Returns true if each piece of the body, rotated, coincides with some piece.
bool IsUnchangedBy(const std::vector<scene::Solid>& solids, const Matrix3& turn) {
  const RigidTransform X(turn, Vector3::Zero());
  return std::ranges::all_of(solids, [&](const scene::Solid& moved) {
    return std::ranges::any_of(solids,
                               [&](const scene::Solid& other) { return ComesTo(moved, X, other); });
  });
}

/// Returns those of the 24 rotations under which the body looks the same.
Symmetry TriedSymmetry(const scene::Part& whole) {
  Symmetry symmetry;
  if (scene::NumSolidsOf(whole) > kMaxPieces) return symmetry;
  const std::vector<scene::Solid> solids = scene::SolidsOf(whole);
  symmetry.turns.clear();
  for (const Matrix3& turn : QuarterTurns()) {
    if (IsUnchangedBy(solids, turn)) symmetry.turns.push_back(turn);
  }
  return symmetry;
}

/// Returns the symmetry of a block of the same size, restricted to rotations that keep the opening
/// (+z) up.
Symmetry ContainerSymmetry(const scene::Box& box) {
  Symmetry symmetry = TriedSymmetry({.shape = scene::Block{box.size}});
  std::erase_if(symmetry.turns, [](const Matrix3& turn) { return turn(2, 2) < 0.5; });
  return symmetry;
}

/// Returns the symmetry of a regular polygon with its first corner at +x, extruded along z.
Symmetry PrismSymmetry(int sides, bool is_reversible) {
  Symmetry symmetry{.axis = {}, .turns = {}};
  // A half turn about x maps the polygon onto itself, because it has a corner on x, and exchanges
  // top and bottom.
  const Matrix3 reversal = Vector3(1, -1, -1).asDiagonal();
  for (int i = 0; i < sides; ++i) {
    const Matrix3 turn = TurnAboutZ(2 * std::numbers::pi * i / sides);
    symmetry.turns.push_back(turn);
    if (is_reversible) symmetry.turns.emplace_back(turn * reversal);
  }
  return symmetry;
}

/// Round part of a body B: a sphere, or a solid of revolution.
struct RoundPart {
  Vector3 p_BC = Vector3::Zero();  ///< its center
  std::optional<Vector3> axis;     ///< in B; nullopt: a sphere
  /// Radii at the ends of the axis, at its start first, and of the hole; length [m].
  double radius_start = 0, radius_end = 0, radius_hole = 0, length = 0;
  Color color;

  /// Returns true if the other part looks the same after a reversal of the axis.
  bool IsReversalOf(const RoundPart& other, const Vector3& axis_of_body) const {
    const bool is_along = !axis || axis->dot(*other.axis) > 0;
    const double start = is_along ? other.radius_end : other.radius_start;
    const double end = is_along ? other.radius_start : other.radius_end;
    return axis.has_value() == other.axis.has_value() && color == other.color &&
           std::abs(axis_of_body.dot(p_BC + other.p_BC)) < kSamePlace &&
           std::abs(radius_start - start) + std::abs(radius_end - end) < kSamePlace &&
           std::abs(radius_hole - other.radius_hole) + std::abs(length - other.length) < kSamePlace;
  }
};

/// Returns the round part that a simple shape is; nullopt if it is not round.
std::optional<RoundPart> RoundPartOf(const scene::Part& part, const RigidTransform& X_BE) {
  RoundPart round{.p_BC = X_BE.translation(), .axis = {}, .color = part.color};
  const auto set = [&](int axis, double start, double end, double hole, double length) {
    round.axis = X_BE.rotation().col(axis);
    round.radius_start = start;
    round.radius_end = end;
    round.radius_hole = hole;
    round.length = length;
    return true;
  };
  // The axis of a cylinder is y; those of frustums and rings are z.
  const bool is_round = std::visit(
      Overloaded{[&](const scene::Sphere& sphere) {
                   round.radius_start = round.radius_end = sphere.radius;
                   return true;
                 },
                 [&](const scene::Cylinder& c) { return set(1, c.radius, c.radius, 0, c.length); },
                 [&](const scene::Frustum& f) {
                   return f.sides >= kRoundSides &&
                          set(2, f.radius_bottom, f.radius_top, 0, f.height);
                 },
                 [&](const scene::Ring& ring) {
                   return ring.sides >= kRoundSides && set(2, ring.radius_outer, ring.radius_outer,
                                                           ring.radius_inner, ring.height);
                 },
                 [](const auto&) { return false; }},
      part.shape);
  return is_round ? std::optional(round) : std::nullopt;
}

/// Appends the simple parts of an element E; returns false if one is not round, or if there are
/// too many.
bool AppendRoundParts(const scene::Part& part, const RigidTransform& X_BE,
                      std::vector<RoundPart>* parts) {
  if (const auto* composite = std::get_if<scene::Composite>(&part.shape)) {
    return std::ranges::all_of(composite->parts, [&](const scene::Part& child) {
      return AppendRoundParts(child, X_BE * child.X_PE, parts);
    });
  }
  const std::optional<RoundPart> round = RoundPartOf(part, X_BE);
  if (round) parts->push_back(*round);
  return round && parts->size() <= kMaxPieces;
}

/// Returns the symmetry of a body whose parts are all round, about one axis through its origin;
/// nullopt for other bodies.
std::optional<Symmetry> RoundSymmetry(const scene::Part& whole) {
  std::vector<RoundPart> parts;
  if (!AppendRoundParts(whole, RigidTransform(), &parts) || parts.empty()) return std::nullopt;
  // A part off the origin determines the axis, and so does one that is not a sphere.
  std::optional<Vector3> axis;
  for (const RoundPart& part : parts) {
    if (axis) break;
    if (part.axis) axis = part.axis;
    if (part.p_BC.norm() > kSamePlace) axis = part.p_BC.normalized();
  }
  if (!axis) return Symmetry{.is_sphere = true, .axis = {}, .turns = {}};
  const auto is_about_axis = [&](const RoundPart& part) {
    return axis->cross(part.p_BC).norm() < kSamePlace &&
           (!part.axis || axis->cross(*part.axis).norm() < kSamePlace);
  };
  if (!std::ranges::all_of(parts, is_about_axis)) return std::nullopt;
  const bool is_reversible = std::ranges::all_of(parts, [&](const RoundPart& part) {
    return std::ranges::any_of(
        parts, [&](const RoundPart& other) { return part.IsReversalOf(other, *axis); });
  });
  return Symmetry{.axis = axis, .is_reversible = is_reversible, .turns = {}};
}

/// Returns the rotation angle of R, within [0, pi] [rad].
double AngleOf(const Matrix3& R) { return std::acos(std::clamp((R.trace() - 1) / 2, -1.0, 1.0)); }

/// Returns the angle between the vertical and its image under R [rad]; turns about the vertical do
/// not change it.
double TiltOf(const Matrix3& R) { return std::acos(std::clamp(R(2, 2), -1.0, 1.0)); }

/// Returns the angle of the turn about z that is nearest to R: it maximizes trace(Rz(angle)^T R)
/// [rad].
double NearestYawOf(const Matrix3& R) { return std::atan2(R(1, 0) - R(0, 1), R(0, 0) + R(1, 1)); }

/// Returns the angle between two vectors [rad]; atan2 stays exact near 0 and pi, where acos does
/// not.
double AngleOf(const Vector3& a, const Vector3& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

}  // namespace

double Symmetry::AngleBetween(const Matrix3& R_WA, const Matrix3& R_WB) const {
  if (is_sphere) return 0;
  if (axis) {
    const double angle = AngleOf(Vector3(R_WA * *axis), Vector3(R_WB * *axis));
    return is_reversible ? std::min(angle, std::numbers::pi - angle) : angle;
  }
  // Equivalent orientations of B are R_WB * turn; the nearest one counts.
  double least = std::numbers::pi;
  for (const Matrix3& turn : turns) {
    least = std::min(least, AngleOf(Matrix3(R_WA.transpose() * R_WB * turn)));
  }
  return least;
}

double Symmetry::TiltBetween(const Matrix3& R_WA, const Matrix3& R_WB) const {
  if (is_sphere) return 0;
  if (axis) {
    // Up to a turn about the vertical, only the inclination of the axis matters.
    const double a = AngleOf(Vector3(R_WA * *axis), Vector3::UnitZ());
    const double b = AngleOf(Vector3(R_WB * *axis), Vector3::UnitZ());
    // 4 exceeds every angle, so that a body that is not reversible never uses it.
    const double reversed = is_reversible ? std::abs(a - (std::numbers::pi - b)) : 4;
    return std::min(std::abs(a - b), reversed);
  }
  double least = std::numbers::pi;
  for (const Matrix3& turn : turns) {
    least = std::min(least, TiltOf(Matrix3(R_WB * turn * R_WA.transpose())));
  }
  return least;
}

std::vector<double> Symmetry::YawsBetween(const Matrix3& R_WA, const Matrix3& R_WB) const {
  std::vector<double> yaws;
  if (is_sphere) return yaws;
  if (axis) {
    const Vector3 a = R_WA * *axis, b = R_WB * *axis;
    // With a vertical axis, a turn about the vertical changes nothing visible.
    if (std::abs(a.z()) > 1 - kSamePlace || std::abs(b.z()) > 1 - kSamePlace) return yaws;
    yaws.push_back(std::atan2(b.y(), b.x()) - std::atan2(a.y(), a.x()));
    if (is_reversible) yaws.push_back(yaws.back() + std::numbers::pi);
    return yaws;
  }
  for (const Matrix3& turn : turns) {
    const Matrix3 R = R_WB * turn * R_WA.transpose();
    if (TiltOf(R) < kSameStand) yaws.push_back(NearestYawOf(R));
  }
  return yaws;
}

Symmetry SymmetryOf(const scene::ObjectSpec& object) {
  if (const std::optional<Symmetry> round = RoundSymmetry(object.whole)) return *round;
  return std::visit(
      Overloaded{[](const scene::Frustum& frustum) {
                   return PrismSymmetry(frustum.sides, frustum.radius_top == frustum.radius_bottom);
                 },
                 [](const scene::Box& box) { return ContainerSymmetry(box); },
                 [](const scene::Ring& ring) { return PrismSymmetry(ring.sides, true); },
                 [&](const auto&) { return TriedSymmetry(object.whole); }},
      object.whole.shape);
}

}  // namespace smile::task
