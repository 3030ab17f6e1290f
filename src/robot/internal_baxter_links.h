#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "math/color.h"
#include "mesh/modeling.h"
#include "robot/mood.h"
#include "scene/custom_mesh.h"

namespace smile::robot::internal {

// What each of Baxter's links looks like, in the frame of that link: axes as docs/robot.md has
// them, metres. Sizes are our own measurements of the real robot's proportions.

/// All of a link that has one color.
struct LookPiece {
  Color color;
  std::shared_ptr<const scene::CustomMesh> mesh;
  std::optional<Mood> mood;  ///< to be seen only in this mood
};
using LinkLook = std::vector<LookPiece>;

/// One piece of several surfaces.
LookPiece PieceOf(const Color& color, const std::vector<scene::SurfaceMesh>& surfaces);

/// Turns what is drawn in the xy plane and grows along z into a profile, drawn in (x, z), that
/// grows along -y.
RigidTransform AlongMinusY();
/// Into a cut, drawn in (y, z), that grows along x.
RigidTransform AlongX();

// Satin shells and what is between them, as they look in daylight.
inline constexpr Color kBrickRed{0.620, 0.180, 0.145};
inline constexpr Color kCharcoal{0.400, 0.400, 0.410};
inline constexpr Color kRubberBlack{0.145, 0.145, 0.155};
inline constexpr Color kDarkGray{0.285, 0.285, 0.295};
inline constexpr Color kSteel{0.46, 0.46, 0.47};
inline constexpr Color kPale{0.784, 0.784, 0.784};

LinkLook TorsoLook();
LinkLook PedestalLook();
/// Bowl and screen, and a face for each mood.
LinkLook HeadLook();

// The arm's bottles (s0, e0, w0: along z, ending in a ring about y) and forks (s1, e1, w1: two
// cheeks about z, then a stub along x).
LinkLook UpperShoulderLook();  ///< s0
LinkLook LowerShoulderLook();  ///< s1
LinkLook UpperElbowLook();     ///< e0
LinkLook LowerElbowLook();     ///< e1
LinkLook UpperForearmLook();   ///< w0
LinkLook LowerForearmLook();   ///< w1
LinkLook WristLook();          ///< w2, up to the tool flange

/// The bar of the classic gripper, in the frame of its middle: y along it, z towards the tips.
LinkLook ClassicPalmLook();
/// The finger at +y or -y: within the box that collides, its inner face in the plane y = 0.
LinkLook ClassicFingerLook(bool is_left);

}  // namespace smile::robot::internal
