#pragma once

#include <BulletDynamics/Featherstone/btMultiBodyFixedConstraint.h>

#include <map>
#include <memory>

#include "physics/definitions.h"
#include "physics/internal_world_objects.h"

namespace smile::physics {

/// Bodies held by articulations: all welds of a World. A held body is carried. Bullet welds it to
/// the link of a multibody; on a kinematic link it is kinematic itself.
class HeldBodies {
 public:
  /// All must outlive it.
  HeldBodies(const WorldConfig& config, const WorldObjects& objects, Engine& engine);

  /// Starts to hold a body.
  /// @param id  greater than those of all other welds.
  void Hold(JointId id, const WeldSpec& weld);
  void Release(JointId id);
  /// Welds a body again after its form changed.
  void Rejoin(BodyId id);

  /// Call before each step: loads articulations with the weight that their welds do not hold up.
  void ApplyExcessWeight();
  /// Gives kinematic bodies the velocities of their links in the next step, which the articulations
  /// must already have.
  void SetKinematicVelocities();
  /// Call after each step: puts kinematic bodies at the poses given by their links.
  void MoveKinematicBodies();

 private:
  struct Weld {
    WeldSpec spec;
    std::unique_ptr<btMultiBodyFixedConstraint> constraint;  ///< null on a kinematic link
  };

  bool IsKinematic(const WeldSpec& weld) const;
  void SetKinematic(BodyId id, bool is_kinematic);
  std::unique_ptr<btMultiBodyFixedConstraint> MakeConstraint(const WeldSpec& weld) const;
  template <class Visit>
  void ForEachLinkNotColliding(const WeldSpec& weld, Visit visit) const;

  const WorldConfig& config_;
  const WorldObjects& objects_;
  Engine& engine_;
  std::map<JointId, Weld> welds_;
};

}  // namespace smile::physics
