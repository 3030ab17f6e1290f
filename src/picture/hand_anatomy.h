#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "math/rigid_transform.h"
#include "scene/visual_model.h"

namespace smile::picture {

/// Hands of a person who faces the robot across the table: the left one is at +x.
enum class HandSide { kLeft, kRight };
inline constexpr std::array kHandSides = {HandSide::kLeft, HandSide::kRight};

/// Thumb, index, middle, ring and little finger.
inline constexpr std::size_t kDigits = 5;
/// Radius of the tip of an index finger [m].
inline constexpr double kFingertipRadius = 0.0072;
/// Largest opening between thumb and fingers [m].
inline constexpr double kWidestGrip = 0.125;

/// Posture of a hand. Its frame H has its origin where thumb and fingers meet the object that they
/// hold, x from the thumb to the fingertips, z up to the palm; the thumb is at +y of a right hand,
/// at -y of a left one.
struct HandPosture {
  RigidTransform X_WH;
  /// Distance of each digit's contact from its GripLine(), along x, for the thumb along -x [m].
  std::array<double, kDigits> reach{0.03, 0.03, 0.03, 0.03, 0.03};
  double pointing = 0;  ///< 1: only the index finger is stretched; 0: a grip

  bool operator==(const HandPosture&) const = default;
};

/// Returns the tip of a stretched index finger, in a hand's frame H [m].
Vector3 IndexTip(HandSide side);

/// Returns a point of the line, along x of H, on which a gripping digit touches [m].
Vector3 GripLine(HandSide side, std::size_t digit);

/// Returns the centers of the tips of all digits, in H [m].
std::array<Vector3, kDigits> FingertipsInHand(HandSide side, const HandPosture& posture);

/// Piece of a hand or arm, in its own frame.
struct ArmPiece {
  scene::DrawnMesh mesh;
  bool is_sleeve = false;
};

/// Number of pieces of a hand; the forearm, its sleeve and the upper arm follow.
inline constexpr std::size_t kHandPieces = 16, kArmPieces = 19;
std::vector<ArmPiece> PiecesOf(HandSide side);

/// Returns the poses of PiecesOf() in the world.
/// @param table_edge  y of the edge at which the person stands [m]. The shoulder leans over it as
///                    far as the arm needs.
std::array<RigidTransform, kArmPieces> PiecePoses(HandSide side, const HandPosture& posture,
                                                  double table_edge);

/// Returns the shoulder of a person who stands upright, in the world [m].
Vector3 ShoulderAt(HandSide side, double table_edge);

}  // namespace smile::picture
