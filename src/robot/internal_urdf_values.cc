#include "robot/internal_urdf_values.h"

#include <cmath>
#include <cstdio>
#include <limits>

#include "base/wording.h"

// Values of URDF elements, checked: the parser accepts any number, also NaN. All units are SI
// already.

namespace smile::robot::internal {
namespace {

// Upper bounds: far beyond any robot, small enough that products stay finite.
constexpr double kMaxLength = 100;   // [m]
constexpr double kMaxMass = 1e5;     // [kg]
constexpr double kMaxInertia = 1e6;  // [kg m2]
constexpr double kMaxAngle = 100;    // [rad]
constexpr double kContinuous = 1e4;  // range of a joint without limits [rad]
constexpr double kMaxScale = 1e4;

}  // namespace

RigidTransform UrdfElement::ReadPose(const urdf::Pose& pose) const {
  const Vector3 position(pose.position.x, pose.position.y, pose.position.z);
  for (double part : position) Within(part, -kMaxLength, kMaxLength, "origin");
  const Quaternion q(pose.rotation.w, pose.rotation.x, pose.rotation.y, pose.rotation.z);
  // NaN in rpy ends up here, too.
  if (!(std::abs(q.norm() - 1) < 1e-6)) Fail("rpy is not a rotation");
  return {q.normalized(), position};
}

UrdfInertial UrdfElement::ReadInertial(const urdf::Inertial& inertial) const {
  UrdfInertial read{.mass = Within(inertial.mass, 0, kMaxMass, "mass"),
                    .X_FI = ReadPose(inertial.origin)};
  read.inertia << inertial.ixx, inertial.ixy, inertial.ixz,  //
      inertial.ixy, inertial.iyy, inertial.iyz,              //
      inertial.ixz, inertial.iyz, inertial.izz;
  for (double part : read.inertia.reshaped()) {
    Within(part, -kMaxInertia, kMaxInertia, "inertia");
  }
  return read;
}

scene::Solid UrdfElement::ReadSolid(const urdf::Geometry* geometry,
                                    const urdf::Pose& origin) const {
  scene::Solid solid{.X_BS = ReadPose(origin)};
  if (const auto* box = dynamic_cast<const urdf::Box*>(geometry)) {
    solid.shape = scene::Block{{Positive(box->dim.x, kMaxLength, "box size"),
                                Positive(box->dim.y, kMaxLength, "box size"),
                                Positive(box->dim.z, kMaxLength, "box size")}};
  } else if (const auto* cylinder = dynamic_cast<const urdf::Cylinder*>(geometry)) {
    solid.shape =
        scene::Cylinder{.radius = Positive(cylinder->radius, kMaxLength, "cylinder radius"),
                        .length = Positive(cylinder->length, kMaxLength, "cylinder length")};
    // URDF's cylinders are along z, those of scenes along y.
    Matrix3 R_zy;
    R_zy << 1, 0, 0, 0, 0, -1, 0, 1, 0;
    solid.X_BS = solid.X_BS * RigidTransform(R_zy, Vector3::Zero());
  } else if (const auto* sphere = dynamic_cast<const urdf::Sphere*>(geometry)) {
    solid.shape = scene::Sphere{Positive(sphere->radius, kMaxLength, "sphere radius")};
  } else {
    Fail("found no shape, expected box, cylinder, sphere or mesh");
  }
  return solid;
}

Vector3 UrdfElement::ReadScale(const urdf::Mesh& mesh) const {
  const Vector3 scale(mesh.scale.x, mesh.scale.y, mesh.scale.z);
  for (double factor : scale) {
    Within(factor, -kMaxScale, kMaxScale, "mesh scale");
    if (factor == 0) Fail("mesh scale is 0, expected another number");
  }
  return scale;
}

Color UrdfElement::ReadColor(const urdf::Color& color) const {
  return {Within(color.r, 0, 1, "red"), Within(color.g, 0, 1, "green"),
          Within(color.b, 0, 1, "blue")};
}

void UrdfElement::ReadMotion(const urdf::Joint& joint, scene::LinkSpec* link) const {
  // Planar and floating joints have several degrees of freedom, which links here do not have.
  const bool is_continuous = joint.type == urdf::Joint::CONTINUOUS;
  const bool is_revolute = is_continuous || joint.type == urdf::Joint::REVOLUTE;
  if (!is_revolute && joint.type != urdf::Joint::PRISMATIC) {
    Fail("this type of joint is not supported, expected revolute, continuous, prismatic or fixed");
  }
  link->joint_type = is_revolute ? scene::JointType::kRevolute : scene::JointType::kPrismatic;

  const Vector3 axis(joint.axis.x, joint.axis.y, joint.axis.z);
  // Descriptions need not normalize the axis, but it must have a direction.
  if (!(axis.norm() > 1e-9 && axis.norm() < kMaxLength)) {
    Fail("axis has the length " + NumberText(axis.norm()) + ", expected a direction");
  }
  link->axis = axis.normalized();

  // URDF makes limits optional for continuous joints. Motors need speed and effort, which a side
  // file may give: CheckLimits() refuses joints that have none in the end.
  if (!joint.limits && !is_continuous) {
    Fail("has no <limit>, expected lower, upper, velocity and effort");
  }
  link->max_velocity = link->max_effort = std::numeric_limits<double>::infinity();
  if (joint.limits) {
    link->max_velocity = Positive(joint.limits->velocity, kMaxRate, "velocity limit");
    link->max_effort = Positive(joint.limits->effort, kMaxEffort, "effort limit");
  }
  // Wide limits instead of none: everything that uses limits then works unchanged.
  if (is_continuous) {
    link->lower = -kContinuous;
    link->upper = kContinuous;
    return;
  }
  const double reach = is_revolute ? kMaxAngle : kMaxLength;
  link->lower = Within(joint.limits->lower, -reach, reach, "lower limit");
  link->upper = Within(joint.limits->upper, -reach, reach, "upper limit");
  if (!(link->lower < link->upper)) {
    Fail("lower limit is " + NumberText(link->lower) + ", expected less than the upper, " +
         NumberText(link->upper));
  }
}

// Both comparisons are written so that NaN is outside.

double UrdfElement::Within(double value, double low, double high, const char* what) const {
  if (value >= low && value <= high) return value;
  Fail(std::string(what) + " is " + NumberText(value) + ", expected " + NumberText(low) + " to " +
       NumberText(high));
}

double UrdfElement::Positive(double value, double high, const char* what) const {
  if (value > 0 && value <= high) return value;
  Fail(std::string(what) + " is " + NumberText(value) + ", expected above 0 to " +
       NumberText(high));
}

}  // namespace smile::robot::internal
