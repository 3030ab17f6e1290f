#pragma once

#include <array>
#include <string>
#include <string_view>

#include "math/angles.h"
#include "math/rigid_transform.h"

namespace smile::scene {

/// A camera that stands in the scene. It is no object: nothing touches it, nobody sees it.
struct CameraSpec {
  std::string id;                  ///< a letter, then letters, digits, `_`
  Vector3 p_WC = Vector3::Zero();  ///< where it stands [m]
  Vector3 p_WQ = Vector3::Zero();  ///< what it looks at [m]
  Vector3 up_in_world{0, 0, 1};    ///< where the image's top is, of any length but 0
  double vertical_field_of_view = DegreesToRadians(60.0);  ///< [rad]

  bool operator==(const CameraSpec&) const = default;
};

inline constexpr int kMaxCameras = 64;
/// So long that programs can put words around it and still have an identifier of 63 letters.
inline constexpr int kMaxCameraLetters = 40;
/// Names of cameras that are there without a scene's doing: of the robot's, and of views for
/// people.
inline constexpr std::array<std::string_view, 10> kTakenCameraNames{
    "close", "eye", "front", "head", "left", "left_hand", "nice", "right", "right_hand", "top"};

}  // namespace smile::scene
