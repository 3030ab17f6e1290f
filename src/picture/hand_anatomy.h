#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "math/rigid_transform.h"
#include "scene/visual_model.h"

namespace smile::picture {

/// The hands of a person who looks at the robot across the table: the left one is at +x.
enum class Side { kLeft, kRight };
inline constexpr std::array kSides = {Side::kLeft, Side::kRight};

/// Thumb, index, middle, ring and little finger.
inline constexpr std::size_t kDigits = 5;
/// The tip of an index finger is a ball [m].
inline constexpr double kFingertipRadius = 0.0072;
/// Thumb and fingers cannot be farther apart [m].
inline constexpr double kWidestGrip = 0.125;

/// How a hand is held. Its frame H has its origin where thumb and fingers meet what they hold, x
/// from the thumb to the fingertips, z up to the palm; the thumb is at +y of a right hand, at -y of
/// a left one.
struct HandPosture {
  RigidTransform X_WH;
  /// How far what each digit touches is from its GripLine(), along x, of the thumb along -x [m].
  std::array<double, kDigits> reach{0.03, 0.03, 0.03, 0.03, 0.03};
  double pointing = 0;  ///< 1: the index finger is stretched, the others are not; 0: a grip

  bool operator==(const HandPosture&) const = default;
};

/// Where the tip of a stretched index finger is, in a hand's frame H [m].
Vector3 IndexTip(Side side);

/// Where a digit that grips touches: on the line through this point along x of H [m].
Vector3 GripLine(Side side, std::size_t digit);

/// The middles of the tips of all digits [m].
std::array<Vector3, kDigits> FingertipsInHand(Side side, const HandPosture& posture);

/// A piece of a hand or arm, in its own frame.
struct ArmPiece {
  scene::DrawnMesh mesh;
  bool is_sleeve = false;
};

/// The pieces that are a hand; those of a forearm with its sleeve and an upper arm come after them.
inline constexpr std::size_t kHandPieces = 16, kArmPieces = 19;
std::vector<ArmPiece> PiecesOf(Side side);

/// The poses in the world of PiecesOf().
/// @param table_edge  y of the edge at which the person stands [m]. The shoulder leans over it as
///                    far as the arm needs.
std::array<RigidTransform, kArmPieces> PiecePoses(Side side, const HandPosture& posture,
                                                  double table_edge);

/// Of a person who stands upright [m].
Vector3 ShoulderAt(Side side, double table_edge);

}  // namespace smile::picture
