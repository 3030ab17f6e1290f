#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "scene/bounds.h"
#include "sim/drag.h"
#include "studio/live_world.h"

namespace smile::studio {

/// Targets to which drags and rotations snap, as they are from the start.
struct SnapTo {
  bool rails = true;    ///< what slides on another object stays on its rail
  bool faces = true;    ///< sides of neighbours, to touch them
  bool edges = true;    ///< sides and middles of neighbours, to be flush with them
  bool grid = false;    ///< multiples of half a unit
  bool angles = false;  ///< right angles to the table and to what is nearest

  bool operator==(const SnapTo&) const = default;
};
SnapTo SnapToOf(std::span<const std::string> names);
std::vector<std::string> NamesOf(const SnapTo& snap);

/// Largest change of a drag, and of a rotation.
inline constexpr double kSnapUnits = 0.15, kSnapDegrees = 5, kGridUnits = 0.5;
/// Most room that a gap leaves in which a carried object snaps to the middle.
inline constexpr double kGapUnits = 0.3;

/// Snap target: a cuboid in its own frame B.
struct Neighbour {
  scene::Bounds bounds;
  RigidTransform X_WB;
};

/// Carried object and its desired pose.
struct Carried {
  scene::Bounds bounds;   ///< in its own frame B
  RigidTransform X_WB;    ///< where it is wanted
  double plane_deg = 0;   ///< it stays in this vertical plane, see sim::Plane
  bool is_level = false;  ///< true: it stays in a horizontal plane instead
};

/// Returns the displacement of a carried object from its desired pose, within its plane [m]: at
/// most kSnapUnits. The nearest wishes of faces and edges count; where there are none, the grid. A
/// neighbor counts only if the axes of both are parallel.
/// @param pieces  of the neighbors: between two faces of them that leave little more room than it
///                needs, such as the walls of a slot, it snaps to the middle.
Vector3 SnapShift(const SnapTo& snap, const Carried& carried, std::span<const Neighbour> neighbours,
                  std::span<const Neighbour> pieces, double meters_per_unit);

/// Returns the end of a rotation to `R_wanted`: at a right angle to one of `frames` if that is less
/// than kSnapDegrees away, the nearest one if there are several.
/// @param frames  rotations in the world, of the table and of nearby objects.
Matrix3 SnapTurn(const SnapTo& snap, const Matrix3& R_wanted, std::span<const Matrix3> frames);

/// Snaps the drags and rotations of hands.
class Snapper {
 public:
  SnapTo to;

  /// Returns the snapped motion of a drag.
  /// @returns nullopt if it leads nowhere, with the reason in `refusal`.
  std::optional<sim::MoveTo> MoveOf(const LiveWorld& world, const sim::Drag& drag,
                                    sim::Refusal* refusal) const;
  /// Returns the snapped command; commands other than rotations are unchanged. Consecutive
  /// rotations add up as if nothing snapped, so that continued rotation leaves a snapped angle.
  sim::Command Snapped(const LiveWorld& world, const sim::Command& command);

 private:
  sim::MoveTo Snapped(const LiveWorld& world, const sim::Drag& drag, const sim::MoveTo& move) const;

  /// Last rotation of a hand: desired end and snapped end.
  struct Turn {
    Matrix3 R_wanted = Matrix3::Zero(), R_snapped = Matrix3::Zero();
  };
  sim::Command SnappedRotate(const LiveWorld& world, const sim::Rotate& rotate);

  std::array<Turn, demonstrator::kHandNames.size()> turns_;
};

}  // namespace smile::studio
