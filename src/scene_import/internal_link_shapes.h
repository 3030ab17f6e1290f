#pragma once

#include <optional>
#include <string>
#include <vector>

#include "scene_import/internal_model_files.h"
#include "scene_import/internal_source_element.h"

namespace smile::scene_import {

// What URDF and SDFormat have in common: links with visuals and collisions.

/// Returns a rotation about the fixed axes x, y and z, in this order [rad].
Matrix3 RollPitchYawRotation(double roll, double pitch, double yaw);

/// Reads the address of a mesh as the name of a file: `package://NAME/…`, `model://NAME/…` and
/// `file://…` name files in the folders of the model, with or without NAME.
std::string FileNameOfUri(const std::string& uri, const ModelFiles& files);

/// Adds the shapes of a collision or a visual to a body.
/// @param X_BS  of the collision in its body.
/// @param shapes  in the frame of the collision.
/// @param traits  what all of them have.
void AddLinkShapes(const RigidTransform& X_BS, std::vector<ForeignShape> shapes,
                   const ForeignShape& traits, ForeignBody* body, ImportFindings* findings);

/// Returns a color of three or four numbers; alpha is left out.
std::optional<Color> ColorOfNumbers(const std::vector<double>& rgba);

}  // namespace smile::scene_import
