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
///
/// Velocities are always possible; to take back what came apart may not be, as in a taut chain that
/// is too long for its ends: exactly solved, that would be a blow without end. So the speeds with
/// which rows return are first reduced to what can be had by moderate impulses.
class JointBlock {
 public:
  /// Starts anew with rows in the order of their joints. They must stay where they are.
  void Begin();
  /// @param return_speed  the part of the row's wanted speed that takes back what came apart.
  void AddRow(btSolverConstraint* row, double return_speed);
  /// @param bodies  the solver's, to which the rows refer.
  void Factor(btAlignedObjectArray<btSolverBody>& bodies);
  /// Gives the bodies what makes all rows hold, given what else has changed their velocities.
  void Solve(btAlignedObjectArray<btSolverBody>& bodies);

 private:
  using Envelope = std::vector<double>;  ///< lower triangle, row by row

  double* row_of(int i, Envelope* matrix) const { return &(*matrix)[start_[i]] - first_[i]; }
  const double* row_of(int i, const Envelope& matrix) const {
    return &matrix[start_[i]] - first_[i];
  }
  void FindEnvelope(int num_bodies, const btAlignedObjectArray<btSolverBody>& bodies);
  void Assemble(btAlignedObjectArray<btSolverBody>& bodies);
  /// @param softness  by which share of itself each row is softened.
  void FactorInPlace(double softness, Envelope* matrix) const;
  void SolveInPlace(const Envelope& factored, std::vector<double>* x) const;
  void ReduceReturns();

  std::vector<btSolverConstraint*> rows_;
  std::vector<double> return_speeds_;
  std::vector<int> first_;          ///< of each row, the first column that is not 0
  std::vector<std::size_t> start_;  ///< of each row in the envelope
  Envelope matrix_, softened_;
  std::vector<std::vector<int>> rows_of_body_;  ///< that move it, ascending
  std::vector<double> impulses_;
};

}  // namespace smile::physics
