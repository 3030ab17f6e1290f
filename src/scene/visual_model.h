#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "scene/lighting.h"
#include "scene/scene_spec.h"
#include "scene/solid.h"

namespace smile::scene {

/// Triangles, from a file or generated, drawn directly.
struct DrawnMesh {
  std::shared_ptr<const CustomMesh> mesh;
  double scale = 1;  ///< [m] per unit of the mesh

  /// Compares the meshes, not their addresses.
  bool operator==(const DrawnMesh& other) const {
    return scale == other.scale &&
           (mesh == other.mesh || (mesh && other.mesh && *mesh == *other.mesh));
  }
};

using VisualShape = std::variant<Block, Cylinder, Sphere, Hull, DrawnMesh>;

/// Colored piece to draw, fixed to a moving frame F.
struct Visual {
  VisualShape shape;
  Color color;
  RigidTransform X_FV;
  int frame = 0;                   ///< index into the poses with which the model is drawn
  std::uint32_t object_id = 0;     ///< index into VisualModel::object_names
  int choice = -1;                 ///< index into VisualState::variants; -1: always visible
  int variant = 0;                 ///< visible only while the choice has this value
  bool glows = false;              ///< a lamp or screen: shows its own color in any light
  bool casts_shadow = true;        ///< false for pieces that are shown only to people
  std::string part_id{};           ///< of the innermost part with an id
  std::optional<Button> button{};  ///< of a switch; nullopt: none
};

/// Visible content without poses: drawn with one pose per frame, it is a picture. Cameras, traces
/// and pages share it, so that drawing depends neither on physics nor on robots.
struct VisualModel {
  std::vector<Visual> visuals;
  /// Name of each object id; [0] is the empty background, which no visual has.
  std::vector<std::string> object_names{""};
  int num_frames = 1;   ///< frame 0 is the world and never moves
  int num_choices = 0;  ///< objects that may vanish, and controls
  Lighting lighting;
};

/// Poses X_WF, one per frame of a VisualModel; [0] is the identity.
using FramePoses = std::vector<RigidTransform>;

/// State with which a VisualModel is drawn.
struct VisualState {
  FramePoses poses{RigidTransform()};
  std::vector<int> variants;  ///< one per choice

  bool operator==(const VisualState&) const = default;
};

/// Returns the drawn shape of a solid.
VisualShape VisualShapeOf(const SolidShape& shape);

/// Returns the visible pieces of an object, in its own frame: `frame` and `object_id` are 0,
/// `choice` is the index of the piece's control, see ControlsOf(), or -1.
std::vector<Visual> VisualsOf(const Part& whole);

/// Returns the visible pieces of the table, in the world: the table itself, then its pattern.
std::vector<Visual> VisualsOf(const TableSpec& table);

}  // namespace smile::scene
