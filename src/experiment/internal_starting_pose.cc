#include "experiment/internal_starting_pose.h"

#include "math/angles.h"
#include "physics/solid_probe.h"
#include "robot/kinematics.h"

namespace smile::experiment {
namespace {

constexpr double kClearance = 0.002;  // [m]

bool DoOverlap(const scene::Bounds& a, const scene::Bounds& b) {
  return (a.low.array() <= b.high.array()).all() && (b.low.array() <= a.high.array()).all();
}

}  // namespace

StartingPose::StartingPose(const robot::RobotModel& model, const RigidTransform& X_WBase) {
  const std::vector<RigidTransform> X_WL = robot::LinkPoses(model, X_WBase, model.q_start);
  for (std::size_t i = 0; i < model.links.size(); ++i) {
    for (scene::Solid solid : model.links[i].solids) {
      solid.X_BS = X_WL[i] * solid.X_BS;
      const scene::Bounds bounds = scene::BoundsOf(solid.shape, solid.X_BS);
      pieces_.push_back({.solid = std::move(solid), .bounds = bounds});
    }
  }
}

bool StartingPose::Touches(const layout::Footprint& footprint, double top) const {
  const Vector3 size(2 * (footprint.half_size.x() + kClearance),
                     2 * (footprint.half_size.y() + kClearance), top + kClearance);
  const scene::Solid box{
      .shape = scene::Block{size},
      .X_BS = RigidTransform(RotationFromFixedAxes({0, 0, footprint.yaw_deg}),
                             Vector3(footprint.center.x(), footprint.center.y(), size.z() / 2))};
  // Most pieces are far away: what remains is probed as it is.
  const scene::Bounds bounds = scene::BoundsOf(box.shape, box.X_BS);
  std::vector<scene::Solid> near{box};
  for (const Piece& piece : pieces_) {
    if (DoOverlap(piece.bounds, bounds)) near.push_back(piece.solid);
  }
  if (near.size() == 1) return false;  // to make a probe takes longer than all above
  physics::SolidProbe probe(near);
  for (std::size_t i = 1; i < near.size(); ++i) {
    if (probe.Depth(0, i) > 0) return true;
  }
  return false;
}

}  // namespace smile::experiment
