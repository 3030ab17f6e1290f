#include "interchange/sdf.h"

#include <algorithm>
#include <utility>

#include "base/wording.h"
#include "interchange/carried_body.h"
#include "interchange/internal_sdf_links.h"
#include "interchange/joint_forest.h"
#include "interchange/mesh_files.h"
#include "interchange/numbers.h"
#include "interchange/unique_names.h"
#include "mechanics/rolling_friction.h"

namespace smile::interchange {
namespace {

/// Returns a name as SDFormat allows it: `::` separates scopes, and names between double
/// underscores are reserved.
std::string AllowedName(std::string name) {
  std::ranges::replace(name, ':', '_');
  if (name.starts_with("__") && name.ends_with("__")) name = "a" + name;
  return name.empty() ? "unnamed" : name;
}

/// Writer of a file of SDFormat.
class SdfText {
 public:
  SdfText(const ExportedWorld& world, const std::string& mesh_folder)
      : world_(world),
        forest_(ForestOf(world)),
        meshes_(world),
        links_(meshes_, mesh_folder, &xml_) {
    ChooseNames();
    xml_.Open("sdf");
    xml_.Attribute("version", "1.9");
    WriteLeftOut();
    xml_.Open("world");
    xml_.Attribute("name", world.name.empty() ? "smile" : AllowedName(world.name));
    WriteSurroundings();
    for (const std::vector<int>& group : GroupsOf(world)) WriteModel(group);
    if (world.robot) WriteRobot();
    WriteWorldCameras();
    xml_.Close();
    xml_.Close();
    files_ = MeshFilesOf(meshes_, mesh_folder);
  }

  ExportedText Take() {
    return {.text = xml_.Take(), .files = std::move(files_), .left_out = std::move(left_out_)};
  }

 private:
  const ExportedBody& body(int index) const {
    return world_.bodies[static_cast<std::size_t>(index)];
  }
  const std::string& name(int index) const { return names_[static_cast<std::size_t>(index)]; }

  std::string TakeName(UniqueNames* scope, const std::string& wanted) {
    std::string taken = scope->Take(AllowedName(wanted));
    if (taken != wanted) renamed_.push_back(Quoted(wanted) + ": is called " + Quoted(taken));
    return taken;
  }

  void ChooseNames() {
    // A link of this name would be taken for the world.
    parts_.Take("world");
    for (const ExportedBody& one : world_.bodies) names_.push_back(TakeName(&parts_, one.name));
    if (!world_.robot) return;
    base_name_ = TakeName(&parts_, world_.robot->base.name);
    for (const ExportedLink& link : world_.robot->links) {
      link_names_.push_back(TakeName(&parts_, link.name));
    }
    for (const scene::LinkSpec& link : world_.robot->spec->links) {
      joint_names_.push_back(TakeName(&parts_, link.joint_name));
    }
  }

  void WriteLeftOut() {
    left_out_ = world_.left_out;
    left_out_.insert(left_out_.end(), renamed_.begin(), renamed_.end());
    if (HasUnequalFriction(world_)) {
      left_out_.push_back(
          "friction between bodies of different friction: Gazebo takes the smaller one, SMILE the "
          "product of both");
    }
    for (const ExportedBody& one : world_.bodies) {
      if (!one.is_static() && mechanics::RollingFrictionOf(one.spec) > 0) {
        left_out_.push_back(Quoted(one.name) + ": its rolling friction");
      }
    }
    for (const ExportedJoint& joint : world_.joints) {
      if (DoCollide(joint.spec)) {
        left_out_.push_back(Quoted(joint.name) + ": its bodies do not collide with each other");
      }
    }
    if (world_.robot) ListRobot();
    for (const std::string& words : left_out_) xml_.Comment("left out: " + words);
  }

  void ListRobot() {
    left_out_.push_back("the robot's motors: Gazebo has them as plugins");
    for (const scene::LinkSpec& link : world_.robot->spec->links) {
      if (!link.mimic) continue;
      const auto leader = static_cast<std::size_t>(link.mimic->leader);
      left_out_.push_back(Quoted(link.joint_name) + ": that it follows " +
                          Quoted(world_.robot->spec->links[leader].joint_name));
    }
  }

  void WriteSurroundings() {
    xml_.Open("physics");
    xml_.Attribute("name", "default");
    xml_.Boolean("default", true);
    xml_.Attribute("type", "ode");
    // Of the format's own examples.
    xml_.TextElement("max_step_size", "0.001");
    xml_.TextElement("real_time_factor", "1");
    xml_.Close();
    xml_.TextElement("gravity", Numbers({0, 0, -world_.gravity}));
    const scene::Lighting& light = world_.lighting;
    const double strength = 0.8 * light.brightness;
    xml_.Open("light");
    xml_.Attribute("name", models_.Take("light"));
    xml_.Attribute("type", "directional");
    xml_.TextElement("cast_shadows", "true");
    xml_.TextElement("diffuse", Numbers({strength * light.color.red, strength * light.color.green,
                                         strength * light.color.blue, 1}));
    xml_.TextElement("direction", Numbers(LightDirectionOf(light)));
    xml_.Close();
  }

  // --- objects

  void WriteModel(const std::vector<int>& group) {
    const bool is_static = std::ranges::all_of(group, [&](int i) { return body(i).is_static(); });
    xml_.Open("model");
    xml_.Attribute("name", models_.Take(name(group.front())));
    if (is_static) xml_.TextElement("static", "true");
    for (const int index : group) {
      WriteBody(index);
      if (body(index).is_static() && !is_static) WriteOnWorld(name(index));
    }
    for (const ExportedJoint& joint : world_.joints) {
      if (std::ranges::count(group, joint.a) > 0) WriteJoint(joint);
    }
    xml_.Close();
  }

  void WriteBody(int index) {
    const ExportedBody& one = body(index);
    xml_.Open("link");
    xml_.Attribute("name", name(index));
    links_.WritePose(one.spec.X_WB);
    if (!one.is_static()) links_.WriteInertial(one.spec.mass);
    links_.WriteSolids(one.spec.solids, one.spec.friction, one.spec.restitution);
    links_.WriteVisuals(one.visuals);
    xml_.Close();
  }

  void OpenJoint(const std::string& joint_name, const char* type, const std::string& parent,
                 const std::string& child) {
    xml_.Open("joint");
    xml_.Attribute("name", joint_name);
    xml_.Attribute("type", type);
    xml_.TextElement("parent", parent);
    xml_.TextElement("child", child);
  }

  void WriteOnWorld(const std::string& link) {
    OpenJoint(parts_.Take(link + "_on_world"), "fixed", "world", link);
    xml_.Close();
  }

  /// Writes a joint; in a tree of bodies, its child is the one that it carries.
  void WriteJoint(const ExportedJoint& joint) {
    const TreeNode& node = forest_.nodes[static_cast<std::size_t>(joint.a)];
    const bool is_a =
        node.joint >= 0 && &joint == &world_.joints[static_cast<std::size_t>(node.joint)];
    const int child = is_a ? joint.a : joint.b;
    const auto* ball = std::get_if<mechanics::BallJointSpec>(&joint.spec);
    const auto* slider = std::get_if<mechanics::SliderJointSpec>(&joint.spec);
    OpenJoint(parts_.Take(AllowedName(joint.name)),
              ball != nullptr     ? "ball"
              : slider != nullptr ? "prismatic"
                                  : "fixed",
              name(is_a ? joint.b : joint.a), name(child));
    if (ball != nullptr) links_.WritePose(RigidTransform(is_a ? ball->p_AQ : ball->p_BQ));
    if (slider != nullptr) {
      const CarriedSlide slide = SlideOf(world_, joint, child);
      WriteAxis(slide.axis_in_child, slider->lower - slide.offset, slider->upper - slide.offset,
                slide.damping, nullptr);
    }
    xml_.Close();
  }

  /// @param link  of the robot, with limits of a motor; nullptr: no motor.
  void WriteAxis(const Vector3& axis, double lower, double upper, double damping,
                 const scene::LinkSpec* link) {
    xml_.Open("axis");
    xml_.TextElement("xyz", Numbers(axis));
    xml_.Open("limit");
    xml_.TextElement("lower", NumberText(lower));
    xml_.TextElement("upper", NumberText(upper));
    if (link != nullptr) {
      xml_.TextElement("effort", NumberText(link->max_effort));
      xml_.TextElement("velocity", NumberText(link->max_velocity));
    }
    xml_.Close();
    if (damping > 0) {
      xml_.Open("dynamics");
      xml_.TextElement("damping", NumberText(damping));
      xml_.Close();
    }
    xml_.Close();
  }

  // --- the robot and the cameras

  void WriteRobot() {
    const ExportedRobot& robot = *world_.robot;
    xml_.Open("model");
    xml_.Attribute("name", models_.Take("robot"));
    xml_.Open("link");
    xml_.Attribute("name", base_name_);
    links_.WritePose(robot.spec->X_WBase);
    links_.WriteSolids(robot.spec->base_solids, scene::LinkSpec().friction, 0);
    links_.WriteVisuals(robot.base.visuals);
    WriteCamerasOn(-1);
    xml_.Close();
    WriteOnWorld(base_name_);
    const std::vector<RigidTransform> X_WL = LinkPosesOf(robot);
    for (std::size_t link = 0; link < X_WL.size(); ++link) WriteLink(link, X_WL[link]);
    xml_.Close();
  }

  void WriteLink(std::size_t at, const RigidTransform& X_WL) {
    const scene::LinkSpec& link = world_.robot->spec->links[at];
    xml_.Open("link");
    xml_.Attribute("name", link_names_[at]);
    links_.WritePose(X_WL);
    // The real robot's controllers hold up its own weight; so do SMILE's motors.
    xml_.TextElement("gravity", "false");
    links_.WriteInertial({.mass = link.mass, .center = link.p_LLcm, .inertia = link.inertia});
    links_.WriteSolids(link.solids, link.friction, 0);
    links_.WriteVisuals(world_.robot->links[at].visuals);
    WriteCamerasOn(static_cast<int>(at));
    xml_.Close();
    const bool turns = link.joint_type == scene::JointType::kRevolute;
    OpenJoint(joint_names_[at], turns ? "revolute" : "prismatic",
              link.parent < 0 ? base_name_ : link_names_[static_cast<std::size_t>(link.parent)],
              link_names_[at]);
    const double q = world_.robot->q[at];
    WriteAxis(link.axis, link.lower - q, link.upper - q, 0, &link);
    xml_.Close();
  }

  /// @param link  of the robot; -1: its base; -2: the world.
  void WriteCamerasOn(int link) {
    for (const ExportedCamera& camera : world_.cameras) {
      if (camera.link == link) links_.WriteCamera(camera, cameras_.Take(AllowedName(camera.name)));
    }
  }

  void WriteWorldCameras() {
    if (std::ranges::none_of(world_.cameras, [](const auto& c) { return c.link == -2; })) return;
    xml_.Open("model");
    xml_.Attribute("name", models_.Take("cameras"));
    xml_.TextElement("static", "true");
    xml_.Open("link");
    xml_.Attribute("name", "cameras");
    WriteCamerasOn(-2);
    xml_.Close();
    xml_.Close();
  }

  const ExportedWorld& world_;
  JointForest forest_;
  MeshTable meshes_;
  xml::Writer xml_;
  SdfLinks links_;
  UniqueNames models_, parts_, cameras_;
  std::vector<std::string> names_;  ///< of bodies
  std::string base_name_;           ///< of the robot, as the next two
  std::vector<std::string> link_names_, joint_names_;
  std::vector<std::string> renamed_, left_out_;
  std::vector<std::pair<std::string, std::string>> files_;
};

}  // namespace

ExportedText ToSdf(const ExportedWorld& world, const std::string& mesh_folder) {
  return SdfText(world, mesh_folder).Take();
}

}  // namespace smile::interchange
