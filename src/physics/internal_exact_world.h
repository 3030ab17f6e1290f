#pragma once

#include <BulletDynamics/Featherstone/btMultiBodyDynamicsWorld.h>

#include <utility>
#include <vector>

#include "physics/body.h"
#include "physics/internal_bullet.h"

namespace smile::physics {

/// Bullet's multibody world in a canonical order: its arrays, islands and contact manifolds are
/// sorted by the objects' order of creation. The order of work in a step, and with it all rounding,
/// therefore depends on the state only and not on its history.
class ExactWorld : public btMultiBodyDynamicsWorld {
 public:
  using btMultiBodyDynamicsWorld::btMultiBodyDynamicsWorld;

  /// Overlap of a close fit up to which its contacts bear no load [m].
  static constexpr double kCloseFitPlay = 0.0005;

  /// Sets the pairs to which kCloseFitPlay applies from now on, sorted, the smaller id first.
  void SetCloseFits(const std::vector<std::pair<BodyId, BodyId>>& pairs) { close_fits_ = pairs; }
  /// Restores the order after objects were added or removed. Cheap if they are already in order, as
  /// after the usual addition at the end.
  void SortObjects();
  void SortManifolds();
  /// Removes a constraint and keeps the order; Bullet's own removal fills the gap with the last
  /// one.
  void RemoveConstraintInOrder(btMultiBodyConstraint* constraint);
  void RemoveConstraintInOrder(btTypedConstraint* constraint);
  /// Replaces a constraint, which is then no longer part of the world, by another in its place.
  void ReplaceConstraint(btMultiBodyConstraint* constraint, btMultiBodyConstraint* with);
  void ReplaceConstraint(btTypedConstraint* constraint, btTypedConstraint* with);

 protected:
  /// Does nothing: kinematic objects are given their velocities, which Bullet would derive from
  /// poses.
  void saveKinematicState(btScalar) override {}
  /// Clamps joint speeds before integration, so that joints stay within their limits whatever the
  /// solver left.
  void integrateTransforms(btScalar seconds) override;
  /// Runs last before the solver; puts islands and contacts in order, and limits contacts.
  void calculateSimulationIslands() override;

 private:
  void EaseCloseFits();
  void LimitDepths();

  std::vector<std::pair<BodyId, BodyId>> close_fits_;
  std::vector<int> smallest_in_island_;
};

}  // namespace smile::physics
