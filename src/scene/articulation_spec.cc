#include "scene/articulation_spec.h"

#include <algorithm>

#include "base/demand.h"

namespace smile::scene {

void FollowLeaders(std::span<const LinkSpec> links, std::span<double> q) {
  SMILE_DEMAND(links.size() == q.size());
  for (std::size_t i = 0; i < links.size(); ++i) {
    const std::optional<Mimic>& mimic = links[i].mimic;
    if (!mimic) continue;
    q[i] = std::clamp(mimic->multiplier * q[mimic->leader] + mimic->offset, links[i].lower,
                      links[i].upper);
  }
}

std::vector<RigidTransform> LinkPoses(std::span<const LinkSpec> links,
                                      const RigidTransform& X_WBase, std::span<const double> q) {
  SMILE_DEMAND(links.size() == q.size());
  std::vector<RigidTransform> X_WL;
  X_WL.reserve(links.size());
  for (std::size_t i = 0; i < links.size(); ++i) {
    const LinkSpec& link = links[i];
    // Parents precede their children, so their poses are known.
    const RigidTransform& X_WP = link.parent < 0 ? X_WBase : X_WL[link.parent];
    // X_WL = X_WP * X_PJ * X_JL(q): parent, fixed joint frame, motion of the joint.
    const RigidTransform X_JL =
        link.joint_type == JointType::kRevolute
            ? RigidTransform(Eigen::AngleAxisd(q[i], link.axis).toRotationMatrix(), Vector3::Zero())
            : RigidTransform(Vector3(link.axis * q[i]));
    X_WL.push_back(X_WP * link.X_PJ * X_JL);
  }
  return X_WL;
}

}  // namespace smile::scene
