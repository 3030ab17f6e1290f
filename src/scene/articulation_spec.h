#pragma once

#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "scene/solid.h"

namespace smile::scene {

enum class JointType { kRevolute, kPrismatic };

/// Coupling of a joint to another one, the leader, as by gears or a linkage: its position is
/// `multiplier` times that of the leader plus `offset`. The leader does all the work and follows no
/// other joint itself.
struct Mimic {
  int leader = -1;        ///< index into ArticulationSpec::links
  double multiplier = 1;  ///< not 0
  double offset = 0;      ///< [rad or m]

  bool operator==(const Mimic&) const = default;
};

/// Moving link L of an articulation and the joint that carries it.
///
/// L's frame in its parent's is X_PJ * Motion(axis, q): the joint frame, then a turn about (or a
/// slide along) `axis` by q.
struct LinkSpec {
  std::string name;
  std::string joint_name;
  int parent = -1;  ///< index into ArticulationSpec::links, smaller than one's own; -1 = the base
  JointType joint_type = JointType::kRevolute;
  RigidTransform X_PJ;
  Vector3 axis = Vector3::UnitZ();  ///< unit vector in J
  double lower = 0, upper = 0;      ///< [rad or m]
  double max_velocity = 0;          ///< [rad/s or m/s]
  double max_effort = 0;            ///< [N m or N]
  std::optional<Mimic> mimic;       ///< a joint without a motor, which another one moves

  double mass = 0;                    ///< [kg], > 0
  Vector3 p_LLcm = Vector3::Zero();   ///< centre of mass [m]
  Matrix3 inertia = Matrix3::Zero();  ///< about the centre of mass, along L's axes [kg m2]
  std::vector<Solid> solids;          ///< collision shapes; Solid::X_BS is X_LS
  double friction = 0.6;

  bool operator==(const LinkSpec&) const = default;
};

/// Links joined by joints on a base that is fixed in the world.
struct ArticulationSpec {
  RigidTransform X_WBase;
  std::vector<Solid> base_solids;  ///< collision shapes of the base; Solid::X_BS is X_BaseS
  std::vector<LinkSpec> links;     ///< parents before children
  /// Pairs of links that always touch and therefore never collide; -1 is the base.
  std::vector<std::pair<int, int>> never_collide;
  /// Joints move exactly as commanded, with unlimited force: links push bodies, and pass through
  /// static ones, through other kinematic links, and through themselves.
  bool is_kinematic = false;

  bool operator==(const ArticulationSpec&) const = default;
};

/// Puts each joint that mimics another where its leader takes it, within its limits.
/// @param q  positions [rad or m], one per link.
void FollowLeaders(std::span<const LinkSpec> links, std::span<double> q);

/// Returns X_WL of every link at joint positions `q` [rad or m], one per link (forward kinematics).
std::vector<RigidTransform> LinkPoses(std::span<const LinkSpec> links,
                                      const RigidTransform& X_WBase, std::span<const double> q);

}  // namespace smile::scene
