#include "interchange/usd.h"

#include <cmath>
#include <numbers>
#include <utility>

#include "base/wording.h"
#include "interchange/carried_body.h"
#include "interchange/internal_usd_bodies.h"
#include "interchange/linear_color.h"
#include "interchange/unique_names.h"
#include "mechanics/rolling_friction.h"
#include "sim/simulation.h"

namespace smile::interchange {
namespace {

/// A motor reaches its greatest force when its speed is wrong by this fraction of the greatest one.
constexpr double kDriveBand = 0.1;
/// Width of the cameras' film, in the unit of UsdGeomCamera: that of the format itself.
constexpr double kAperture = 20.955;
constexpr double kDegrees = 180 / std::numbers::pi;

/// Returns the metadata of the file.
std::vector<std::string> MetadataOf(const ExportedMotion& motion) {
  std::vector<std::string> lines{"defaultPrim = \"World\"", "kilogramsPerUnit = 1",
                                 "metersPerUnit = 1", "upAxis = \"Z\""};
  if (motion.is_animated()) {
    const double end = std::round(motion.seconds.back() * sim::kTicksPerSecond);
    lines.insert(lines.begin() + 1, "endTimeCode = " + NumberText(end));
    lines.emplace_back("startTimeCode = 0");
    lines.push_back("timeCodesPerSecond = " + NumberText(sim::kTicksPerSecond));
  }
  return lines;
}

/// Writer of a file of USD.
class UsdText {
 public:
  explicit UsdText(const ExportedScene& scene)
      : world_(scene.world),
        motion_(scene.motion),
        usd_(MetadataOf(scene.motion)),
        bodies_(scene.motion, &usd_) {
    ChooseNames();
    ListLeftOut();
    usd_.Open("Xform", "World");
    WriteLeftOut();
    WriteSurroundings();
    bodies_.WriteMaterials(world_);
    for (std::size_t body = 0; body < world_.bodies.size(); ++body) WriteBody(body);
    if (!motion_.is_animated()) {
      for (const ExportedJoint& joint : world_.joints) WriteJoint(joint);
    }
    if (world_.robot) WriteRobot();
    WriteCamerasOn(-2);
    usd_.Close();
  }

  ExportedText Take() { return {.text = usd_.Take(), .left_out = std::move(left_out_)}; }

 private:
  std::string TakeName(const std::string& wanted) {
    std::string taken = names_.Take(UsdName(wanted));
    if (taken != wanted) left_out_.push_back(Quoted(wanted) + ": is called " + Quoted(taken));
    return taken;
  }

  void ChooseNames() {
    for (const char* reserved : {"physics", "light", "materials", "robot"}) names_.Take(reserved);
    for (const ExportedBody& body : world_.bodies) body_names_.push_back(TakeName(body.name));
    if (!world_.robot) return;
    base_name_ = TakeName(world_.robot->base.name);
    for (const ExportedLink& link : world_.robot->links) {
      link_names_.push_back(TakeName(link.name));
    }
  }

  std::string PathOf(int body) const {
    return "</World/" + body_names_[static_cast<std::size_t>(body)] + ">";
  }
  /// @param link  -1: the base.
  std::string LinkPathOf(int link) const {
    return "</World/robot/" +
           (link < 0 ? base_name_ : link_names_[static_cast<std::size_t>(link)]) + ">";
  }

  void ListLeftOut() {
    left_out_.insert(left_out_.begin(), world_.left_out.begin(), world_.left_out.end());
    if (motion_.is_animated()) {
      left_out_.emplace_back("joints: bodies are kinematic and move as they were recorded");
      return;
    }
    if (HasUnequalFriction(world_)) {
      left_out_.emplace_back(
          "friction between bodies of different friction: programs combine it by rules of their "
          "own, SMILE takes the product of both");
    }
    for (const ExportedBody& body : world_.bodies) {
      if (!body.is_static() && mechanics::RollingFrictionOf(body.spec) > 0) {
        left_out_.push_back(Quoted(body.name) + ": its rolling friction");
      }
    }
    for (const ExportedJoint& joint : world_.joints) {
      const auto* slider = std::get_if<mechanics::SliderJointSpec>(&joint.spec);
      if (slider != nullptr && slider->damping > 0) {
        left_out_.push_back(Quoted(joint.name) + ": its damping");
      }
    }
    if (!world_.robot) return;
    left_out_.emplace_back("the robot's weight is not held up");
    for (const scene::LinkSpec& link : world_.robot->spec->links) {
      if (link.mimic)
        left_out_.push_back(Quoted(link.joint_name) + ": that it follows another joint");
    }
  }

  void WriteLeftOut() {
    std::string list;
    for (const std::string& words : left_out_)
      list += (list.empty() ? "" : ", ") + UsdString(words);
    usd_.Set("custom string[] smile:left_out", "[" + list + "]");
  }

  void WriteSurroundings() {
    usd_.Open("PhysicsScene", "physics");
    usd_.Set("vector3f physics:gravityDirection", "(0, 0, -1)");
    usd_.Set("float physics:gravityMagnitude", world_.gravity);
    usd_.Close();
    const scene::Lighting& light = world_.lighting;
    const auto [red, green, blue] = LinearOf(light.color);
    usd_.Open("DistantLight", "light");
    // Else a renderer would take it as the brightness of a disk as small as the sun.
    usd_.Set("bool inputs:normalize", "true");
    usd_.Set("float inputs:intensity", kIlluminance * light.brightness);
    usd_.Set("color3f inputs:color", UsdTuple(Vector3(red, green, blue)));
    // It shines along -z of its prim.
    usd_.SetPose(
        {Quaternion::FromTwoVectors(-Vector3::UnitZ(), LightDirectionOf(light)), Vector3::Zero()});
    usd_.Close();
  }

  void WriteBody(std::size_t index) {
    const ExportedBody& body = world_.bodies[index];
    bodies_.OpenBody(body_names_[index], body.spec.X_WB,
                     body.is_static() ? nullptr : &body.spec.mass, body.frame);
    bodies_.WriteSolids(body.spec.solids, body.spec.friction, body.spec.restitution);
    bodies_.WriteVisuals(body.frame);
    usd_.Close();
  }

  /// Writes a joint without its end: the frames that it holds together.
  void OpenJoint(const char* type, const std::string& name, const std::string& a,
                 const std::string& b, const RigidTransform& X_AJ, const RigidTransform& X_BK,
                 const std::vector<std::string_view>& schemas = {}) {
    usd_.Open(type, names_.Take(UsdName(name)), schemas);
    if (!a.empty()) usd_.Set("rel physics:body0", a);
    usd_.Set("rel physics:body1", b);
    usd_.Set("point3f physics:localPos0", UsdTuple(X_AJ.translation()));
    usd_.Set("quatf physics:localRot0", UsdTuple(X_AJ.quaternion()));
    usd_.Set("point3f physics:localPos1", UsdTuple(X_BK.translation()));
    usd_.Set("quatf physics:localRot1", UsdTuple(X_BK.quaternion()));
  }

  void WriteJoint(const ExportedJoint& joint) {
    const std::string a = PathOf(joint.a), b = PathOf(joint.b);
    if (const auto* fixed = std::get_if<mechanics::FixedJointSpec>(&joint.spec)) {
      OpenJoint("PhysicsFixedJoint", joint.name, a, b, fixed->X_AB, RigidTransform());
    } else if (const auto* ball = std::get_if<mechanics::BallJointSpec>(&joint.spec)) {
      OpenJoint("PhysicsSphericalJoint", joint.name, a, b, RigidTransform(ball->p_AQ),
                RigidTransform(ball->p_BQ));
    } else if (const auto* slider = std::get_if<mechanics::SliderJointSpec>(&joint.spec)) {
      OpenJoint("PhysicsPrismaticJoint", joint.name, a, b, slider->X_AJ, slider->X_BK);
      WriteLimits(slider->lower, slider->upper);
      if (slider->do_collide) usd_.Set("bool physics:collisionEnabled", "true");
    } else {
      return;
    }
    usd_.Close();
  }

  void WriteLimits(double lower, double upper) {
    usd_.Set("uniform token physics:axis", "\"X\"");
    usd_.Set("float physics:lowerLimit", lower);
    usd_.Set("float physics:upperLimit", upper);
  }

  // --- the robot and the cameras

  void WriteRobot() {
    const ExportedRobot& robot = *world_.robot;
    std::vector<std::string_view> schemas;
    if (!motion_.is_animated()) schemas.emplace_back("PhysicsArticulationRootAPI");
    usd_.Open("Xform", "robot", schemas);
    bodies_.OpenBody(base_name_, robot.spec->X_WBase, nullptr, robot.base.frame, FilterOf(-1));
    bodies_.WriteSolids(robot.spec->base_solids, scene::LinkSpec().friction, 0);
    bodies_.WriteVisuals(robot.base.frame);
    WriteCamerasOn(-1);
    usd_.Close();
    const std::vector<RigidTransform> X_WL = LinkPosesOf(robot);
    for (std::size_t link = 0; link < X_WL.size(); ++link) WriteLink(link, X_WL[link]);
    if (!motion_.is_animated()) {
      for (std::size_t link = 0; link < X_WL.size(); ++link) WriteMotor(link);
    }
    usd_.Close();
  }

  void WriteLink(std::size_t at, const RigidTransform& X_WL) {
    const scene::LinkSpec& link = world_.robot->spec->links[at];
    const scene::MassProperties mass{
        .mass = link.mass, .center = link.p_LLcm, .inertia = link.inertia};
    const int frame = world_.robot->links[at].frame;
    bodies_.OpenBody(link_names_[at], X_WL, &mass, frame, FilterOf(static_cast<int>(at)));
    bodies_.WriteSolids(link.solids, link.friction, 0);
    bodies_.WriteVisuals(frame);
    WriteCamerasOn(static_cast<int>(at));
    usd_.Close();
  }

  /// Writes the joint of a link, with the drive of its motor.
  void WriteMotor(std::size_t at) {
    const scene::LinkSpec& link = world_.robot->spec->links[at];
    const bool turns = link.joint_type == scene::JointType::kRevolute;
    // Joints of USD turn about an axis of their frame.
    const RigidTransform X_JA(Quaternion::FromTwoVectors(Vector3::UnitX(), link.axis),
                              Vector3::Zero());
    const std::string_view drive = turns ? "PhysicsDriveAPI:angular" : "PhysicsDriveAPI:linear";
    std::vector<std::string_view> schemas;
    if (!link.mimic) schemas.push_back(drive);
    OpenJoint(turns ? "PhysicsRevoluteJoint" : "PhysicsPrismaticJoint", link.joint_name,
              LinkPathOf(link.parent), LinkPathOf(static_cast<int>(at)), link.X_PJ * X_JA, X_JA,
              schemas);
    const double unit = turns ? kDegrees : 1;
    WriteLimits(link.lower * unit, link.upper * unit);
    if (!link.mimic) {
      const std::string prefix = turns ? "drive:angular:physics:" : "drive:linear:physics:";
      usd_.Set("uniform token " + prefix + "type", "\"force\"");
      usd_.Set("float " + prefix + "maxForce", link.max_effort);
      usd_.Set("float " + prefix + "damping",
               link.max_effort / (kDriveBand * link.max_velocity * unit));
      usd_.Set("float " + prefix + "targetVelocity", 0.0);
    }
    usd_.Close();
  }

  /// Returns the paths of the links that a link never collides with, each pair once.
  std::vector<std::string> FilterOf(int link) const {
    std::vector<std::string> paths;
    for (const auto& [a, b] : world_.robot->spec->never_collide) {
      if (a == link) paths.push_back(LinkPathOf(b));
    }
    return paths;
  }

  /// @param link  of the robot; -1: its base; -2: the world.
  void WriteCamerasOn(int link) {
    for (const ExportedCamera& camera : world_.cameras) {
      if (camera.link == link) WriteCamera(camera);
    }
  }

  void WriteCamera(const ExportedCamera& camera) {
    // Cameras of USD have y up and look along -z.
    const RigidTransform X_CU(Matrix3(Vector3(1, -1, -1).asDiagonal()), Vector3::Zero());
    const CameraIntrinsics& optics = camera.intrinsics;
    usd_.Open("Camera", names_.Take(UsdName(camera.name)));
    usd_.Set("float horizontalAperture", kAperture);
    usd_.Set("float verticalAperture", kAperture * optics.height_px / optics.width_px);
    usd_.Set("float focalLength", kAperture * optics.fx / optics.width_px);
    usd_.Set("float2 clippingRange",
             "(" + NumberText(optics.near) + ", " + NumberText(optics.far) + ")");
    usd_.SetPose(camera.X_FC * X_CU);
    usd_.Close();
  }

  const ExportedWorld& world_;
  const ExportedMotion& motion_;
  UsdWriter usd_;
  UsdBodies bodies_;
  UniqueNames names_;
  std::vector<std::string> body_names_, link_names_, left_out_;
  std::string base_name_;
};

}  // namespace

ExportedText ToUsd(const ExportedScene& scene) { return UsdText(scene).Take(); }

}  // namespace smile::interchange
