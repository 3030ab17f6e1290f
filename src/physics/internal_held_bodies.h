#pragma once

#include <BulletDynamics/Featherstone/btMultiBodyFixedConstraint.h>

#include <map>
#include <memory>

#include "physics/internal_world_objects.h"
#include "physics/joint.h"

namespace smile::physics {

/// The bodies that articulations hold: all welds of a World. A held body is carried. Bullet welds
/// it to the link of a multibody; on a kinematic link it is kinematic itself.
class HeldBodies {
 public:
  /// All must outlive it.
  HeldBodies(const WorldConfig& config, const WorldObjects& objects, Engine& engine);

  /// @param id  greater than those of all other welds.
  void Hold(JointId id, const WeldSpec& weld);
  void Release(JointId id);
  /// Welds a body whose form changed again.
  void Rejoin(BodyId id);

  /// Before a step: lets articulations bear the weight that their welds do not hold up.
  void ApplyExcessWeight();
  /// Gives the kinematic ones the velocities of their links in the next step; articulations have
  /// theirs already.
  void SetKinematicVelocities();
  /// After the step: puts them where their links are.
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
