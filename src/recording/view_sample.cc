#include "recording/view_sample.h"

namespace smile::recording {

scene::VisualState VisualStateAt(const TraceTick& moment, const model::Model& model) {
  model::SceneState state{.X_WB = {}, .controls = moment.controls, .hosts = moment.bonds};
  for (const TracePose& object : moment.objects) {
    state.X_WB.push_back(object.is_present ? std::optional(object.pose_in_world()) : std::nullopt);
  }
  return model.VisualStateOf(state, moment.joints, moment.face_expression);
}

model::ViewSample ViewSampleAt(const TraceTick& moment, const model::Model& model,
                               const model::EyeSpec& spec) {
  return {.state = VisualStateAt(moment, model),
          .view = EyeView(model, moment.joints, spec),
          .hidden_frames = FramesHiddenFromEye(model, moment.is_robot_shown, spec.camera)};
}

std::optional<model::EyeSpec> EyeOf(const DemoInfo& info) {
  if (!info.eye) return std::nullopt;
  return model::EyeSpec{.width_px = info.eye->intrinsics.width_px,
                        .height_px = info.eye->intrinsics.height_px,
                        .camera = info.eye_camera};
}

}  // namespace smile::recording
