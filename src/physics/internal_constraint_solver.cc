#include "physics/internal_constraint_solver.h"

#include <BulletDynamics/Featherstone/btMultiBodyLinkCollider.h>

#include <algorithm>
#include <vector>

#include "physics/internal_joint_constraint.h"

// Connects our solvers of joints and contacts with Bullet's iterative solver, which does motors,
// limits and the contacts of links. In each of its iterations the joints are solved first, all at
// once, and the contacts after them.

namespace smile::physics {
namespace {

impulses::Body ImpulsesBodyOf(btSolverBody* body) {
  impulses::Body result{.inverse_mass = body->m_invMass[0],
                        .p_WBcm = FromBullet(body->m_worldTransform.getOrigin()),
                        .v = FromBullet(body->m_linearVelocity),
                        .w = FromBullet(body->m_angularVelocity),
                        .forced_v = FromBullet(body->m_externalForceImpulse),
                        .forced_w = FromBullet(body->m_externalTorqueImpulse),
                        .change_of_v = body->m_deltaLinearVelocity.m_floats,
                        .change_of_w = body->m_deltaAngularVelocity.m_floats};
  if (result.is_movable()) {
    result.inverse_inertia = FromBullet(body->m_originalBody->getInvInertiaTensorWorld());
  }
  return result;
}

/// A solver row with its joint and its number among the joint's rows.
struct NumberedRow {
  btSolverConstraint* row;
  JointConstraint* joint;
  int number;
};

/// Returns all rows, in the order of their joints; the rows of one joint keep their order.
std::vector<NumberedRow> RowsOf(btConstraintArray& pool) {
  std::vector<NumberedRow> rows;
  for (int i = 0; i < pool.size(); ++i) {
    // Bullet keeps the constraint of a row here. The world has no other constraints between bodies.
    auto* joint = static_cast<JointConstraint*>(
        static_cast<btTypedConstraint*>(pool[i].m_originalContactPoint));
    const bool is_next = !rows.empty() && rows.back().joint == joint;
    rows.push_back({&pool[i], joint, is_next ? rows.back().number + 1 : 0});
  }
  std::stable_sort(rows.begin(), rows.end(), [](const auto& a, const auto& b) {
    return a.joint->getUserConstraintId() < b.joint->getUserConstraintId();
  });
  return rows;
}

impulses::JointRow JointRowOf(const btSolverConstraint& row, double return_speed) {
  return {.sides = {{{row.m_solverBodyIdA, FromBullet(row.m_contactNormal1),
                      FromBullet(row.m_relpos1CrossNormal), FromBullet(row.m_angularComponentA)},
                     {row.m_solverBodyIdB, FromBullet(row.m_contactNormal2),
                      FromBullet(row.m_relpos2CrossNormal), FromBullet(row.m_angularComponentB)}}},
          .inverse_response = row.m_jacDiagABInv,
          .impulse_alone = row.m_rhs,
          .return_speed = return_speed};
}

/// Returns true for a link of a (non-kinematic) articulation.
bool IsLink(const btCollisionObject* object) {
  return btMultiBodyLinkCollider::upcast(object) != nullptr;
}

}  // namespace

void ConstraintSolver::convertContacts(btPersistentManifold** manifolds, int num_manifolds,
                                       const btContactSolverInfo& info) {
  // Each kind keeps its order; only the contacts of links are converted with two directions.
  btAlignedObjectArray<btPersistentManifold*> of_bodies, of_links;
  for (int i = 0; i < num_manifolds; ++i) {
    const bool is_of_link = IsLink(manifolds[i]->getBody0()) || IsLink(manifolds[i]->getBody1());
    (is_of_link ? of_links : of_bodies).push_back(manifolds[i]);
  }
  const bool may_rest = of_links.size() == 0 && m_tmpSolverNonContactConstraintPool.size() == 0;
  const int num_for_bullet = has_firm_contacts_ ? 0 : of_bodies.size();
  btMultiBodyConstraintSolver::convertContacts(num_for_bullet > 0 ? &of_bodies[0] : nullptr,
                                               num_for_bullet, info);
  btContactSolverInfo in_all_directions = info;
  in_all_directions.m_solverMode |= SOLVER_USE_2_FRICTION_DIRECTIONS;
  for (int i = 0; i < of_links.size(); ++i) convertMultiBodyContact(of_links[i], in_all_directions);
  // Last, when all bodies are known: a further one may move the others in memory.
  if (has_firm_contacts_) FindManifolds(All(of_bodies), info);
  if (has_firm_contacts_ || !held_rows_.empty()) ReadBodies();
  if (has_firm_contacts_) contacts_.Begin(manifolds_, may_rest, info, bodies_);
}

void ConstraintSolver::FindManifolds(std::span<btPersistentManifold*> of_bodies,
                                     const btContactSolverInfo& info) {
  manifolds_.clear();
  const auto index_of = [this, &info](const btCollisionObject* object) {
    return getOrInitSolverBody(const_cast<btCollisionObject&>(*object), info.m_timeStep);
  };
  for (btPersistentManifold* manifold : of_bodies) {
    const int a = index_of(manifold->getBody0()), b = index_of(manifold->getBody1());
    manifolds_.push_back({manifold, a, b});
  }
}

void ConstraintSolver::ReadBodies() {
  bodies_.clear();
  for (btSolverBody& body : All(m_tmpSolverBodyPool)) bodies_.push_back(ImpulsesBodyOf(&body));
}

void ConstraintSolver::convertJoints(btTypedConstraint** joints, int num_joints,
                                     const btContactSolverInfo& info) {
  const auto place = [](const btTypedConstraint* joint) {
    return static_cast<const JointConstraint*>(joint)->place;
  };
  // Rows that are not held are solved in this order.
  std::ranges::stable_sort(std::span(joints, static_cast<std::size_t>(num_joints)), {}, place);
  btMultiBodyConstraintSolver::convertJoints(joints, num_joints, info);
  joints_.Begin();
  held_rows_.clear();
  if (num_joints == 0) return;
  const JointConstraint* last = nullptr;
  for (const auto& [row, joint, number] : RowsOf(m_tmpSolverNonContactConstraintPool)) {
    // A body without inertia does not answer to a torque; Bullet passes over such a row.
    if (!joint->IsHeld(number) || row->m_jacDiagABInv == 0) continue;
    joints_.AddRow(JointRowOf(*row, joint->return_speed(number)), /*is_next=*/joint == last);
    held_rows_.push_back(row);
    last = joint;
  }
  ReadBodies();
  joints_.Factor(bodies_);
  for (std::size_t i = 0; i < held_rows_.size(); ++i) {
    // Zero iterations of Bullet's own.
    if (joints_.is_solved(i)) held_rows_[i]->m_overrideNumSolverIterations = 0;
  }
}

btScalar ConstraintSolver::solveSingleIteration(int iteration, btCollisionObject** bodies,
                                                int num_bodies, btPersistentManifold** manifolds,
                                                int num_manifolds, btTypedConstraint** joints,
                                                int num_joints, const btContactSolverInfo& info,
                                                btIDebugDraw* draw) {
  // Contacts come last in each iteration; the joint error that they leave is corrected in the next
  // step.
  if (num_joints > 0) joints_.Solve(bodies_);
  const btScalar residual = btMultiBodyConstraintSolver::solveSingleIteration(
      iteration, bodies, num_bodies, manifolds, num_manifolds, joints, num_joints, info, draw);
  return std::max(residual, contacts_.Sweep());
}

btScalar ConstraintSolver::solveGroupCacheFriendlyFinish(btCollisionObject** bodies, int num_bodies,
                                                         const btContactSolverInfo& info) {
  for (std::size_t i = 0; i < held_rows_.size(); ++i) {
    if (joints_.is_solved(i)) held_rows_[i]->m_appliedImpulse = joints_.impulse(i);
  }
  for (const auto& [row, joint, number] : RowsOf(m_tmpSolverNonContactConstraintPool)) {
    joint->NoteImpulse(number, row->m_appliedImpulse);
  }
  contacts_.End();
  return btMultiBodyConstraintSolver::solveGroupCacheFriendlyFinish(bodies, num_bodies, info);
}

}  // namespace smile::physics
