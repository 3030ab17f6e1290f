#pragma once

#include <array>
#include <string>
#include <string_view>

#include "math/angles.h"
#include "math/rigid_transform.h"

namespace smile::scene {

/// Camera with a fixed pose in the scene. It is not an object: it neither collides nor appears in
/// pictures.
struct CameraSpec {
  std::string id;                  ///< a letter, then letters, digits, `_`
  Vector3 p_WC = Vector3::Zero();  ///< position [m]
  Vector3 p_WQ = Vector3::Zero();  ///< point it looks at [m]
  Vector3 up_in_world{0, 0, 1};    ///< direction of the image's top, of any length but 0
  double vertical_field_of_view = DegreesToRadians(60.0);  ///< [rad]

  bool operator==(const CameraSpec&) const = default;
};

/// Id of the camera from which the studio's page looks at first.
inline constexpr std::string_view kFirstView = "first_view";

/// Displacement of a camera that does not stand in the scene: of one of the robot's, or of the eye.
/// Pictures are taken from there, and brains are given that pose.
struct CameraOffset {
  std::string camera;           ///< as in model::CameraNames(); without effect if there is none
  RigidTransform X_CD;          ///< pose of the displaced camera D in the camera's frame C
  double view_angle_scale = 1;  ///< factor of the field of view

  bool operator==(const CameraOffset&) const = default;
};

inline constexpr int kMaxCameras = 64;
/// Short enough that programs can add prefixes and suffixes and still have an identifier of 63
/// letters.
inline constexpr int kMaxCameraLetters = 40;
/// Names of built-in cameras: those of the robot, and views for people.
inline constexpr std::array<std::string_view, 10> kTakenCameraNames{
    "close", "eye", "front", "head", "left", "left_hand", "nice", "right", "right_hand", "top"};

}  // namespace smile::scene
