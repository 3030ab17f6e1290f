#include <algorithm>

#include "scene_import/internal_link_shapes.h"
#include "scene_import/internal_shapes.h"

namespace smile::scene_import {

Matrix3 RollPitchYawRotation(double roll, double pitch, double yaw) {
  return (Eigen::AngleAxisd(yaw, Vector3::UnitZ()) * Eigen::AngleAxisd(pitch, Vector3::UnitY()) *
          Eigen::AngleAxisd(roll, Vector3::UnitX()))
      .toRotationMatrix();
}

std::string FileNameOfUri(const std::string& uri, const ModelFiles& files) {
  for (const std::string_view scheme : {"package://", "model://", "file://"}) {
    if (!uri.starts_with(scheme)) continue;
    std::string name = uri.substr(scheme.size());
    const std::size_t slash = name.find('/');
    if (files.Has(name) || slash == std::string::npos) return name;
    return name.substr(slash + 1);
  }
  return uri;
}

void AddLinkShapes(const RigidTransform& X_BS, std::vector<ForeignShape> shapes,
                   const ForeignShape& traits, ForeignBody* body, ImportFindings* findings) {
  if (body->shapes.size() + shapes.size() > kMaxShapesOfBody) {
    return findings->Refuse(
        traits.place, "found more than " + std::to_string(kMaxShapesOfBody) + " shapes in a link");
  }
  for (const ForeignShape& shape : shapes) {
    ForeignShape complete = traits;
    complete.geometry = shape.geometry;
    complete.X_BE = X_BS * shape.X_BE;
    complete.mass = shape.mass;
    complete.center_of_mass = shape.center_of_mass;
    body->shapes.push_back(std::move(complete));
  }
}

std::optional<Color> ColorOfNumbers(const std::vector<double>& rgba) {
  if (rgba.size() < 3) return std::nullopt;
  return Color{std::clamp(rgba[0], 0.0, 1.0), std::clamp(rgba[1], 0.0, 1.0),
               std::clamp(rgba[2], 0.0, 1.0)};
}

}  // namespace smile::scene_import
