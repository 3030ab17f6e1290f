#pragma once

#include <numbers>
#include <string>

#include "math/angles.h"
#include "scene/visual_model.h"

namespace smile::camera {

/// A model that grows object by object; each has its own frame.
struct SmallScene {
  scene::VisualModel model;
  scene::VisualState state;

  /// @returns the object's id, which is its frame too.
  std::uint32_t Add(const scene::VisualShape& shape, const Color& color,
                    const RigidTransform& X_WF) {
    const auto id = static_cast<std::uint32_t>(model.num_frames);
    model.visuals.push_back({.shape = shape,
                             .color = color,
                             .X_FV = RigidTransform(),
                             .frame = model.num_frames++,
                             .object_id = id});
    model.object_names.push_back("object " + std::to_string(id));
    state.poses.push_back(X_WF);
    return id;
  }
  /// All pieces of a part in one frame.
  std::uint32_t AddPart(const scene::Part& part, const Vector3& p_WF) {
    const auto id = static_cast<std::uint32_t>(model.num_frames);
    for (scene::Visual visual : scene::VisualsOf(part)) {
      visual.frame = model.num_frames;
      visual.object_id = id;
      model.visuals.push_back(visual);
    }
    ++model.num_frames;
    model.object_names.push_back("object " + std::to_string(id));
    state.poses.emplace_back(p_WF);
    return id;
  }
  std::uint32_t Add(const scene::VisualShape& shape, const Color& color, const Vector3& p_WF) {
    return Add(shape, color, RigidTransform(p_WF));
  }
};

inline constexpr Color kRed{1, 0, 0}, kGreen{0, 1, 0}, kBlue{0, 0, 1}, kWhite{1, 1, 1};
inline const Vector3 kCubeSize{0.1, 0.1, 0.1};

/// A table with a turned cube, a cylinder and a ball on it.
inline SmallScene TableScene() {
  SmallScene scene;
  scene.Add(scene::Block{{2, 1.2, 0.4}}, kWhite, Vector3(0, 0, -0.2));
  scene.Add(scene::Block{kCubeSize}, kRed,
            RigidTransform(RotationFromFixedAxes({0, 0, 30}), {-0.2, 0, 0.05}));
  scene.Add(scene::Cylinder{.radius = 0.05, .length = 0.2}, kGreen,
            RigidTransform(RotationFromFixedAxes({90, 0, 0}), {0.1, 0.1, 0.1}));
  scene.Add(scene::Sphere{0.06}, kBlue, Vector3(0.3, -0.1, 0.06));
  return scene;
}

/// From above the near table edge, as a robot looks at its table.
inline CameraView HeadView(int width_px, int height_px) {
  return {CameraIntrinsics::FromVerticalFieldOfView(width_px, height_px, std::numbers::pi / 3),
          LookAt({0, -0.71, 1.16}, {0, 0.05, 0})};
}

}  // namespace smile::camera
