#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "scene/solid.h"

namespace smile::scene {

/// One coloured piece to draw, fixed to a moving frame F.
struct Visual {
  SolidShape shape;
  Color color;
  RigidTransform X_FV;
  int frame = 0;                ///< index into the poses the model is drawn with
  std::uint32_t object_id = 0;  ///< index into VisualModel::object_names
};

/// What is there to be seen, apart from where it is: drawn with one pose per frame, it is a
/// picture. Cameras, traces and pages share it, so nothing that draws needs to know physics or
/// robots.
struct VisualModel {
  std::vector<Visual> visuals;
  /// Name of each object id; [0] is the empty background, which no visual has.
  std::vector<std::string> object_names{""};
  int num_frames = 1;  ///< frame 0 is the world and never moves
};

/// One X_WF per frame of a VisualModel; [0] is the identity.
using FramePoses = std::vector<RigidTransform>;

}  // namespace smile::scene
