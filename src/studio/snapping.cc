#include "studio/snapping.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "math/angles.h"
#include "studio/rail_drag.h"

// Snapping collects wishes: displacements that would make a carried object touch or be flush with a
// neighbor, or lie on the grid. Of these, the nearest one and one at right angles to it are
// granted, within the plane in which the object is dragged. All neighbors are treated as boxes.

namespace smile::studio {
namespace {

/// Largest distance of a neighbor whose axes a rotated object may align with [units].
constexpr double kNearUnits = 2;
/// Cosine of 2.6 degrees, from the vertical; and of 87.7 degrees, so nearly horizontal.
constexpr double kUpright = 0.999, kLevel = 0.04;

/// Combines wishes for displacements within a plane: the nearest one along one direction, and one
/// along a direction at right angles to it. Together they place a corner.
class Shift {
 public:
  Shift(const Vector3& plane_normal, double limit) : plane_normal_(plane_normal), limit_(limit) {}

  /// Adds a wish for a displacement by `distance` along `normal`. In the drag plane this is a
  /// displacement by distance / share along the normal's projection. Ignored if it is too far, if
  /// the plane is nearly parallel to the face, or if the face is inclined.
  void Consider(const Vector3& normal, double distance) {
    // Cosines: the face's normal must be within 2.6 degrees of vertical or 2.3 degrees of
    // horizontal, and within 60 degrees of the plane, or the displacement would be more than twice
    // the distance.
    constexpr double kAcross = 0.5;
    const double height = std::abs(normal.z());
    if (height > kLevel && height < kUpright) return;
    // Projected onto the plane.
    const Vector3 within = normal - plane_normal_.dot(normal) * plane_normal_;
    const double share = within.norm();
    if (share < kAcross || !(std::abs(distance / share) <= limit_)) return;
    wishes_.push_back({.direction = within / share, .distance = distance / share});
  }

  /// Grants the nearest wishes that are perpendicular to all granted ones, and forgets the rest.
  void Grant() {
    // Stable, so that equal wishes are granted in the order of the scene.
    std::ranges::stable_sort(wishes_, {}, &Wish::size);
    for (const Wish& wish : std::exchange(wishes_, {})) {
      const auto leaves_alone = [&wish](const Wish& granted) {
        constexpr double kAcross = 0.04;  // cosine of 88 degrees
        return std::abs(granted.direction.dot(wish.direction)) < kAcross;
      };
      if (std::ranges::all_of(granted_, leaves_alone)) granted_.push_back(wish);
    }
  }

  /// Returns the sum of the granted displacements; only the smallest of them if the sum is too far.
  Vector3 Get() const {
    Vector3 shift = Vector3::Zero();
    for (const Wish& wish : granted_) shift += wish.vector();
    if (shift.norm() <= limit_) return shift;
    // The sum can be longer than each of its parts; the limit is what users were promised.
    return std::ranges::min(granted_, {}, &Wish::size).vector();
  }

 private:
  struct Wish {
    Vector3 direction;  ///< within the plane, of length 1
    double distance;
    double size() const { return std::abs(distance); }
    Vector3 vector() const { return distance * direction; }
  };

  Vector3 plane_normal_;
  double limit_;
  std::vector<Wish> wishes_, granted_;
};

/// True if the axes of both are parallel, in any order.
bool IsTurnedAlike(const Matrix3& R_NB) {
  constexpr double kAlike = 0.9994;  // cosine of 2 degrees
  // Each axis of B is near some axis of N if its largest component is near 1.
  return (R_NB.cwiseAbs().colwise().maxCoeff().array() > kAlike).all();
}

/// Adds the wishes of one neighbor N: faces that touch, edges and centers that are flush.
void ConsiderNeighbour(const SnapTo& snap, const Carried& carried, const Neighbour& neighbour,
                       double limit, Shift* shift) {
  // In N's frame, both are axis-aligned boxes: half sizes and the distance of centers say
  // everything.
  const RigidTransform X_NB = neighbour.X_WB.inverse() * carried.X_WB;
  if (!IsTurnedAlike(X_NB.rotation())) return;
  // Half sizes along N's axes: the absolute values permute them, as the axes are parallel.
  const Vector3 half = X_NB.rotation().cwiseAbs() * (carried.bounds.size() / 2);
  const Vector3 half_N = neighbour.bounds.size() / 2;
  const Vector3 apart = neighbour.bounds.center() - X_NB * carried.bounds.center();
  const auto is_beside = [&](int axis) {
    return std::abs(apart[axis]) < half[axis] + half_N[axis] + limit;
  };
  // What is held over a neighbor, at any height, will be let down on it or beside it.
  const auto will_be_beside = [&](int axis) {
    const double up = neighbour.X_WB.rotation()(2, axis);
    return is_beside(axis) || (std::abs(up) > kUpright && up * apart[axis] < 0);
  };
  for (int axis = 0; axis < 3; ++axis) {
    // Faces can touch only if the boxes overlap, or nearly do, in the other two directions.
    if (!will_be_beside((axis + 1) % 3) || !will_be_beside((axis + 2) % 3)) continue;
    const Vector3 normal = neighbour.X_WB.rotation().col(axis);
    const double touching = half[axis] + half_N[axis], flush = half_N[axis] - half[axis];
    if (snap.faces) {
      // On either side: the carried box before or behind the neighbor along this axis.
      shift->Consider(normal, apart[axis] - touching);
      shift->Consider(normal, apart[axis] + touching);
    }
    if (snap.edges && is_beside(axis)) {
      // Equal lower faces, equal centers, equal upper faces.
      shift->Consider(normal, apart[axis] - flush);
      shift->Consider(normal, apart[axis]);
      shift->Consider(normal, apart[axis] + flush);
    }
  }
}

/// Adds the wish to be in the middle between the faces to both sides along a level axis of the
/// carried object: those of what it is beside, or will be once it is let down.
void ConsiderGap(const Carried& carried, int axis, std::span<const Neighbour> pieces,
                 double most_room, Shift* shift) {
  const int across = (axis + 1) % 3, other = (axis + 2) % 3;
  const Vector3 half = carried.bounds.size() / 2;
  const Vector3 p_WC = carried.X_WB * carried.bounds.center();
  const RigidTransform X_CW = RigidTransform(carried.X_WB.rotation(), p_WC).inverse();
  double low = -std::numeric_limits<double>::infinity(), high = -low;
  for (const Neighbour& piece : pieces) {
    const RigidTransform X_CN = X_CW * piece.X_WB;
    if (!IsTurnedAlike(X_CN.rotation())) continue;
    const Vector3 half_N = X_CN.rotation().cwiseAbs() * (piece.bounds.size() / 2);
    const Vector3 center_N = X_CN * piece.bounds.center();
    const auto is_beside = [&](int k) {
      const double up = carried.X_WB.rotation()(2, k);
      const bool is_below = std::abs(up) > kUpright && up * center_N[k] < 0;
      return is_below || std::abs(center_N[k]) < half[k] + half_N[k];
    };
    if (!is_beside(across) || !is_beside(other)) continue;
    // What is below the middle is a floor, and no side.
    const double near_low = center_N[axis] + half_N[axis],
                 near_high = center_N[axis] - half_N[axis];
    if (near_low <= 0) low = std::max(low, near_low);
    if (near_high >= 0) high = std::min(high, near_high);
  }
  constexpr double kRounding = 1e-4;  // [m]
  const double room = high - low - 2 * half[axis];
  if (room < -kRounding || !(room <= most_room)) return;
  shift->Consider(carried.X_WB.rotation().col(axis), (low + high) / 2);
}

void ConsiderGrid(const Vector3& p_WB, double spacing, Shift* shift) {
  for (int axis = 0; axis < 3; ++axis) {
    shift->Consider(Vector3::Unit(axis), std::round(p_WB[axis] / spacing) * spacing - p_WB[axis]);
  }
}

double DegreesBetween(const Matrix3& a, const Matrix3& b) {
  return RadiansToDegrees(Eigen::AngleAxisd(Matrix3(a.transpose() * b)).angle());
}

/// Returns the rotation with axes along the world's that is near R: greedy choice of the dominant
/// axis for x, then for y.
Matrix3 NearestRightAngle(const Matrix3& R) {
  Eigen::Index first = 0, second = 0;
  R.col(0).cwiseAbs().maxCoeff(&first);
  Vector3 rest = R.col(1);
  rest[first] = 0;
  rest.cwiseAbs().maxCoeff(&second);
  const Vector3 x = Vector3::Unit(first) * std::copysign(1, R(first, 0));
  const Vector3 y = Vector3::Unit(second) * std::copysign(1, R(second, 1));
  Matrix3 nearest;
  nearest << x, y, x.cross(y);
  return nearest;
}

/// Returns all present objects except the one that the hand holds.
std::vector<const world::Object*> OthersThan(physics::BodyId held, const LiveWorld& world) {
  const world::Tabletop& tabletop = world.simulation().tabletop();
  std::vector<const world::Object*> others;
  for (const world::Object& object : tabletop.objects()) {
    if (object.body != held && tabletop.IsPresent(object)) others.push_back(&object);
  }
  return others;
}

RigidTransform PoseOf(const world::Object& object, const LiveWorld& world) {
  return world.simulation().physics().body(object.body).pose_in_world();
}

/// Returns the boxes around these.
std::vector<Neighbour> ObjectsBeside(const LiveWorld& world, physics::BodyId held) {
  std::vector<Neighbour> neighbours;
  for (const world::Object* object : OthersThan(held, world)) {
    const scene::Bounds& bounds = world.bounds()[object->index];
    if (bounds.is_empty()) continue;
    neighbours.push_back({.bounds = bounds, .X_WB = PoseOf(*object, world)});
  }
  return neighbours;
}

/// Returns the boxes around their pieces.
std::vector<Neighbour> PiecesBeside(const LiveWorld& world, physics::BodyId held) {
  std::vector<Neighbour> pieces;
  for (const world::Object* object : OthersThan(held, world)) {
    for (const scene::Solid& solid : world.solids()[object->index]) {
      pieces.push_back({.bounds = scene::BoundsOf(solid.shape, RigidTransform()),
                        .X_WB = PoseOf(*object, world) * solid.X_BS});
    }
  }
  return pieces;
}

/// Returns the same objects and the table.
std::vector<Neighbour> NeighboursOf(const LiveWorld& world, physics::BodyId held) {
  const scene::TableSpec& table = world.simulation().scene().table;
  const Vector3 half(table.x_span / 2, table.y_span / 2, 0);
  std::vector<Neighbour> neighbours = ObjectsBeside(world, held);
  neighbours.push_back(
      {.bounds = {.low = -half - Vector3(0, 0, table.thickness), .high = half}, .X_WB = {}});
  return neighbours;
}

/// Returns the rotations of the table and of the object nearest to the one that a hand rotates.
std::vector<Matrix3> FramesNear(const LiveWorld& world, const demonstrator::Hand& hand) {
  const Vector3 p_WB = hand.X_WB_goal.translation();
  std::vector<Matrix3> frames{Matrix3::Identity()};
  double least = kNearUnits * world.simulation().scene().meters_per_unit;
  std::optional<Matrix3> nearest;
  for (const Neighbour& neighbour : ObjectsBeside(world, hand.held)) {
    const Vector3 p_NB = neighbour.X_WB.inverse() * p_WB;
    // The point of the neighbor's box that is nearest to the held object's origin.
    const Vector3 within = p_NB.cwiseMax(neighbour.bounds.low).cwiseMin(neighbour.bounds.high);
    const double distance = (p_NB - within).norm();
    if (distance >= least) continue;
    least = distance;
    nearest = neighbour.X_WB.rotation();
  }
  if (nearest) frames.push_back(*nearest);
  return frames;
}

}  // namespace

SnapTo SnapToOf(std::span<const std::string> names) {
  const auto has = [&](std::string_view name) {
    return std::ranges::find(names, name) != names.end();
  };
  return {.rails = has("rails"),
          .faces = has("faces"),
          .edges = has("edges"),
          .grid = has("grid"),
          .angles = has("angles")};
}

std::vector<std::string> NamesOf(const SnapTo& snap) {
  std::vector<std::string> names;
  for (const auto& [is_on, name] : {std::pair(snap.rails, "rails"), std::pair(snap.faces, "faces"),
                                    std::pair(snap.edges, "edges"), std::pair(snap.grid, "grid"),
                                    std::pair(snap.angles, "angles")}) {
    if (is_on) names.emplace_back(name);
  }
  return names;
}

Vector3 SnapShift(const SnapTo& snap, const Carried& carried, std::span<const Neighbour> neighbours,
                  std::span<const Neighbour> pieces, double meters_per_unit) {
  const double limit = kSnapUnits * meters_per_unit;
  const double angle = DegreesToRadians(carried.plane_deg);
  // Normal of the plane of the drag: vertical for a level drag.
  Shift shift(carried.is_level ? Vector3::UnitZ() : Vector3(-std::sin(angle), std::cos(angle), 0),
              limit);
  for (const Neighbour& neighbour : neighbours) {
    ConsiderNeighbour(snap, carried, neighbour, limit, &shift);
  }
  for (int axis = 0; axis < 3 && snap.faces; ++axis) {
    // Up and down, it rests on something.
    if (std::abs(carried.X_WB.rotation()(2, axis)) > kLevel) continue;
    ConsiderGap(carried, axis, pieces, kGapUnits * meters_per_unit, &shift);
  }
  // Faces and edges have priority over the grid, which may fill a remaining direction.
  shift.Grant();
  if (snap.grid) ConsiderGrid(carried.X_WB.translation(), kGridUnits * meters_per_unit, &shift);
  shift.Grant();
  return shift.Get();
}

Matrix3 SnapTurn(const SnapTo& snap, const Matrix3& R_wanted, std::span<const Matrix3> frames) {
  if (!snap.angles) return R_wanted;
  Matrix3 R_snapped = R_wanted;
  double least = kSnapDegrees;
  for (const Matrix3& R_WF : frames) {
    // The nearest right angle as seen from frame F.
    const Matrix3 R_right = R_WF * NearestRightAngle(R_WF.transpose() * R_wanted);
    const double away = DegreesBetween(R_wanted, R_right);
    if (away >= least) continue;
    least = away;
    R_snapped = R_right;
  }
  return R_snapped;
}

std::optional<sim::MoveTo> Snapper::MoveOf(const LiveWorld& world, const sim::Drag& drag,
                                           sim::Refusal* refusal) const {
  if (to.rails) {
    // A rail needs no plane: the ray is enough.
    if (auto along = MoveAlongRail(drag, world.simulation())) return along;
  }
  const auto move = sim::MoveOf(drag, world.simulation(), refusal);
  return move ? std::optional(Snapped(world, drag, *move)) : std::nullopt;
}

sim::MoveTo Snapper::Snapped(const LiveWorld& world, const sim::Drag& drag,
                             const sim::MoveTo& move) const {
  const sim::Simulation& simulation = world.simulation();
  const demonstrator::Hand& hand = simulation.demonstrator().hand(drag.hand);
  const world::Object* object = simulation.tabletop().Find(hand.held);
  const Matrix3& R_WB = hand.X_WB_goal.rotation();
  const Carried carried{.bounds = world.bounds()[object->index],
                        .X_WB = {R_WB, move.p_WH - R_WB * hand.p_BH},
                        .plane_deg = simulation.demonstrator().plane_angle_deg(drag.hand),
                        .is_level = drag.is_level};
  if (carried.bounds.is_empty()) return move;
  sim::MoveTo snapped = move;
  snapped.p_WH += SnapShift(to, carried, NeighboursOf(world, hand.held),
                            to.faces ? PiecesBeside(world, hand.held) : std::vector<Neighbour>(),
                            simulation.scene().meters_per_unit);
  return snapped;
}

sim::Command Snapper::Snapped(const LiveWorld& world, const sim::Command& command) {
  if (const auto* rotate = std::get_if<sim::Rotate>(&command)) return SnappedRotate(world, *rotate);
  return command;
}

sim::Command Snapper::SnappedRotate(const LiveWorld& world, const sim::Rotate& rotate) {
  const demonstrator::Hand& hand = world.simulation().demonstrator().hand(rotate.hand);
  if (!to.angles || !hand.is_holding()) return rotate;
  const Matrix3& R_now = hand.X_WB_goal.rotation();
  Turn& turn = turns_[static_cast<std::size_t>(rotate.hand)];
  // Consecutive rotations accumulate without snapping, so that small steps can leave a snapped
  // angle.
  const bool continues_turn = R_now.isApprox(turn.R_snapped, 1e-9);
  turn.R_wanted =
      RotationFromFixedAxes(rotate.angles_deg) * (continues_turn ? turn.R_wanted : R_now);
  turn.R_snapped = SnapTurn(to, turn.R_wanted, FramesNear(world, hand));
  return sim::Rotate{.hand = rotate.hand,
                     .angles_deg = FixedAxesAngles(Matrix3(turn.R_snapped * R_now.transpose()))};
}

}  // namespace smile::studio
