#include "interchange/carried_body.h"
#include "interchange/internal_mjcf_robot.h"
#include "interchange/numbers.h"

namespace smile::interchange {
namespace {

/// The servo of a joint reaches its greatest force when its speed is wrong by this fraction of the
/// greatest one.
constexpr double kServoBand = 0.1;

}  // namespace

const std::string& MjcfRobot::NameOf(int link) const {
  return link < 0 ? robot_.base.name : robot_.links[static_cast<std::size_t>(link)].name;
}

void MjcfRobot::WriteBodies() {
  xml_.Open("body");
  xml_.Attribute("name", robot_.base.name);
  geoms_.WritePose(robot_.spec->X_WBase);
  for (const scene::Solid& solid : robot_.spec->base_solids) {
    geoms_.WriteSolid(solid, scene::LinkSpec().friction, 0);
  }
  for (const scene::Visual& visual : robot_.base.visuals) geoms_.WriteVisual(visual);
  WriteCamerasOn(-1);
  WriteLinksOn(-1);
  xml_.Close();
}

void MjcfRobot::WriteCamerasOn(int link) {
  for (const ExportedCamera& camera : world_.cameras) {
    if (camera.link == link) geoms_.WriteCamera(camera);
  }
}

void MjcfRobot::WriteLinksOn(int parent) {
  const auto& links = robot_.spec->links;
  for (std::size_t link = 0; link < links.size(); ++link) {
    if (links[link].parent == parent) WriteLink(static_cast<int>(link));
  }
}

void MjcfRobot::WriteLink(int index) {
  const auto at = static_cast<std::size_t>(index);
  const scene::LinkSpec& link = robot_.spec->links[at];
  const double q = robot_.q[at];
  xml_.Open("body");
  xml_.Attribute("name", NameOf(index));
  geoms_.WritePose(PoseInParent(link, q));
  // The real robot's controllers hold up its own weight; so do SMILE's motors.
  xml_.Number("gravcomp", 1);
  xml_.Open("joint");
  xml_.Attribute("name", link.joint_name);
  xml_.Attribute("type", link.joint_type == scene::JointType::kRevolute ? "hinge" : "slide");
  xml_.Attribute("axis", Numbers(link.axis));
  xml_.Attribute("range", Numbers({link.lower, link.upper}));
  xml_.Number("ref", q);
  xml_.Close();
  geoms_.WriteInertial({.mass = link.mass, .center = link.p_LLcm, .inertia = link.inertia});
  for (const scene::Solid& solid : link.solids) geoms_.WriteSolid(solid, link.friction, 0);
  for (const scene::Visual& visual : robot_.links[at].visuals) geoms_.WriteVisual(visual);
  WriteCamerasOn(index);
  WriteLinksOn(index);
  xml_.Close();
}

void MjcfRobot::WriteFollowers() {
  const auto& links = robot_.spec->links;
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

void MjcfRobot::WriteServos() {
  xml_.Open("actuator");
  for (const scene::LinkSpec& link : robot_.spec->links) {
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

}  // namespace smile::interchange
