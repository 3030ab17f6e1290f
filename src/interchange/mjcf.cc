#include "interchange/mjcf.h"

#include <optional>
#include <utility>

#include "base/wording.h"
#include "interchange/carried_body.h"
#include "interchange/internal_mjcf_robot.h"
#include "interchange/joint_forest.h"
#include "interchange/numbers.h"
#include "mechanics/rolling_friction.h"

namespace smile::interchange {
namespace {

constexpr double kTimeStep = 0.002;  ///< MuJoCo's own default [s]

/// Writer of a file of MuJoCo.
class MjcfText {
 public:
  explicit MjcfText(const ExportedWorld& world)
      : world_(world), forest_(ForestOf(world)), meshes_(world), geoms_(meshes_, &xml_) {
    if (world.robot) robot_.emplace(world, &geoms_, &xml_);
    xml_.Open("mujoco");
    xml_.Attribute("model", world.name.empty() ? "smile" : world.name);
    WriteLeftOut();
    WriteOptions();
    WriteMjcfAssets(meshes_, &xml_);
    WriteWorldBody();
    WriteContact();
    WriteEquality();
    if (robot_) robot_->WriteServos();
    xml_.Close();
  }

  ExportedText Take() { return {.text = xml_.Take(), .left_out = std::move(left_out_)}; }

 private:
  const ExportedBody& body(int index) const {
    return world_.bodies[static_cast<std::size_t>(index)];
  }
  const ExportedJoint& joint(int index) const {
    return world_.joints[static_cast<std::size_t>(index)];
  }

  void WriteLeftOut() {
    left_out_ = world_.left_out;
    for (const ExportedBody& one : world_.bodies) {
      const bool bounces = !one.is_static() && one.spec.restitution > 0;
      if (bounces) left_out_.push_back(Quoted(one.name) + ": it bounces");
    }
    if (HasUnequalFriction(world_)) {
      left_out_.push_back(
          "friction between bodies of different friction: MuJoCo takes the greater one, SMILE the "
          "product of both");
    }
    for (const int closing : forest_.closing) {
      if (std::holds_alternative<mechanics::SliderJointSpec>(joint(closing).spec)) {
        left_out_.push_back(Quoted(joint(closing).name) + ": a slider that closes a loop");
      }
    }
    for (const std::string& words : left_out_) xml_.Comment("left out: " + words);
  }

  void WriteOptions() {
    xml_.Open("compiler");
    xml_.Attribute("angle", "radian");
    xml_.Boolean("autolimits", true);
    xml_.Close();
    xml_.Open("option");
    xml_.Number("timestep", kTimeStep);
    xml_.Attribute("gravity", Numbers({0, 0, -world_.gravity}));
    // Elliptic cones and a high ratio of friction to normal impedance: stacks do not creep.
    xml_.Attribute("cone", "elliptic");
    xml_.Number("impratio", 10);
    xml_.Attribute("integrator", "implicitfast");
    xml_.Close();
  }

  void WriteWorldBody() {
    xml_.Open("worldbody");
    WriteLight();
    for (const ExportedCamera& camera : world_.cameras) {
      if (camera.link == -2) geoms_.WriteCamera(camera);
    }
    for (std::size_t body = 0; body < world_.bodies.size(); ++body) {
      if (forest_.nodes[body].parent < 0) WriteBody(static_cast<int>(body), RigidTransform());
    }
    if (robot_) robot_->WriteBodies();
    xml_.Close();
  }

  void WriteLight() {
    const scene::Lighting& light = world_.lighting;
    const double strength = 0.6 * light.brightness;
    xml_.Open("light");
    xml_.Boolean("directional", true);
    xml_.Attribute("pos", Numbers({0, 0, 3}));
    xml_.Attribute("dir", Numbers(LightDirectionOf(light)));
    xml_.Attribute("diffuse", Numbers({strength * light.color.red, strength * light.color.green,
                                       strength * light.color.blue}));
    xml_.Close();
  }

  /// @param X_WP  pose of the parent.
  void WriteBody(int index, const RigidTransform& X_WP) {
    const ExportedBody& one = body(index);
    const mechanics::BodySpec& spec = one.spec;
    xml_.Open("body");
    xml_.Attribute("name", one.name);
    geoms_.WritePose(X_WP.inverse() * spec.X_WB);
    const TreeNode& node = forest_.nodes[static_cast<std::size_t>(index)];
    if (node.joint >= 0) {
      WriteJoint(joint(node.joint), index);
    } else if (!one.is_static()) {
      xml_.Open("freejoint");
      xml_.Close();
    }
    if (!one.is_static()) geoms_.WriteInertial(spec.mass);
    const double rolling = mechanics::RollingFrictionOf(spec);
    for (const scene::Solid& solid : spec.solids) geoms_.WriteSolid(solid, spec.friction, rolling);
    for (const scene::Visual& visual : one.visuals) geoms_.WriteVisual(visual);
    for (std::size_t child = 0; child < forest_.nodes.size(); ++child) {
      if (forest_.nodes[child].parent == index) WriteBody(static_cast<int>(child), spec.X_WB);
    }
    xml_.Close();
  }

  /// Writes the joint that carries a body. A body without one is fixed on its parent.
  void WriteJoint(const ExportedJoint& held, int child) {
    if (const auto* ball = std::get_if<mechanics::BallJointSpec>(&held.spec)) {
      xml_.Open("joint");
      xml_.Attribute("name", held.name);
      xml_.Attribute("type", "ball");
      xml_.Attribute("pos", Numbers(held.a == child ? ball->p_AQ : ball->p_BQ));
      xml_.Close();
    } else if (const auto* slider = std::get_if<mechanics::SliderJointSpec>(&held.spec)) {
      const CarriedSlide slide = SlideOf(world_, held, child);
      xml_.Open("joint");
      xml_.Attribute("name", held.name);
      xml_.Attribute("type", "slide");
      xml_.Attribute("axis", Numbers(slide.axis_in_child));
      xml_.Attribute("range", Numbers({slider->lower, slider->upper}));
      xml_.Number("ref", slide.offset);
      if (slide.damping > 0) xml_.Number("damping", slide.damping);
      xml_.Close();
    }
  }

  // --- what joins bodies beside the tree

  void WriteContact() {
    xml_.Open("contact");
    for (const ExportedJoint& held : world_.joints) {
      if (!DoCollide(held.spec)) WriteExclude(body(held.a).name, body(held.b).name);
    }
    if (robot_) {
      for (const auto& [a, b] : world_.robot->spec->never_collide) {
        WriteExclude(robot_->NameOf(a), robot_->NameOf(b));
      }
    }
    xml_.Close();
  }

  void WriteExclude(const std::string& a, const std::string& b) {
    xml_.Open("exclude");
    xml_.Attribute("body1", a);
    xml_.Attribute("body2", b);
    xml_.Close();
  }

  void WriteEquality() {
    xml_.Open("equality");
    for (const int closing : forest_.closing) WriteClosing(joint(closing));
    if (robot_) robot_->WriteFollowers();
    xml_.Close();
  }

  void WriteClosing(const ExportedJoint& closing) {
    const auto* ball = std::get_if<mechanics::BallJointSpec>(&closing.spec);
    const auto* fixed = std::get_if<mechanics::FixedJointSpec>(&closing.spec);
    if (ball == nullptr && fixed == nullptr) return;
    xml_.Open(ball != nullptr ? "connect" : "weld");
    xml_.Attribute("name", closing.name);
    xml_.Attribute("body1", body(closing.a).name);
    xml_.Attribute("body2", body(closing.b).name);
    if (ball != nullptr) xml_.Attribute("anchor", Numbers(ball->p_AQ));
    // As stiff as the time step allows: strings hardly stretch.
    xml_.Attribute("solref", Numbers({2 * kTimeStep, 1}));
    xml_.Close();
  }

  const ExportedWorld& world_;
  JointForest forest_;
  MeshTable meshes_;
  xml::Writer xml_;
  MjcfGeoms geoms_;
  std::optional<MjcfRobot> robot_;
  std::vector<std::string> left_out_;
};

}  // namespace

ExportedText ToMjcf(const ExportedWorld& world) { return MjcfText(world).Take(); }

}  // namespace smile::interchange
