#include "studio/pose_stream.h"

#include "scene/units.h"

namespace smile::studio {
namespace {

// Calls between two key messages: one second.
constexpr int kTicksBetweenAll = 60;

void Append(std::uint32_t frame, const RigidTransform& X_WF, double meters_per_unit,
            page::Poses* poses) {
  const Vector3 p = scene::ToFileUnits(X_WF.translation(), meters_per_unit);
  const Quaternion q = X_WF.quaternion();
  poses->frames.push_back(frame);
  for (const double number : {p.x(), p.y(), p.z(), q.x(), q.y(), q.z(), q.w()}) {
    poses->values.push_back(static_cast<float>(number));
  }
}

}  // namespace

page::Poses PoseStream::Next(const library::DisplayedState& view) {
  const scene::FramePoses& now = view.state.poses;
  page::Poses poses{.scene = view.scene, .tick = static_cast<std::uint32_t>(view.tick)};
  // A key message has all frames, so that a client which missed a message recovers within a second.
  poses.is_key =
      view.scene != scene_ || now.size() != sent_.size() || ++since_all_ >= kTicksBetweenAll;
  // Frame 0 is the world, which never moves.
  for (std::size_t frame = 1; frame < now.size(); ++frame) {
    // Exact comparison: resting objects have the same bits at every tick.
    if (!poses.is_key && now[frame] == sent_[frame]) continue;
    Append(static_cast<std::uint32_t>(frame), now[frame], view.meters_per_unit, &poses);
  }
  if (poses.is_key) since_all_ = 0;
  scene_ = view.scene;
  sent_ = now;
  return poses;
}

}  // namespace smile::studio
