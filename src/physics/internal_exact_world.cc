#include "physics/internal_exact_world.h"

#include <BulletCollision/CollisionDispatch/btSimulationIslandManager.h>

#include <algorithm>
#include <limits>
#include <tuple>

#include "physics/internal_compound_pairs.h"
#include "physics/internal_dormant_islands.h"
#include "physics/internal_joint_drive.h"
#include "physics/internal_stateless_broadphase.h"

// Bullet's world with everything sorted that depends on history, so that the same state always
// gives the same next state. Objects, manifolds and islands have the order of creation of their
// objects (OrderOf), which is part of snapshots.

namespace smile::physics {
namespace {

/// Contacts count as at most this deep, which is corrected at 0.5 m/s [m].
constexpr btScalar kMaxDepth = 0.005;

template <class Constraint>
void RemoveInOrder(btAlignedObjectArray<Constraint*>& constraints, Constraint* constraint) {
  const int index = constraints.findLinearSearch(constraint);
  // Bullet moves the last constraint to the gap, which changes the order in which rows are solved.
  for (int i = index; i + 1 < constraints.size(); ++i) constraints[i] = constraints[i + 1];
  if (index < constraints.size()) constraints.pop_back();
}

/// Clamps joint speeds [rad/s or m/s] to the limits: corrects the error that the solver leaves
/// after its last iteration.
void LimitJointSpeeds(double seconds, btMultiBody* multibody) {
  for (int i = 0; i < multibody->getNumLinks(); ++i) {
    const mechanics::JointSpeeds allowed = AllowedSpeeds(*multibody, i, seconds);
    const double v = multibody->getJointVel(i);
    if (v < allowed.least) multibody->setJointVel(i, allowed.least);
    if (v > allowed.most) multibody->setJointVel(i, allowed.most);
  }
}

/// Returns true for a body that moves freely. Links are not: their joints have limits of speed.
bool IsLoose(const btCollisionObject* object) {
  return btRigidBody::upcast(object) != nullptr && !object->isStaticOrKinematicObject();
}

template <class Constraint>
void Replace(btAlignedObjectArray<Constraint*>& constraints, Constraint* constraint,
             Constraint* with) {
  const int index = constraints.findLinearSearch(constraint);
  if (index < constraints.size()) constraints[index] = with;
}

}  // namespace

void ExactWorld::SortObjects() {
  const auto sort = [](auto& objects) {
    if (std::ranges::is_sorted(All(objects), {}, OrderOf)) return false;
    std::ranges::sort(All(objects), {}, OrderOf);
    return true;
  };
  if (sort(m_collisionObjects)) NumberObjects();
  sort(m_nonStaticRigidBodies);
  std::ranges::sort(joints(), {}, &btTypedConstraint::getUserConstraintId);
}

void ExactWorld::PutObject(btRigidBody* body) {
  body->setWorldArrayIndex(m_collisionObjects.size());
  m_collisionObjects.push_back(body);
  if (!body->isStaticObject()) m_nonStaticRigidBodies.push_back(body);
}

/// Tells the objects their places: Bullet finds them in its array by these.
void ExactWorld::NumberObjects() {
  for (int i = 0; i < m_collisionObjects.size(); ++i) m_collisionObjects[i]->setWorldArrayIndex(i);
}

std::span<btPersistentManifold*> ExactWorld::manifolds() {
  return {getDispatcher()->getInternalManifoldPointer(),
          static_cast<std::size_t>(getDispatcher()->getNumManifolds())};
}

void ExactWorld::SortManifolds() {
  const auto key = [](const btPersistentManifold* manifold) {
    return std::tuple(OrderOf(manifold->getBody0()), OrderOf(manifold->getBody1()),
                      PartPairOf(manifold));
  };
  std::ranges::sort(manifolds(), {}, key);
  // Bullet removes a manifold by its stored index.
  int index = 0;
  for (btPersistentManifold* manifold : manifolds()) manifold->m_index1a = index++;
}

void ExactWorld::RemoveConstraintInOrder(btMultiBodyConstraint* constraint) {
  RemoveInOrder(m_multiBodyConstraints, constraint);
}
void ExactWorld::RemoveConstraintInOrder(btTypedConstraint* constraint) {
  RemoveInOrder(m_constraints, constraint);
}
void ExactWorld::ReplaceConstraint(btMultiBodyConstraint* constraint, btMultiBodyConstraint* with) {
  Replace(m_multiBodyConstraints, constraint, with);
}
void ExactWorld::ReplaceConstraint(btTypedConstraint* constraint, btTypedConstraint* with) {
  Replace(m_constraints, constraint, with);
}

void ExactWorld::updateAabbs() {
  for (btCollisionObject* object : All(m_collisionObjects)) {
    StatelessBroadphase::UpdateBounds(*object);
  }
  // Before pairs are found, which Bullet does next.
  dormant_islands_->ReturnReached();
}

void ExactWorld::integrateTransforms(btScalar seconds) {
  for (int i = 0; i < m_multiBodies.size(); ++i) LimitJointSpeeds(seconds, m_multiBodies[i]);
  if (turns_normals_) NoteRotations();
  btMultiBodyDynamicsWorld::integrateTransforms(seconds);
}

void ExactWorld::solveConstraints(btContactSolverInfo& info) {
  if (!moves_free_trees_) return btMultiBodyDynamicsWorld::solveConstraints(info);
  const btAlignedObjectArray<btMultiBody*> trees = m_multiBodies;
  const btAlignedObjectArray<btMultiBodyConstraint*> constraints = m_multiBodyConstraints;
  free_trees_.Solve(manifolds(), info.m_timeStep, &m_multiBodies, &m_multiBodyConstraints);
  btMultiBodyDynamicsWorld::solveConstraints(info);
  m_multiBodies = trees;
  m_multiBodyConstraints = constraints;
}

/// Notes how the bodies of contacts are turned before they move.
void ExactWorld::NoteRotations() {
  for (btPersistentManifold* manifold : manifolds()) {
    const btCollisionObject &a = *manifold->getBody0(), &b = *manifold->getBody1();
    const bool may_turn =
        !a.isStaticObject() && !b.isStaticObject() && (a.isActive() || b.isActive());
    if (!may_turn || manifold->getNumContacts() == 0) continue;
    turning_.push_back(
        {manifold, a.getWorldTransform().getBasis(), b.getWorldTransform().getBasis()});
  }
}

void ExactWorld::TurnNormals() {
  for (const auto& [manifold, R_WA, R_WB] : turning_) {
    const btMatrix3x3& R_WA_now = manifold->getBody0()->getWorldTransform().getBasis();
    const btMatrix3x3& R_WB_now = manifold->getBody1()->getWorldTransform().getBasis();
    if (R_WA_now == R_WA || R_WB_now == R_WB) continue;
    const btMatrix3x3 turn_a = R_WA_now.timesTranspose(R_WA);
    const btMatrix3x3 turn_b = R_WB_now.timesTranspose(R_WB);
    // The trace of a rotation falls with its angle.
    const auto trace = [](const btMatrix3x3& R) { return R[0][0] + R[1][1] + R[2][2]; };
    const btMatrix3x3& turn = trace(turn_a) > trace(turn_b) ? turn_a : turn_b;
    for (int k = 0; k < manifold->getNumContacts(); ++k) {
      btVector3& normal = manifold->getContactPoint(k).m_normalWorldOnB;
      normal = turn * normal;
    }
  }
  turning_.clear();
}

void ExactWorld::calculateSimulationIslands() {
  btMultiBodyDynamicsWorld::calculateSimulationIslands();
  btUnionFind& islands = getSimulationIslandManager()->getUnionFind();
  UniteTrees(&islands);
  // The representative of an island depends on the order of merging; use its smallest member
  // instead.
  const int count = islands.getNumElements();
  smallest_in_island_.assign(count, std::numeric_limits<int>::max());
  // All roots first: find() would follow changed ids.
  std::vector<int> root(count);
  for (int i = 0; i < count; ++i) {
    root[i] = islands.find(i);
    smallest_in_island_[root[i]] = std::min(smallest_in_island_[root[i]], i);
  }
  for (int i = 0; i < count; ++i) islands.getElement(i).m_id = smallest_in_island_[root[i]];
  getSimulationIslandManager()->storeIslandActivationState(getCollisionWorld());
  dormant_islands_->OrderJoints();
  SortManifolds();
  if (!close_fits_.empty()) EaseCloseFits();
  LimitDepths();
}

/// Unites the trees of each articulation, which are one island also while nothing connects them.
void ExactWorld::UniteTrees(btUnionFind* islands) {
  const auto tag_of = [](const btMultiBody& tree) {
    return tree.getLinkCollider(0)->getIslandTag();
  };
  for (int i = 1; i < m_multiBodies.size(); ++i) {
    const btMultiBody &tree = *m_multiBodies[i], &last = *m_multiBodies[i - 1];
    if (tree.getUserIndex() == last.getUserIndex()) islands->unite(tag_of(last), tag_of(tree));
  }
}

/// Adds the play of close fits to the distances of their contacts. Distances are computed from the
/// points: those of sleeping pairs are not refreshed and already include it.
void ExactWorld::EaseCloseFits() {
  const auto id_of = [](const btCollisionObject* object) {
    return BodyId{static_cast<std::uint32_t>(OrderOf(object))};
  };
  for (btPersistentManifold* manifold : manifolds()) {
    const mechanics::BodyPair pair =
        mechanics::PairOf(id_of(manifold->getBody0()), id_of(manifold->getBody1()));
    if (!close_fits_.Contains(pair)) continue;
    for (int k = 0; k < manifold->getNumContacts(); ++k) {
      btManifoldPoint& point = manifold->getContactPoint(k);
      const btScalar distance =
          (point.m_positionWorldOnA - point.m_positionWorldOnB).dot(point.m_normalWorldOnB);
      point.setDistance(distance + kCloseFitPlay);
    }
  }
}

/// Limits the depth of contacts of free bodies, so that a body inside another, such as a block
/// under an opening gate, is pushed out slowly: Bullet corrects a fifth of the depth per step, at
/// any speed.
void ExactWorld::LimitDepths() {
  for (btPersistentManifold* manifold : manifolds()) {
    if (!IsLoose(manifold->getBody0()) && !IsLoose(manifold->getBody1())) continue;
    for (int k = 0; k < manifold->getNumContacts(); ++k) {
      btManifoldPoint& point = manifold->getContactPoint(k);
      point.setDistance(std::max(point.getDistance(), -kMaxDepth));
    }
  }
}

}  // namespace smile::physics
