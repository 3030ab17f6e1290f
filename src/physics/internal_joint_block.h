#pragma once

#include <BulletDynamics/ConstraintSolver/btSolverBody.h>
#include <BulletDynamics/ConstraintSolver/btSolverConstraint.h>

#include <vector>

#include "physics/internal_bullet.h"

namespace smile::physics {

/// Rows of joints that are solved exactly, all at once, instead of one after another.
///
/// With the rows' Jacobian J and the inverse masses W, the impulses x satisfy (J W J^T) x = wanted
/// velocity changes. The matrix is factored once per step (Cholesky, in the envelope of the rows:
/// linear in the length of a chain whose joints were made in turn) and used in every iteration.
class JointBlock {
 public:
  /// Starts anew with rows in the order of their joints. They must stay where they are.
  void Begin();
  void AddRow(btSolverConstraint* row);
  /// @param bodies  the solver's, to which the rows refer.
  void Factor(btAlignedObjectArray<btSolverBody>& bodies);
  /// Gives the bodies what makes all rows hold, given what else has changed their velocities.
  void Solve(btAlignedObjectArray<btSolverBody>& bodies);

 private:
  double* row_of(int i) { return &envelope_[start_[i]] - first_[i]; }
  void FindEnvelope(int num_bodies, const btAlignedObjectArray<btSolverBody>& bodies);

  std::vector<btSolverConstraint*> rows_;
  std::vector<int> first_;                      ///< of each row, the first column that is not 0
  std::vector<std::size_t> start_;              ///< of each row in the envelope
  std::vector<double> envelope_;                ///< lower triangle, row by row
  std::vector<std::vector<int>> rows_of_body_;  ///< that move it, ascending
  std::vector<double> impulses_;
};

}  // namespace smile::physics
