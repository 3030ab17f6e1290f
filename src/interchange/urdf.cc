#include "interchange/urdf.h"

#include <cmath>
#include <utility>

#include "base/overloaded.h"
#include "base/wording.h"
#include "interchange/carried_body.h"
#include "interchange/joint_forest.h"
#include "interchange/mesh_files.h"
#include "interchange/numbers.h"
#include "interchange/unique_names.h"
#include "xml/writer.h"

namespace smile::interchange {
namespace {

constexpr const char* kWorld = "world";  ///< the link from which the tree grows

/// Returns roll, pitch and yaw about fixed axes [rad]: R = Rz(yaw) Ry(pitch) Rx(roll).
Vector3 RollPitchYaw(const Matrix3& R) {
  const double pitch = std::atan2(-R(2, 0), std::hypot(R(0, 0), R(1, 0)));
  // Straight up or down only the difference of roll and yaw matters.
  if (std::hypot(R(0, 0), R(1, 0)) < 1e-9) return {std::atan2(-R(1, 2), R(1, 1)), pitch, 0};
  return {std::atan2(R(2, 1), R(2, 2)), pitch, std::atan2(R(1, 0), R(0, 0))};
}

/// Joint from a link to its parent, as URDF has it.
struct UrdfJoint {
  std::string name, type, parent, child;
  RigidTransform X_PC;  ///< at position 0
  Vector3 axis = Vector3::UnitX();
  double lower = 0, upper = 0;  ///< with axis
};

/// Writer of a file of URDF.
class UrdfText {
 public:
  UrdfText(const ExportedWorld& world, const std::string& mesh_folder)
      : world_(world), forest_(ForestOf(world)), meshes_(world), mesh_folder_(mesh_folder) {
    names_.Take(kWorld);
    for (const ExportedBody& body : world.bodies) body_names_.push_back(TakeName(body.name));
    ListLeftOut();
    xml_.Open("robot");
    xml_.Attribute("name", world.name.empty() ? "smile" : world.name);
    for (const std::string& words : left_out_) xml_.Comment("left out: " + words);
    xml_.Open("link");
    xml_.Attribute("name", kWorld);
    xml_.Close();
    for (const int body : forest_.order) WriteBody(body);
    if (world.robot) WriteRobot();
    xml_.Close();
  }

  ExportedText Take() {
    return {.text = xml_.Take(),
            .files = MeshFilesOf(meshes_, mesh_folder_),
            .left_out = std::move(left_out_)};
  }

 private:
  const ExportedBody& body(int index) const {
    return world_.bodies[static_cast<std::size_t>(index)];
  }
  const std::string& name(int index) const { return body_names_[static_cast<std::size_t>(index)]; }

  std::string TakeName(const std::string& wanted) {
    std::string taken = names_.Take(wanted);
    if (taken != wanted) left_out_.push_back(Quoted(wanted) + ": is called " + Quoted(taken));
    return taken;
  }

  void ListLeftOut() {
    left_out_.insert(left_out_.begin(), world_.left_out.begin(), world_.left_out.end());
    left_out_.emplace_back("friction, restitution, gravity, light and cameras: URDF has none");
    for (const int closing : forest_.closing) {
      left_out_.push_back(Quoted(world_.joints[static_cast<std::size_t>(closing)].name) +
                          ": a joint that closes a loop");
    }
    for (const TreeNode& node : forest_.nodes) {
      if (node.joint < 0) continue;
      const ExportedJoint& joint = world_.joints[static_cast<std::size_t>(node.joint)];
      if (std::holds_alternative<mechanics::BallJointSpec>(joint.spec)) {
        left_out_.push_back(Quoted(joint.name) + ": a ball joint; its bodies are free");
      }
    }
    if (world_.robot) left_out_.emplace_back("the robot's weight is not held up");
  }

  // --- links

  void WriteOrigin(const RigidTransform& X) {
    xml_.Open("origin");
    xml_.Attribute("xyz", Numbers(X.translation()));
    xml_.Attribute("rpy", Numbers(RollPitchYaw(X.rotation())));
    xml_.Close();
  }

  void WriteInertial(const scene::MassProperties& mass) {
    const Matrix3& I = mass.inertia;
    xml_.Open("inertial");
    WriteOrigin(RigidTransform(mass.center));
    xml_.Open("mass");
    xml_.Number("value", mass.mass);
    xml_.Close();
    xml_.Open("inertia");
    xml_.Number("ixx", I(0, 0));
    xml_.Number("ixy", I(0, 1));
    xml_.Number("ixz", I(0, 2));
    xml_.Number("iyy", I(1, 1));
    xml_.Number("iyz", I(1, 2));
    xml_.Number("izz", I(2, 2));
    xml_.Close();
    xml_.Close();
  }

  /// Writes pose and geometry of a shape.
  void WriteShape(const scene::VisualShape& shape, const RigidTransform& X_LG) {
    WriteOrigin(std::holds_alternative<scene::Cylinder>(shape) ? X_LG * CylinderAlongZ() : X_LG);
    xml_.Open("geometry");
    std::visit(Overloaded{[&](const scene::Block& block) {
                            xml_.Open("box");
                            xml_.Attribute("size", Numbers(block.size));
                          },
                          [&](const scene::Cylinder& cylinder) {
                            xml_.Open("cylinder");
                            xml_.Number("radius", cylinder.radius);
                            xml_.Number("length", cylinder.length);
                          },
                          [&](const scene::Sphere& sphere) {
                            xml_.Open("sphere");
                            xml_.Number("radius", sphere.radius);
                          },
                          [&](const auto& mesh) {
                            xml_.Open("mesh");
                            xml_.Attribute("filename",
                                           MeshFileName(mesh_folder_, meshes_.NameOf(mesh)));
                          }},
               shape);
    xml_.Close();
    xml_.Close();
  }

  /// @param mass  nullptr: of a link that never moves.
  void WriteLink(const std::string& link, const scene::MassProperties* mass,
                 const std::vector<scene::Solid>& solids,
                 const std::vector<scene::Visual>& visuals) {
    xml_.Open("link");
    xml_.Attribute("name", link);
    if (mass != nullptr) WriteInertial(*mass);
    for (const scene::Solid& solid : solids) {
      xml_.Open("collision");
      WriteShape(scene::VisualShapeOf(solid.shape), solid.X_BS);
      xml_.Close();
    }
    for (const scene::Visual& visual : visuals) {
      xml_.Open("visual");
      WriteShape(visual.shape, visual.X_FV);
      xml_.Open("material");
      xml_.Attribute("name", ToString(visual.color));
      xml_.Open("color");
      xml_.Attribute("rgba", Numbers({visual.color.red, visual.color.green, visual.color.blue, 1}));
      xml_.Close();
      xml_.Close();
      xml_.Close();
    }
    xml_.Close();
  }

  /// Writes a joint.
  /// @param link  of the robot, with limits of its motor; nullptr: without a motor.
  void WriteJoint(const UrdfJoint& joint, const scene::LinkSpec* link = nullptr) {
    xml_.Open("joint");
    xml_.Attribute("name", joint.name);
    xml_.Attribute("type", joint.type);
    WriteOrigin(joint.X_PC);
    xml_.Open("parent");
    xml_.Attribute("link", joint.parent);
    xml_.Close();
    xml_.Open("child");
    xml_.Attribute("link", joint.child);
    xml_.Close();
    if (joint.type == "prismatic" || joint.type == "revolute") WriteAxis(joint, link);
    if (link != nullptr && link->mimic) {
      // Both count from where they are now, so there is no offset.
      xml_.Open("mimic");
      xml_.Attribute("joint", joint_names_[static_cast<std::size_t>(link->mimic->leader)]);
      xml_.Number("multiplier", link->mimic->multiplier);
      xml_.Close();
    }
    xml_.Close();
  }

  void WriteAxis(const UrdfJoint& joint, const scene::LinkSpec* link) {
    xml_.Open("axis");
    xml_.Attribute("xyz", Numbers(joint.axis));
    xml_.Close();
    xml_.Open("limit");
    xml_.Number("lower", joint.lower);
    xml_.Number("upper", joint.upper);
    // The format demands both.
    xml_.Number("effort", link != nullptr ? link->max_effort : 0);
    xml_.Number("velocity", link != nullptr ? link->max_velocity : 0);
    xml_.Close();
  }

  // --- objects and robot

  void WriteBody(int index) {
    const ExportedBody& one = body(index);
    WriteLink(name(index), one.is_static() ? nullptr : &one.spec.mass, one.spec.solids,
              one.visuals);
    const TreeNode& node = forest_.nodes[static_cast<std::size_t>(index)];
    UrdfJoint on_world{.name = joints_.Take(name(index) + "_on_world"),
                       .type = one.is_static() ? "fixed" : "floating",
                       .parent = kWorld,
                       .child = name(index),
                       .X_PC = one.spec.X_WB};
    if (node.joint < 0) return WriteJoint(on_world);
    const ExportedJoint& held = world_.joints[static_cast<std::size_t>(node.joint)];
    if (std::holds_alternative<mechanics::BallJointSpec>(held.spec)) return WriteJoint(on_world);
    UrdfJoint joint{.name = joints_.Take(held.name),
                    .type = "fixed",
                    .parent = name(node.parent),
                    .child = name(index),
                    .X_PC = body(node.parent).spec.X_WB.inverse() * one.spec.X_WB};
    if (const auto* slider = std::get_if<mechanics::SliderJointSpec>(&held.spec)) {
      const CarriedSlide slide = SlideOf(world_, held, index);
      joint.type = "prismatic";
      joint.axis = slide.axis_in_child;
      joint.lower = slider->lower - slide.offset;
      joint.upper = slider->upper - slide.offset;
    }
    WriteJoint(joint);
  }

  void WriteRobot() {
    const ExportedRobot& robot = *world_.robot;
    const std::string base = names_.Take(robot.base.name);
    WriteLink(base, nullptr, robot.spec->base_solids, robot.base.visuals);
    WriteJoint({.name = joints_.Take(base + "_on_world"),
                .type = "fixed",
                .parent = kWorld,
                .child = base,
                .X_PC = robot.spec->X_WBase});
    std::vector<std::string> link_names;
    // Joints have names of their own in URDF, and keep them.
    for (const ExportedLink& link : robot.links) link_names.push_back(names_.Take(link.name));
    for (const scene::LinkSpec& link : robot.spec->links) {
      joint_names_.push_back(joints_.Take(link.joint_name));
    }
    for (std::size_t at = 0; at < link_names.size(); ++at) {
      const scene::LinkSpec& link = robot.spec->links[at];
      const scene::MassProperties mass{
          .mass = link.mass, .center = link.p_LLcm, .inertia = link.inertia};
      WriteLink(link_names[at], &mass, link.solids, robot.links[at].visuals);
      const double q = robot.q[at];
      const bool turns = link.joint_type == scene::JointType::kRevolute;
      WriteJoint(
          {.name = joint_names_[at],
           .type = turns ? "revolute" : "prismatic",
           .parent = link.parent < 0 ? base : link_names[static_cast<std::size_t>(link.parent)],
           .child = link_names[at],
           .X_PC = PoseInParent(link, q),
           .axis = link.axis,
           .lower = link.lower - q,
           .upper = link.upper - q},
          &link);
    }
  }

  const ExportedWorld& world_;
  JointForest forest_;
  MeshTable meshes_;
  std::string mesh_folder_;
  xml::Writer xml_;
  UniqueNames names_, joints_;
  std::vector<std::string> body_names_, joint_names_, left_out_;
};

}  // namespace

ExportedText ToUrdf(const ExportedWorld& world, const std::string& mesh_folder) {
  return UrdfText(world, mesh_folder).Take();
}

}  // namespace smile::interchange
