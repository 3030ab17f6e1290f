#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "interchange/exported_motion.h"

namespace smile::interchange {

/// Returns a text in quotation marks, as the text form of USD escapes it.
std::string UsdString(std::string_view text);
/// Returns a name as USD allows it: letters, digits and underscores.
std::string UsdName(std::string_view name);
std::string UsdTuple(const Vector3& v);
/// Returns a quaternion, w first.
std::string UsdTuple(const Quaternion& q);

/// Writer of indented prims, as one appends them.
class UsdWriter {
 public:
  /// Begins the file with metadata, lines of `name = value`.
  explicit UsdWriter(const std::vector<std::string>& metadata);

  /// Begins a prim.
  /// @param schemas  that are applied to it.
  void Open(std::string_view type, std::string_view name,
            const std::vector<std::string_view>& schemas = {});
  void Close();
  /// Writes a property, such as `float radius`.
  void Set(std::string_view property, std::string_view value);
  void Set(std::string_view property, double value);
  /// Writes a property without a value, such as an output of a shader.
  void Declare(std::string_view property) { Line(property); }

  /// Write translation and orientation, and a scale where it is not 1.
  void SetPose(const RigidTransform& X, const Vector3& scale = Vector3::Ones());
  /// Writes the poses of a frame, at their time codes if it moves.
  /// @param codes  time code of each moment.
  void SetPoses(const MovingFrame& frame, const std::vector<double>& codes);
  void SetVisibility(const MovingVisuals& visuals, const std::vector<double>& codes);

  std::string Take() { return std::move(text_); }

 private:
  void Line(std::string_view text);

  std::string text_;
  std::size_t depth_ = 0;
};

}  // namespace smile::interchange
