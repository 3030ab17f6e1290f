#pragma once

#include <BulletDynamics/Featherstone/btMultiBodyDynamicsWorld.h>

#include <utility>
#include <vector>

#include "physics/body.h"
#include "physics/internal_bullet.h"

namespace smile::physics {

/// Bullet's multibody world in a canonical order: its arrays, islands and contact manifolds are
/// sorted by the objects' order of creation, so that the order in which a step works through them,
/// and with it every rounding, follows from the state alone and not from how it came about.
class ExactWorld : public btMultiBodyDynamicsWorld {
 public:
  using btMultiBodyDynamicsWorld::btMultiBodyDynamicsWorld;

  /// By how much two that fit closely may overlap before contacts between them bear [m].
  static constexpr double kCloseFitPlay = 0.0005;

  /// The pairs to which kCloseFitPlay applies in the steps to come, sorted, the smaller id first.
  void SetCloseFits(const std::vector<std::pair<BodyId, BodyId>>& pairs) { close_fits_ = pairs; }
  /// Call after objects were added or removed. Costs next to nothing when the order is right
  /// already, as it is after the usual addition at the end.
  void SortObjects();
  void SortManifolds();
  /// Bullet's own removal fills the gap with the last constraint; this one keeps the order.
  void RemoveConstraintInOrder(btMultiBodyConstraint* constraint);
  void RemoveConstraintInOrder(btTypedConstraint* constraint);
  /// Puts a constraint in the place of another, which is then no longer part of the world.
  void ReplaceConstraint(btMultiBodyConstraint* constraint, btMultiBodyConstraint* with);
  void ReplaceConstraint(btTypedConstraint* constraint, btTypedConstraint* with);

 protected:
  /// Kinematic objects are given their velocities, where Bullet would work them out of poses.
  void saveKinematicState(btScalar) override {}
  /// Joints stay within their limits, whatever the solver left them with.
  void integrateTransforms(btScalar seconds) override;
  /// The last thing before the solver: here contacts are put in order and limited.
  void calculateSimulationIslands() override;

 private:
  void EaseCloseFits();
  void LimitDepths();

  std::vector<std::pair<BodyId, BodyId>> close_fits_;
  std::vector<int> smallest_in_island_;
};

}  // namespace smile::physics
