#include "math/principal_inertia.h"

#include <Eigen/Eigenvalues>

namespace smile {

PrincipalInertia PrincipalInertiaOf(const Matrix3& inertia) {
  // Relative to the trace: the same body in other units has the same axes.
  const Matrix3 off_diagonal = inertia - Matrix3(inertia.diagonal().asDiagonal());
  if (off_diagonal.cwiseAbs().maxCoeff() <= 1e-12 * inertia.trace()) {
    return {.moments = inertia.diagonal()};
  }
  const Eigen::SelfAdjointEigenSolver<Matrix3> solver(inertia);
  PrincipalInertia result{.axes = solver.eigenvectors(), .moments = solver.eigenvalues()};
  // Eigenvectors may be left-handed; a rotation must not be.
  if (result.axes.determinant() < 0) result.axes.col(0) *= -1;
  return result;
}

}  // namespace smile
