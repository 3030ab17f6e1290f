#pragma once

#include <BulletDynamics/ConstraintSolver/btSolverBody.h>
#include <BulletDynamics/ConstraintSolver/btSolverConstraint.h>

#include <vector>

#include "physics/internal_bullet.h"
#include "sparse/block_matrix.h"
#include "sparse/elimination.h"

namespace smile::physics {

/// Rows of joints that are solved exactly, all at once, instead of one after another.
///
/// With the rows' Jacobian J and the inverse masses W, the impulses x satisfy (J W J^T) x = wanted
/// velocity changes. In this matrix all joints of one body have entries in common. For a body of
/// more than two joints, a hub, that would be a full block; so a hub's velocity change is an
/// unknown of its own, which has entries in common with its joints alone. The matrix is factored
/// once per step and used in every iteration. Chains, trees and hubs cost a time linear in their
/// size.
///
/// Velocities are always possible; to take back what came apart may not be, as in a taut chain that
/// is too long for its ends: exactly solved, that would be a blow without end. So the speeds with
/// which rows return are first reduced to what can be had by moderate impulses.
class JointBlock {
 public:
  /// Starts anew.
  void Begin();
  /// Rows come in the order of their joints. They must stay where they are.
  /// @param return_speed  the part of the row's wanted speed that takes back what came apart.
  void AddRow(btSolverConstraint* row, double return_speed);
  /// Takes the rows out of Bullet's hands, but for those of islands that are too much work.
  /// @param bodies  the solver's, to which the rows refer.
  void Factor(btAlignedObjectArray<btSolverBody>& bodies);
  /// Gives the bodies what makes all rows hold, given what else has changed their velocities.
  void Solve(btAlignedObjectArray<btSolverBody>& bodies);

 private:
  struct Row {
    btSolverConstraint* constraint;
    double return_speed;
    double self_response;  ///< its diagonal of J W J^T
    int unknown;           ///< its place among all; -1: too much work
  };
  /// The rows of one joint.
  struct JointRows {
    int first, count;
  };

  void FindJointsOfBodies(const btAlignedObjectArray<btSolverBody>& bodies);
  void FindGraph();
  void PlaceRows();
  void Assemble(const btAlignedObjectArray<btSolverBody>& bodies);
  void AssemblePair(int joint, int other, int body, double inverse_mass);
  void AssembleHub(int node, int body, const btSolverBody& solver_body);
  void ReduceReturns();
  void FactorSoftened(double softness, sparse::BlockMatrix* matrix);

  std::vector<Row> rows_;
  std::vector<JointRows> joints_;
  std::vector<std::vector<int>> joints_of_;   ///< of each body that they move, ascending
  std::vector<int> light_bodies_, hubs_;      ///< in the order of their joints
  sparse::BlockGraph graph_, ordered_graph_;  ///< of this step, and that of `elimination_`
  sparse::Elimination elimination_;
  sparse::BlockMatrix matrix_, softened_;
  std::vector<double> least_pivots_, unknowns_;
};

}  // namespace smile::physics
