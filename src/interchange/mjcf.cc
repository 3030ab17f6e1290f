#include "interchange/mjcf.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <map>
#include <numbers>
#include <utility>

#include "base/overloaded.h"
#include "base/wording.h"
#include "interchange/joint_forest.h"
#include "mechanics/rolling_friction.h"
#include "xml/writer.h"

namespace smile::interchange {
namespace {

constexpr double kTimeStep = 0.002;  ///< MuJoCo's own default [s]
/// The servo of a joint reaches its greatest force when its speed is wrong by this fraction of the
/// greatest one.
constexpr double kServoBand = 0.1;

std::string Numbers(std::initializer_list<double> numbers) {
  std::string text;
  // Adding 0 makes -0 a plain 0.
  for (const double number : numbers) text += (text.empty() ? "" : " ") + NumberText(number + 0.0);
  return text;
}

std::string Numbers(const Vector3& v) { return Numbers({v.x(), v.y(), v.z()}); }

/// Cylinders lie along y here, and along z there.
RigidTransform AlongZ() {
  return {Quaternion(Eigen::AngleAxisd(-std::numbers::pi / 2, Vector3::UnitX())), Vector3::Zero()};
}

/// Writer of a file of MuJoCo.
class MjcfText {
 public:
  explicit MjcfText(const ExportedWorld& world) : world_(world), forest_(ForestOf(world)) {
    CollectMeshes();
    xml_.Open("mujoco");
    xml_.Attribute("model", world.name.empty() ? "smile" : world.name);
    WriteLeftOut();
    WriteOptions();
    WriteAssets();
    xml_.Open("worldbody");
    WriteLight();
    for (const ExportedCamera& camera : world.cameras) {
      if (camera.link == -2) WriteCamera(camera);
    }
    for (std::size_t body = 0; body < world.bodies.size(); ++body) {
      if (forest_.nodes[body].parent < 0) WriteBody(static_cast<int>(body), RigidTransform());
    }
    if (world.robot) WriteRobot();
    xml_.Close();
    WriteConstraints();
    xml_.Close();
  }

  ExportedText Take() { return {xml_.Take(), std::move(left_out_)}; }

 private:
  const ExportedBody& body(int index) const {
    return world_.bodies[static_cast<std::size_t>(index)];
  }
  const ExportedJoint& joint(int index) const {
    return world_.joints[static_cast<std::size_t>(index)];
  }

  // --- what the file has in one place for all bodies

  void CollectMeshes() {
    const auto collect = [this](const std::vector<scene::Visual>& visuals) {
      for (const scene::Visual& visual : visuals) {
        if (const auto* hull = std::get_if<scene::Hull>(&visual.shape)) NameOf(*hull);
        if (const auto* mesh = std::get_if<scene::DrawnMesh>(&visual.shape)) NameOf(*mesh);
      }
    };
    const auto collect_solids = [this](const std::vector<scene::Solid>& solids) {
      for (const scene::Solid& solid : solids) {
        if (const auto* hull = std::get_if<scene::Hull>(&solid.shape)) NameOf(*hull);
      }
    };
    for (const ExportedBody& one : world_.bodies) {
      collect_solids(one.spec.solids);
      collect(one.visuals);
    }
    if (!world_.robot) return;
    collect_solids(world_.robot->spec->base_solids);
    collect(world_.robot->base.visuals);
    for (const scene::LinkSpec& link : world_.robot->spec->links) collect_solids(link.solids);
    for (const ExportedLink& link : world_.robot->links) collect(link.visuals);
  }

  const std::string& NameOf(const scene::Hull& hull) {
    const auto [found, is_new] = hulls_.try_emplace(hull);
    if (is_new) found->second = "hull_" + std::to_string(hulls_.size());
    return found->second;
  }

  const std::string& NameOf(const scene::DrawnMesh& mesh) {
    const auto [found, is_new] = meshes_.try_emplace({mesh.mesh.get(), mesh.scale});
    if (is_new) found->second = "mesh_" + std::to_string(meshes_.size());
    return found->second;
  }

  void WriteLeftOut() {
    left_out_ = world_.left_out;
    double least = 1e9, greatest = 0;
    for (const ExportedBody& one : world_.bodies) {
      least = std::min(least, one.spec.friction);
      greatest = std::max(greatest, one.spec.friction);
      const bool bounces = !one.is_static() && one.spec.restitution > 0;
      if (bounces) left_out_.push_back(Quoted(one.name) + ": it bounces");
    }
    if (least < greatest) {
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

  void WriteAssets() {
    if (hulls_.empty() && meshes_.empty()) return;
    xml_.Open("asset");
    for (const auto& [hull, name] : hulls_) {
      std::string corners;
      for (const Vector3& corner : hull.polyhedron().corners) corners += Numbers(corner) + " ";
      WriteMesh(name, "convex", corners, "");
    }
    for (const auto& [key, name] : meshes_) {
      const auto& [mesh, scale] = key;
      std::string vertices, faces;
      for (const auto& vertex : mesh->surface.vertices) {
        vertices += Numbers(Vector3(vertex.cast<double>() * scale)) + " ";
      }
      for (const auto& triangle : mesh->surface.triangles) {
        for (const std::uint32_t corner : triangle) faces += std::to_string(corner) + " ";
      }
      // It only is drawn, and need not be closed.
      WriteMesh(name, "shell", vertices, faces);
    }
    xml_.Close();
  }

  void WriteMesh(const std::string& name, const char* inertia, std::string vertices,
                 std::string faces) {
    vertices.pop_back();
    xml_.Open("mesh");
    xml_.Attribute("name", name);
    xml_.Attribute("inertia", inertia);
    xml_.Attribute("vertex", vertices);
    if (!faces.empty()) {
      faces.pop_back();
      xml_.Attribute("face", faces);
    }
    xml_.Close();
  }

  void WriteLight() {
    const scene::Lighting& light = world_.lighting;
    const double strength = 0.6 * light.brightness;
    xml_.Open("light");
    xml_.Boolean("directional", true);
    xml_.Attribute("pos", Numbers({0, 0, 3}));
    const Eigen::AngleAxisd turn(light.turn, Vector3::UnitZ());
    xml_.Attribute("dir", Numbers(Vector3(turn * Vector3(0.3, 0.4, -1))));
    xml_.Attribute("diffuse", Numbers({strength * light.color.red, strength * light.color.green,
                                       strength * light.color.blue}));
    xml_.Close();
  }

  // --- bodies

  void WritePose(const RigidTransform& X) {
    xml_.Attribute("pos", Numbers(X.translation()));
    const Quaternion q = X.quaternion();
    xml_.Attribute("quat", Numbers({q.w(), q.x(), q.y(), q.z()}));
  }

  void WriteCamera(const ExportedCamera& camera) {
    // MuJoCo's cameras have y up and look along -z.
    const RigidTransform X_CM(Matrix3(Vector3(1, -1, -1).asDiagonal()), Vector3::Zero());
    const CameraIntrinsics& optics = camera.intrinsics;
    xml_.Open("camera");
    xml_.Attribute("name", camera.name);
    WritePose(camera.X_FC * X_CM);
    const double angle = 2 * std::atan(optics.height_px / (2 * optics.fy));
    // Degrees, whatever the compiler's angles are.
    xml_.Number("fovy", angle * 180 / std::numbers::pi);
    xml_.Attribute("resolution",
                   std::to_string(optics.width_px) + " " + std::to_string(optics.height_px));
    xml_.Close();
  }

  void WriteInertial(const scene::MassProperties& mass) {
    const Matrix3& I = mass.inertia;
    xml_.Open("inertial");
    xml_.Attribute("pos", Numbers(mass.center));
    xml_.Number("mass", mass.mass);
    xml_.Attribute("fullinertia", Numbers({I(0, 0), I(1, 1), I(2, 2), I(0, 1), I(0, 2), I(1, 2)}));
    xml_.Close();
  }

  void WriteShape(const scene::VisualShape& shape, const RigidTransform& X_BG) {
    RigidTransform X = X_BG;
    std::visit(Overloaded{[&](const scene::Block& block) {
                            xml_.Attribute("type", "box");
                            xml_.Attribute("size", Numbers(Vector3(block.size / 2)));
                          },
                          [&](const scene::Cylinder& cylinder) {
                            xml_.Attribute("type", "cylinder");
                            xml_.Attribute("size", Numbers({cylinder.radius, cylinder.length / 2}));
                            X = X_BG * AlongZ();
                          },
                          [&](const scene::Sphere& sphere) {
                            xml_.Attribute("type", "sphere");
                            xml_.Attribute("size", NumberText(sphere.radius));
                          },
                          [&](const auto& mesh) {
                            xml_.Attribute("type", "mesh");
                            xml_.Attribute("mesh", NameOf(mesh));
                          }},
               shape);
    WritePose(X);
  }

  /// @param rolling  [m]
  void WriteSolid(const scene::Solid& solid, double friction, double rolling) {
    xml_.Open("geom");
    WriteShape(scene::VisualShapeOf(solid.shape), solid.X_BS);
    xml_.Count("group", 3);
    xml_.Attribute("rgba", Numbers({solid.color.red, solid.color.green, solid.color.blue, 0.5}));
    // Contacts of SMILE have the product of both frictions.
    if (rolling > 0) xml_.Count("condim", 6);
    xml_.Attribute("friction", Numbers({friction * friction, 0, rolling}));
    xml_.Close();
  }

  void WriteVisual(const scene::Visual& visual) {
    xml_.Open("geom");
    WriteShape(visual.shape, visual.X_FV);
    xml_.Count("group", 2);
    xml_.Count("contype", 0);
    xml_.Count("conaffinity", 0);
    xml_.Attribute("rgba", Numbers({visual.color.red, visual.color.green, visual.color.blue, 1}));
    xml_.Close();
  }

  void WriteBody(int index, const RigidTransform& X_WP) {
    const ExportedBody& one = body(index);
    const mechanics::BodySpec& spec = one.spec;
    xml_.Open("body");
    xml_.Attribute("name", one.name);
    WritePose(X_WP.inverse() * spec.X_WB);
    const TreeNode& node = forest_.nodes[static_cast<std::size_t>(index)];
    if (node.joint >= 0) {
      WriteJoint(joint(node.joint), index);
    } else if (!one.is_static()) {
      xml_.Open("freejoint");
      xml_.Close();
    }
    if (!one.is_static()) WriteInertial(spec.mass);
    const double rolling = mechanics::RollingFrictionOf(spec);
    for (const scene::Solid& solid : spec.solids) WriteSolid(solid, spec.friction, rolling);
    for (const scene::Visual& visual : one.visuals) WriteVisual(visual);
    for (std::size_t child = 0; child < forest_.nodes.size(); ++child) {
      if (forest_.nodes[child].parent == index) WriteBody(static_cast<int>(child), spec.X_WB);
    }
    xml_.Close();
  }

  /// Writes the joint that carries a body.
  void WriteJoint(const ExportedJoint& held, int child) {
    const bool is_a = held.a == child;
    if (const auto* ball = std::get_if<mechanics::BallJointSpec>(&held.spec)) {
      xml_.Open("joint");
      xml_.Attribute("name", held.name);
      xml_.Attribute("type", "ball");
      xml_.Attribute("pos", Numbers(is_a ? ball->p_AQ : ball->p_BQ));
      xml_.Close();
    } else if (const auto* slider = std::get_if<mechanics::SliderJointSpec>(&held.spec)) {
      WriteSlider(held, *slider, child);
    }
    // A body without a joint is fixed on its parent.
  }

  void WriteSlider(const ExportedJoint& held, const mechanics::SliderJointSpec& slider, int child) {
    const bool is_a = held.a == child;
    const RigidTransform X_AB = body(held.a).spec.X_WB.inverse() * body(held.b).spec.X_WB;
    const double offset = (slider.X_AJ.inverse() * X_AB * slider.X_BK).translation().x();
    // K slides along the x axis of J; A goes the other way.
    const Vector3 axis =
        is_a ? Vector3(-slider.X_AJ.rotation().col(0)) : Vector3(slider.X_BK.rotation().col(0));
    xml_.Open("joint");
    xml_.Attribute("name", held.name);
    xml_.Attribute("type", "slide");
    xml_.Attribute("axis", Numbers(axis));
    xml_.Attribute("range", Numbers({slider.lower, slider.upper}));
    xml_.Number("ref", offset);
    if (slider.damping > 0) {
      const double lost = std::min(slider.damping, 0.9999);
      xml_.Number("damping", -std::log1p(-lost) * body(child).spec.mass.mass);
    }
    xml_.Close();
  }

  // --- the robot

  void WriteRobot() {
    const ExportedRobot& robot = *world_.robot;
    xml_.Open("body");
    xml_.Attribute("name", robot.base.name);
    WritePose(robot.spec->X_WBase);
    for (const scene::Solid& solid : robot.spec->base_solids) {
      WriteSolid(solid, scene::LinkSpec().friction, 0);
    }
    for (const scene::Visual& visual : robot.base.visuals) WriteVisual(visual);
    WriteCamerasOn(-1);
    WriteLinksOn(-1);
    xml_.Close();
  }

  void WriteCamerasOn(int link) {
    for (const ExportedCamera& camera : world_.cameras) {
      if (camera.link == link) WriteCamera(camera);
    }
  }

  void WriteLinksOn(int parent) {
    const auto& links = world_.robot->spec->links;
    for (std::size_t link = 0; link < links.size(); ++link) {
      if (links[link].parent == parent) WriteLink(static_cast<int>(link));
    }
  }

  void WriteLink(int index) {
    const auto at = static_cast<std::size_t>(index);
    const scene::LinkSpec& link = world_.robot->spec->links[at];
    const bool turns = link.joint_type == scene::JointType::kRevolute;
    const double q = world_.robot->q[at];
    const RigidTransform motion =
        turns ? RigidTransform(Matrix3(Eigen::AngleAxisd(q, link.axis)), Vector3::Zero())
              : RigidTransform(Vector3(link.axis * q));
    xml_.Open("body");
    xml_.Attribute("name", world_.robot->links[at].name);
    WritePose(link.X_PJ * motion);
    // The real robot's controllers hold up its own weight; so do SMILE's motors.
    xml_.Number("gravcomp", 1);
    xml_.Open("joint");
    xml_.Attribute("name", link.joint_name);
    xml_.Attribute("type", turns ? "hinge" : "slide");
    xml_.Attribute("axis", Numbers(link.axis));
    xml_.Attribute("range", Numbers({link.lower, link.upper}));
    xml_.Number("ref", q);
    xml_.Close();
    WriteInertial({.mass = link.mass, .center = link.p_LLcm, .inertia = link.inertia});
    for (const scene::Solid& solid : link.solids) WriteSolid(solid, link.friction, 0);
    for (const scene::Visual& visual : world_.robot->links[at].visuals) WriteVisual(visual);
    WriteCamerasOn(index);
    WriteLinksOn(index);
    xml_.Close();
  }

  // --- what joins and drives bodies beside the tree

  void WriteConstraints() {
    xml_.Open("contact");
    for (const ExportedJoint& held : world_.joints) {
      if (!DoCollide(held.spec)) WriteExclude(body(held.a).name, body(held.b).name);
    }
    if (world_.robot) {
      const auto name_of = [this](int link) {
        return link < 0 ? world_.robot->base.name
                        : world_.robot->links[static_cast<std::size_t>(link)].name;
      };
      for (const auto& [a, b] : world_.robot->spec->never_collide) {
        WriteExclude(name_of(a), name_of(b));
      }
    }
    xml_.Close();
    xml_.Open("equality");
    for (const int closing : forest_.closing) WriteClosing(joint(closing));
    if (world_.robot) WriteFollowers();
    xml_.Close();
    if (world_.robot) WriteServos();
  }

  void WriteExclude(const std::string& a, const std::string& b) {
    xml_.Open("exclude");
    xml_.Attribute("body1", a);
    xml_.Attribute("body2", b);
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

  void WriteFollowers() {
    const auto& links = world_.robot->spec->links;
    for (const scene::LinkSpec& link : links) {
      if (!link.mimic) continue;
      xml_.Open("joint");
      xml_.Attribute("joint1", link.joint_name);
      xml_.Attribute("joint2", links[static_cast<std::size_t>(link.mimic->leader)].joint_name);
      // MuJoCo counts both from their present positions.
      xml_.Attribute("polycoef", Numbers({0, link.mimic->multiplier, 0, 0, 0}));
      xml_.Close();
    }
  }

  void WriteServos() {
    xml_.Open("actuator");
    for (const scene::LinkSpec& link : world_.robot->spec->links) {
      if (link.mimic) continue;
      xml_.Open("velocity");
      xml_.Attribute("name", link.joint_name);
      xml_.Attribute("joint", link.joint_name);
      xml_.Number("kv", link.max_effort / (kServoBand * link.max_velocity));
      xml_.Attribute("ctrlrange", Numbers({-link.max_velocity, link.max_velocity}));
      xml_.Attribute("forcerange", Numbers({-link.max_effort, link.max_effort}));
      xml_.Close();
    }
    xml_.Close();
  }

  const ExportedWorld& world_;
  JointForest forest_;
  std::map<scene::Hull, std::string> hulls_;
  std::map<std::pair<const scene::CustomMesh*, double>, std::string> meshes_;
  xml::Writer xml_;
  std::vector<std::string> left_out_;
};

}  // namespace

ExportedText ToMjcf(const ExportedWorld& world) { return MjcfText(world).Take(); }

}  // namespace smile::interchange
