#pragma once

#include <array>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "scene/bounds.h"
#include "sim/drag.h"
#include "studio/live_world.h"

namespace smile::studio {

/// What drags and turns snap to.
struct SnapTo {
  bool faces = false;   ///< sides of neighbours, to touch them
  bool edges = false;   ///< sides and middles of neighbours, to be flush with them
  bool grid = false;    ///< multiples of half a unit
  bool angles = false;  ///< right angles to the table and to what is nearest

  bool operator==(const SnapTo&) const = default;
};
SnapTo SnapToOf(std::span<const std::string> names);
std::vector<std::string> NamesOf(const SnapTo& snap);

/// So far at most a drag, and so much a turn, is changed.
inline constexpr double kSnapUnits = 0.15, kSnapDegrees = 5, kGridUnits = 0.5;

/// Something to snap to: a cuboid in its own frame B.
struct Neighbour {
  scene::Bounds bounds;
  RigidTransform X_WB;
};

/// Something that a hand is to carry somewhere.
struct Carried {
  scene::Bounds bounds;   ///< in its own frame B
  RigidTransform X_WB;    ///< where it is wanted
  double plane_deg = 0;   ///< it stays in this vertical plane, see sim::Plane
  bool is_level = false;  ///< but in a level plane if this is true
};

/// By how much to move a carried thing beyond where it is wanted, within its plane [m]: never more
/// than kSnapUnits. The nearest of what faces and edges ask for counts; where they ask for nothing,
/// the grid. A neighbour only counts where the two are turned alike.
Vector3 SnapShift(const SnapTo& snap, const Carried& carried, std::span<const Neighbour> neighbours,
                  double meters_per_unit);

/// Where a turn to `R_wanted` ends: at a right angle to one of `frames` if that is less than
/// kSnapDegrees away. Of several the nearest.
/// @param frames  rotations in the world, of the table and of things nearby.
Matrix3 SnapTurn(const SnapTo& snap, const Matrix3& R_wanted, std::span<const Matrix3> frames);

/// What the drags and turns of hands mean when they snap.
class Snapper {
 public:
  SnapTo to;

  /// Where a drag leads instead.
  /// @param move  as sim::MoveOf() has it.
  sim::MoveTo Snapped(const LiveWorld& world, const sim::Drag& drag, const sim::MoveTo& move) const;
  /// The command to carry out instead; others are what they were. Turns that follow one another add
  /// up as if nothing snapped: so whoever turns on gets away from where it did.
  sim::Command Snapped(const LiveWorld& world, const sim::Command& command);

 private:
  /// The last one of a hand: where it was to end, and where it did.
  struct Turn {
    Matrix3 R_wanted = Matrix3::Zero(), R_snapped = Matrix3::Zero();
  };
  sim::Command SnappedRotate(const LiveWorld& world, const sim::Rotate& rotate);

  std::array<Turn, demonstrator::kHandNames.size()> turns_;
};

}  // namespace smile::studio
