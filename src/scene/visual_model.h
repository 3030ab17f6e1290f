#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "scene/solid.h"

namespace smile::scene {

/// Triangles, of a file or made by rule, drawn as they are.
struct DrawnMesh {
  std::shared_ptr<const CustomMesh> mesh;
  double scale = 1;  ///< [m] per unit of the mesh

  /// Compares the meshes, not where they are.
  bool operator==(const DrawnMesh& other) const {
    return scale == other.scale &&
           (mesh == other.mesh || (mesh && other.mesh && *mesh == *other.mesh));
  }
};

using VisualShape = std::variant<Block, Cylinder, Sphere, Hull, DrawnMesh>;

/// One coloured piece to draw, fixed to a moving frame F.
struct Visual {
  VisualShape shape;
  Color color;
  RigidTransform X_FV;
  int frame = 0;                   ///< index into the poses the model is drawn with
  std::uint32_t object_id = 0;     ///< index into VisualModel::object_names
  int choice = -1;                 ///< index into VisualState::looks; -1: always to be seen
  int look = 0;                    ///< to be seen only while the choice is this
  bool glows = false;              ///< a lamp or screen: shows its own color in any light
  bool casts_shadow = true;        ///< false for what is only shown to people
  std::string part_id{};           ///< of the innermost part with an id
  std::optional<Button> button{};  ///< of a switch; nullopt: none
};

/// What is there to be seen, apart from where it is: drawn with one pose per frame, it is a
/// picture. Cameras, traces and pages share it, so nothing that draws needs to know physics or
/// robots.
struct VisualModel {
  std::vector<Visual> visuals;
  /// Name of each object id; [0] is the empty background, which no visual has.
  std::vector<std::string> object_names{""};
  int num_frames = 1;   ///< frame 0 is the world and never moves
  int num_choices = 0;  ///< of what is to be seen: objects that may vanish, controls
};

/// One X_WF per frame of a VisualModel; [0] is the identity.
using FramePoses = std::vector<RigidTransform>;

/// What a VisualModel is drawn with.
struct VisualState {
  FramePoses poses{RigidTransform()};
  std::vector<int> looks;  ///< one per choice

  bool operator==(const VisualState&) const = default;
};

/// A solid as it is drawn.
VisualShape VisualShapeOf(const SolidShape& shape);

/// What there is to be seen of an object, in its own frame: `frame` and `object_id` are 0, `choice`
/// is the number of the control it belongs to, as ControlsOf() has them, or -1.
std::vector<Visual> VisualsOf(const Part& whole);

}  // namespace smile::scene
