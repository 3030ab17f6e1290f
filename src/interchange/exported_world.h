#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "math/camera_projection.h"
#include "mechanics/body_spec.h"
#include "mechanics/joint.h"
#include "scene/articulation_spec.h"
#include "scene/visual_model.h"
#include "sim/running_model.h"

namespace smile::interchange {

/// A rigid body B and what is drawn of it.
struct ExportedBody {
  std::string name;
  int frame = -1;                      ///< of scene::VisualModel; 0: the table; -1: not seen
  mechanics::BodySpec spec;            ///< as simulated; its pose is the present one
  std::vector<scene::Visual> visuals;  ///< X_FV is X_BV; only what is visible now

  bool is_static() const { return spec.mass.mass == 0; }
};

/// A joint between two bodies.
struct ExportedJoint {
  std::string name;
  mechanics::JointSpec spec;
  int a = 0, b = 0;  ///< indices of its bodies
};

/// A link of the robot, or its base, and what is drawn of it.
struct ExportedLink {
  std::string name;
  int frame = -1;                      ///< of scene::VisualModel
  std::vector<scene::Visual> visuals;  ///< X_FV is X_LV
};

struct ExportedRobot {
  std::shared_ptr<const scene::ArticulationSpec> spec;
  std::vector<double> q;  ///< present positions [rad or m]
  ExportedLink base;
  std::vector<ExportedLink> links;  ///< as those of `spec`
};

/// A camera, fixed in the world or on a link of the robot.
struct ExportedCamera {
  std::string name;
  int link = -2;  ///< of the robot; -1: its base; -2: the world
  /// Its pose there, as in CameraView: x right, y down, z forward.
  RigidTransform X_FC;
  CameraIntrinsics intrinsics;
};

/// A simulated world at a moment as other simulators know such: bodies, joints, a robot, cameras
/// and light, without what only SMILE knows. All names of bodies and links are different.
struct ExportedWorld {
  std::string name;
  double gravity = 9.81;             ///< along -z [m/s2]
  std::vector<ExportedBody> bodies;  ///< table and floor, then the objects that are there
  std::vector<ExportedJoint> joints;
  std::optional<ExportedRobot> robot;
  std::vector<ExportedCamera> cameras;
  scene::Lighting lighting;
  /// What has no counterpart in any of the formats, in words, each named with its place.
  std::vector<std::string> left_out;
};

/// Returns the direction in which the light of a world shines, not of unit length.
Vector3 LightDirectionOf(const scene::Lighting& lighting);

/// Returns the present world of a simulation.
ExportedWorld WorldOf(const sim::RunningModel& running);

}  // namespace smile::interchange
