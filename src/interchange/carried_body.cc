#include "interchange/carried_body.h"

#include <algorithm>
#include <cmath>
#include <variant>

namespace smile::interchange {

CarriedSlide SlideOf(const ExportedWorld& world, const ExportedJoint& joint, int child) {
  const auto& slider = std::get<mechanics::SliderJointSpec>(joint.spec);
  const mechanics::BodySpec& a = world.bodies[static_cast<std::size_t>(joint.a)].spec;
  const mechanics::BodySpec& b = world.bodies[static_cast<std::size_t>(joint.b)].spec;
  const RigidTransform X_JK = (a.X_WB * slider.X_AJ).inverse() * b.X_WB * slider.X_BK;
  // K slides along the x axis of J; A goes the other way.
  const bool is_a = joint.a == child;
  const Vector3 axis =
      is_a ? Vector3(-slider.X_AJ.rotation().col(0)) : Vector3(slider.X_BK.rotation().col(0));
  // The fraction that is lost per second belongs to an exponential decay.
  const double lost = std::min(slider.damping, 0.9999);
  return {.axis_in_child = axis,
          .offset = X_JK.translation().x(),
          .damping = -std::log1p(-lost) * (is_a ? a : b).mass.mass};
}

RigidTransform PoseInParent(const scene::LinkSpec& link, double q) {
  const RigidTransform motion =
      link.joint_type == scene::JointType::kRevolute
          ? RigidTransform(Matrix3(Eigen::AngleAxisd(q, link.axis)), Vector3::Zero())
          : RigidTransform(Vector3(link.axis * q));
  return link.X_PJ * motion;
}

std::vector<RigidTransform> LinkPosesOf(const ExportedRobot& robot) {
  return scene::LinkPoses(robot.spec->links, robot.spec->X_WBase, robot.q);
}

}  // namespace smile::interchange
