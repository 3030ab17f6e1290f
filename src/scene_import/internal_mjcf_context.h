#pragma once

#include <map>
#include <string>
#include <vector>

#include "scene_import/internal_model_files.h"
#include "scene_import/internal_source_element.h"

namespace smile::scene_import {

/// Settings of `compiler`.
struct MjcfCompiler {
  double radians_per_angle = 0.017453292519943295;
  std::string euler_sequence = "xyz";  ///< lower case: about turned axes
  bool has_automatic_limits = true;
  bool ignores_inertial = false;  ///< masses come from shapes
  bool needs_inertial = false;    ///< masses never come from shapes
  std::string mesh_folder;
};

/// Defaults of MJCF: for each class the attributes of elements, by the name of the element.
class MjcfDefaults {
 public:
  /// Adds the classes of a `default` element, and those within it.
  void Add(const SourceElement& element, ImportFindings* findings);

  /// Returns an element with its defaults filled in.
  /// @param child_class  of the bodies around it; empty for none.
  SourceElement Completed(const SourceElement& element, const std::string& child_class,
                          ImportFindings* findings) const;

 private:
  using Attributes = std::map<std::string, std::string>;
  using DefaultClass = std::map<std::string, Attributes>;  // by element

  void AddClass(const SourceElement& element, const std::string& name, DefaultClass inherited,
                int depth, ImportFindings* findings);

  std::map<std::string, DefaultClass> classes_{{"main", {}}};
};

/// What elements of a MJCF model refer to.
struct MjcfContext {
  MjcfCompiler compiler;
  MjcfDefaults defaults;
  std::map<std::string, const SourceElement*> meshes, materials;  ///< assets by name
  /// Shapes of meshes that were made already, by name.
  std::map<std::string, std::vector<ForeignShape>>* mesh_shapes = nullptr;
  ModelFiles* files = nullptr;
  ImportFindings* findings = nullptr;
};

/// Reads `compiler` elements: later ones override.
void ReadMjcfCompiler(const SourceElement& element, ImportFindings* findings,
                      MjcfCompiler* compiler);

/// Reads the pose of an element: position, and one of five ways to write a rotation.
RigidTransform MjcfPoseOf(ElementReader* reader, const MjcfCompiler& compiler);

/// Reads a geom.
/// @param geom  with its defaults.
/// @returns its shapes; none, with a remark or a fault, if there is no counterpart.
std::vector<ForeignShape> MjcfShapesOf(const SourceElement& geom, const MjcfContext& context);

}  // namespace smile::scene_import
