#pragma once

#include <BulletDynamics/Featherstone/btMultiBodyDynamicsWorld.h>

#include <vector>

#include "mechanics/body_pairs.h"
#include "physics/definitions.h"
#include "physics/internal_bullet.h"
#include "physics/internal_free_trees.h"

namespace smile::physics {

class DormantIslands;

/// Bullet's dispatcher, which can leave out contact manifolds for a while.
class Dispatcher : public btCollisionDispatcher {
 public:
  using btCollisionDispatcher::btCollisionDispatcher;

  /// Leaves out the manifolds for which `is_taken` is true. They must be put back before their
  /// pairs end.
  template <class Predicate>
  void TakeManifolds(Predicate is_taken) {
    btManifoldArray all = m_manifoldsPtr;
    m_manifoldsPtr.resize(0);
    for (btPersistentManifold* manifold : All(all)) {
      if (!is_taken(*manifold)) PutManifold(manifold);
    }
  }
  std::vector<btPersistentManifold*> Manifolds() const {
    return {m_manifoldsPtr.size() > 0 ? &m_manifoldsPtr[0] : nullptr,
            m_manifoldsPtr.size() > 0 ? &m_manifoldsPtr[0] + m_manifoldsPtr.size() : nullptr};
  }
  void PutManifold(btPersistentManifold* manifold) {
    // Bullet removes a manifold by its stored index.
    manifold->m_index1a = m_manifoldsPtr.size();
    m_manifoldsPtr.push_back(manifold);
  }
};

/// Bullet's multibody world in a canonical order: its arrays, islands and contact manifolds are
/// sorted by the objects' order of creation. The order of work in a step, and with it all rounding,
/// therefore depends on the state only and not on its history.
class ExactWorld : public btMultiBodyDynamicsWorld {
 public:
  using btMultiBodyDynamicsWorld::btMultiBodyDynamicsWorld;

  /// Overlap of a close fit up to which its contacts bear no load [m].
  static constexpr double kCloseFitPlay = 0.0005;

  /// Sets the pairs to which kCloseFitPlay applies from now on.
  void SetCloseFits(const mechanics::BodyPairs& pairs) { close_fits_ = pairs; }
  /// Restores the order after objects were added or removed. Cheap if they are already in order, as
  /// after the usual addition at the end.
  void SortObjects();
  void SortManifolds();
  std::span<btPersistentManifold*> manifolds();
  /// Leaves out the objects for which `is_taken` is true, without the traces of a removal.
  template <class Predicate>
  void TakeObjects(Predicate is_taken);
  /// Puts a body back that was left out. Call SortObjects() afterwards.
  void PutObject(btRigidBody* body);
  /// Joints between bodies, by id; each is a JointConstraint.
  std::span<btTypedConstraint*> joints() { return All(m_constraints); }
  /// Leaves out the joints for which `is_taken` is true.
  template <class Predicate>
  void TakeJoints(Predicate is_taken) {
    KeepOthers(is_taken, &m_constraints);
  }
  /// Puts a joint back that was left out. Call SortObjects() afterwards.
  void PutJoint(btTypedConstraint* joint) { m_constraints.push_back(joint); }
  /// Sets whether the normals of contacts turn with the bodies, as far as both turn. Bullet leaves
  /// a point that stays anchored the normal with which it was found.
  void SetTurnsNormals(bool turns_normals) { turns_normals_ = turns_normals; }
  /// Turns normals. Call when all bodies have moved in a step.
  void TurnNormals();
  /// Sets whether trees of articulations that nothing touches are moved without Bullet.
  void SetMovesFreeTrees(bool moves) { moves_free_trees_ = moves; }
  /// Sets the islands that are returned when something reaches them.
  void SetDormantIslands(DormantIslands* islands) { dormant_islands_ = islands; }
  /// Removes a constraint and keeps the order; Bullet's own removal fills the gap with the last
  /// one.
  void RemoveConstraintInOrder(btMultiBodyConstraint* constraint);
  void RemoveConstraintInOrder(btTypedConstraint* constraint);
  /// Replaces a constraint, which is then no longer part of the world, by another in its place.
  void ReplaceConstraint(btMultiBodyConstraint* constraint, btMultiBodyConstraint* with);
  void ReplaceConstraint(btTypedConstraint* constraint, btTypedConstraint* with);

 protected:
  /// Computes bounding boxes by StatelessBroadphase::UpdateBounds(), and returns islands that they
  /// reach.
  void updateAabbs() override;
  /// Lets Bullet solve what does not move freely.
  void solveConstraints(btContactSolverInfo& info) override;
  /// Does nothing: kinematic objects are given their velocities, which Bullet would derive from
  /// poses.
  void saveKinematicState(btScalar) override {}
  /// Clamps joint speeds before integration, so that joints stay within their limits whatever the
  /// solver left.
  void integrateTransforms(btScalar seconds) override;
  /// Runs last before the solver; puts islands and contacts in order, and limits contacts.
  void calculateSimulationIslands() override;

 private:
  template <class Predicate, class Array>
  static void KeepOthers(Predicate is_taken, Array* array) {
    const Array all = *array;
    array->resize(0);
    for (auto* one : All(all)) {
      if (!is_taken(one)) array->push_back(one);
    }
  }
  void NumberObjects();
  void UniteTrees(btUnionFind* islands);
  void NoteRotations();
  void EaseCloseFits();
  void LimitDepths();

  DormantIslands* dormant_islands_ = nullptr;
  mechanics::BodyPairs close_fits_;
  std::vector<int> smallest_in_island_;
  /// Contacts with the rotations of both bodies before they move.
  struct TurningContacts {
    btPersistentManifold* manifold;
    btMatrix3x3 R_WA, R_WB;
  };
  bool moves_free_trees_ = false;
  FreeTrees free_trees_;
  bool turns_normals_ = false;
  std::vector<TurningContacts> turning_;
};

template <class Predicate>
void ExactWorld::TakeObjects(Predicate is_taken) {
  KeepOthers(is_taken, &m_collisionObjects);
  KeepOthers(is_taken, &m_nonStaticRigidBodies);
  NumberObjects();
}

}  // namespace smile::physics
