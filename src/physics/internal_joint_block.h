#pragma once

#include <BulletDynamics/ConstraintSolver/btSolverBody.h>
#include <BulletDynamics/ConstraintSolver/btSolverConstraint.h>

#include <vector>

#include "physics/internal_bullet.h"
#include "sparse/block_matrix.h"
#include "sparse/elimination.h"

namespace smile::physics {

/// Direct solver for the rows of all joints together, where Bullet would solve one row after
/// another.
///
/// With the rows' Jacobian J and the inverse masses W, the impulses x satisfy (J W J^T) x = wanted
/// velocity changes. In this matrix the joints of one body form a full block. For a body with more
/// than two joints, a supernode, that block would be large, so the velocity change of a supernode
/// is an unknown of its own, which has entries in common only with its joints. The matrix is
/// factored once per step and used in every iteration. The cost of chains, trees and supernodes is
/// linear in their size.
///
/// Velocity errors can always be removed; position errors may not be, as in a taut chain that is
/// too long for its ends: solved exactly, that would demand unbounded impulses. The speeds with
/// which rows correct position errors are therefore first reduced to those that moderate impulses
/// can reach.
class JointBlock {
 public:
  /// Removes all rows, for a new step.
  void Begin();
  /// Adds a row. Rows come in the order of their joints, and must stay at their addresses until
  /// Solve().
  /// @param return_speed  the part of the row's wanted speed that corrects a position error, in
  ///                      m/s or rad/s.
  void AddRow(btSolverConstraint* row, double return_speed);
  /// Factors the matrix, and disables the rows in Bullet's own iteration. Rows of islands that are
  /// too much work stay with Bullet.
  /// @param bodies  the solver's bodies, to which the rows refer.
  void Factor(btAlignedObjectArray<btSolverBody>& bodies);
  /// Applies the impulses that make all rows hold, given all other changes of the bodies'
  /// velocities so far.
  void Solve(btAlignedObjectArray<btSolverBody>& bodies);

 private:
  struct Row {
    btSolverConstraint* constraint;
    double return_speed;
    double self_response;  ///< its diagonal entry of J W J^T
    int unknown;           ///< its index among the unknowns, -1 if left to Bullet
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
  void AssembleSupernode(int node, int body, const btSolverBody& solver_body);
  void ReduceReturns();
  void FactorSoftened(double softness, sparse::BlockMatrix* matrix);

  std::vector<Row> rows_;
  std::vector<JointRows> joints_;
  std::vector<std::vector<int>> joints_of_;          ///< joints of each movable body, ascending
  std::vector<int> low_degree_bodies_, supernodes_;  ///< in the order of their first joints
  sparse::BlockGraph graph_, ordered_graph_;  ///< of this step, and the one of `elimination_`
  sparse::Elimination elimination_;
  sparse::BlockMatrix matrix_, softened_;
  std::vector<double> least_pivots_, unknowns_;
};

}  // namespace smile::physics
