#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "math/rigid_transform.h"
#include "scene_xml/mesh_files.h"

namespace smile::scene_xml {

/// Writer of indented elements in the unit of a scene: meters here, units in the text. Contains the
/// names under which the text refers to its meshes.
class XmlText {
 public:
  /// @param mesh_files  files beside the text; other meshes keep the names under which they were
  ///                    found.
  XmlText(double meters_per_unit, std::vector<MeshFile> mesh_files);

  void Open(std::string_view name);
  void Close();
  /// Writes a comment. Its text may come from file names: two hyphens, which would end the comment
  /// or break it, are separated.
  void Comment(std::string_view text);

  // Attributes of the element opened last, before it gets content.
  void Attribute(std::string_view name, std::string_view value);
  void Boolean(std::string_view name, bool value);
  void Count(std::string_view name, int value);
  void Number(std::string_view name, double value);
  void Length(std::string_view name, double meters);
  void Spans(const Vector3& size);
  void Point(std::string_view name, const Vector3& p);
  void Direction(std::string_view name, const Vector3& direction);  ///< without unit
  /// `location` and `rotation`, or `rotationMatrix` where angles lose bits.
  void Pose(const RigidTransform& X_PE);
  void Angle(std::string_view name, double angle);  ///< [rad]; degrees in the text

  /// Returns the name of a mesh in the text.
  std::string FileOf(const scene::Custom& custom) const;

  std::string Take() { return std::move(text_); }

 private:
  void Indent();
  /// Ends the tag opened last, before content is written into its element.
  void EndTag();
  std::string Units(double meters) const;

  double meters_per_unit_;
  std::vector<MeshFile> mesh_files_;
  std::vector<std::string> open_;
  bool is_tag_open_ = false;
  std::string text_;
};

}  // namespace smile::scene_xml
