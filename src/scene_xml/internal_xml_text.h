#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "math/rigid_transform.h"
#include "scene_xml/mesh_files.h"
#include "xml/writer.h"

namespace smile::scene_xml {

/// Writer in the unit of a scene: meters here, units in the text. Contains the names under which
/// the text refers to its meshes.
class XmlText : public xml::Writer {
 public:
  /// @param mesh_files  files beside the text; other meshes keep the names under which they were
  ///                    found.
  XmlText(double meters_per_unit, std::vector<MeshFile> mesh_files);

  // Attributes of the element opened last, before it gets content.
  void Length(std::string_view name, double meters);
  void Spans(const Vector3& size);
  void Point(std::string_view name, const Vector3& p);
  void Direction(std::string_view name, const Vector3& direction);  ///< without unit
  /// `location` and `rotation`, or `rotationMatrix` where angles lose bits.
  void Pose(const RigidTransform& X_PE);
  void Angle(std::string_view name, double angle);  ///< [rad]; degrees in the text

  /// Returns the name of a mesh in the text.
  std::string FileOf(const scene::Custom& custom) const;

 private:
  std::string Units(double meters) const;

  double meters_per_unit_;
  std::vector<MeshFile> mesh_files_;
};

}  // namespace smile::scene_xml
