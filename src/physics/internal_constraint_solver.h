#pragma once

#include <BulletDynamics/Featherstone/btMultiBodyConstraintSolver.h>

#include "impulses/joint_solver.h"
#include "physics/internal_manifold_solver.h"

namespace smile::physics {

/// Bullet's iterative solver, with joints between bodies solved exactly in each of its iterations.
/// Limits out of reach stay with Bullet; one that was pressed in the last step counts as a joint's
/// row. All typed constraints must be JointConstraints with their place in the order as user id.
class ConstraintSolver : public btMultiBodyConstraintSolver {
 public:
  /// See WorldConfig for these.
  ConstraintSolver(bool has_firm_contacts, bool finds_loads)
      : has_firm_contacts_(has_firm_contacts), contacts_(finds_loads) {}

  btScalar solveGroupCacheFriendlyFinish(btCollisionObject** bodies, int num_bodies,
                                         const btContactSolverInfo& info) override;

  /// Gives contacts of links two directions of friction. Bullet would use one direction, and then
  /// skips each friction row of a multibody without a partner in another direction: links would be
  /// frictionless.
  void convertContacts(btPersistentManifold** manifolds, int num_manifolds,
                       const btContactSolverInfo& info) override;

 protected:
  void convertJoints(btTypedConstraint** joints, int num_joints,
                     const btContactSolverInfo& info) override;
  btScalar solveSingleIteration(int iteration, btCollisionObject** bodies, int num_bodies,
                                btPersistentManifold** manifolds, int num_manifolds,
                                btTypedConstraint** joints, int num_joints,
                                const btContactSolverInfo& info, btIDebugDraw* draw) override;

 private:
  void FindManifolds(std::span<btPersistentManifold*> of_bodies, const btContactSolverInfo& info);
  void ReadBodies();

  bool has_firm_contacts_;
  std::vector<impulses::Body> bodies_;  ///< those of Bullet's solver
  impulses::JointSolver joints_;
  std::vector<btSolverConstraint*> held_rows_;  ///< Bullet's, of joints_
  ManifoldSolver contacts_;
  std::vector<SolverManifold> manifolds_;  ///< of contacts_
};

}  // namespace smile::physics
