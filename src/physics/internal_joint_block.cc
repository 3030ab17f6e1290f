#include "physics/internal_joint_block.h"

#include <algorithm>
#include <cmath>

namespace smile::physics {
namespace {

/// Softens every row by this share of itself, so that joints that say the same thing twice, as in a
/// closed loop, share the work.
constexpr double kSoftness = 1e-9;
/// The same for taking back what came apart: with 1e-3, a chain of 20 links that is 1 % too long
/// for its ends breaks into a tangle; with 0.1 it bends. A sag of 0.1 um is not made worse by it,
/// since velocities are exact.
constexpr double kReturnSoftness = 0.1;

/// The part of a row that acts on one of its two bodies.
struct Side {
  Side(const btSolverConstraint& row, int body)
      : normal(row.m_solverBodyIdA == body ? row.m_contactNormal1 : row.m_contactNormal2),
        turn(row.m_solverBodyIdA == body ? row.m_relpos1CrossNormal : row.m_relpos2CrossNormal),
        turning(row.m_solverBodyIdA == body ? row.m_angularComponentA : row.m_angularComponentB) {}

  const btVector3 &normal, &turn, &turning;
};

/// How much speed along `row` an impulse along `other` makes, through one body.
double Response(const btSolverConstraint& row, const btSolverConstraint& other, int body,
                double inverse_mass) {
  const Side a(row, body), b(other, body);
  return a.normal.dot(b.normal) * inverse_mass + a.turn.dot(b.turning);
}

double SpeedGained(const btSolverConstraint& row,
                   const btAlignedObjectArray<btSolverBody>& bodies) {
  const btSolverBody& a = bodies[row.m_solverBodyIdA];
  const btSolverBody& b = bodies[row.m_solverBodyIdB];
  return row.m_contactNormal1.dot(a.m_deltaLinearVelocity) +
         row.m_relpos1CrossNormal.dot(a.m_deltaAngularVelocity) +
         row.m_contactNormal2.dot(b.m_deltaLinearVelocity) +
         row.m_relpos2CrossNormal.dot(b.m_deltaAngularVelocity);
}

void Apply(const btSolverConstraint& row, double impulse,
           btAlignedObjectArray<btSolverBody>& bodies) {
  btSolverBody& a = bodies[row.m_solverBodyIdA];
  btSolverBody& b = bodies[row.m_solverBodyIdB];
  a.internalApplyImpulse(row.m_contactNormal1 * a.internalGetInvMass(), row.m_angularComponentA,
                         impulse);
  b.internalApplyImpulse(row.m_contactNormal2 * b.internalGetInvMass(), row.m_angularComponentB,
                         impulse);
  row.m_appliedImpulse += impulse;
}

}  // namespace

void JointBlock::Begin() {
  rows_.clear();
  return_speeds_.clear();
}

void JointBlock::AddRow(btSolverConstraint* row, double return_speed) {
  rows_.push_back(row);
  return_speeds_.push_back(return_speed);
}

void JointBlock::Factor(btAlignedObjectArray<btSolverBody>& bodies) {
  FindEnvelope(bodies.size(), bodies);
  Assemble(bodies);
  ReduceReturns();
  FactorInPlace(kSoftness, &matrix_);
}

void JointBlock::FindEnvelope(int num_bodies, const btAlignedObjectArray<btSolverBody>& bodies) {
  rows_of_body_.resize(std::max<std::size_t>(rows_of_body_.size(), num_bodies));
  for (auto& touching : rows_of_body_) touching.clear();
  first_.clear();
  start_.assign(1, 0);
  for (int i = 0; i < static_cast<int>(rows_.size()); ++i) {
    int first = i;
    for (int body : {rows_[i]->m_solverBodyIdA, rows_[i]->m_solverBodyIdB}) {
      if (bodies[body].internalGetInvMass().x() == 0) continue;
      rows_of_body_[body].push_back(i);
      first = std::min(first, rows_of_body_[body].front());
    }
    first_.push_back(first);
    start_.push_back(start_.back() + static_cast<std::size_t>(i - first + 1));
  }
}

void JointBlock::Assemble(btAlignedObjectArray<btSolverBody>& bodies) {
  matrix_.assign(start_.back(), 0.0);
  for (int body = 0; body < bodies.size(); ++body) {
    const double inverse_mass = bodies[body].internalGetInvMass().x();
    const std::vector<int>& touching = rows_of_body_[body];
    for (std::size_t i = 0; i < touching.size(); ++i) {
      double* line = row_of(touching[i], &matrix_);
      for (std::size_t k = 0; k <= i; ++k) {
        line[touching[k]] += Response(*rows_[touching[i]], *rows_[touching[k]], body, inverse_mass);
      }
    }
  }
}

void JointBlock::FactorInPlace(double softness, Envelope* matrix) const {
  for (int i = 0; i < static_cast<int>(rows_.size()); ++i) {
    double* line = row_of(i, matrix);
    const double soft = softness * line[i];
    for (int j = first_[i]; j <= i; ++j) {
      const double* other = row_of(j, *matrix);
      double sum = line[j];
      for (int k = std::max(first_[i], first_[j]); k < j; ++k) sum -= line[k] * other[k];
      line[j] = j < i ? sum / other[j] : std::sqrt(std::max(sum + soft, soft));
    }
  }
}

void JointBlock::SolveInPlace(const Envelope& factored, std::vector<double>* x) const {
  const int count = static_cast<int>(rows_.size());
  for (int i = 0; i < count; ++i) {
    const double* line = row_of(i, factored);
    double sum = (*x)[i];
    for (int k = first_[i]; k < i; ++k) sum -= line[k] * (*x)[k];
    (*x)[i] = sum / line[i];
  }
  for (int i = count - 1; i >= 0; --i) {
    const double* line = row_of(i, factored);
    (*x)[i] /= line[i];
    for (int k = first_[i]; k < i; ++k) (*x)[k] -= line[k] * (*x)[i];
  }
}

/// Asks for the speeds e' = A x that the impulses x of the softened rows, (A + s D) x = e, make.
void JointBlock::ReduceReturns() {
  if (std::ranges::all_of(return_speeds_, [](double speed) { return speed == 0; })) return;
  softened_ = matrix_;
  FactorInPlace(kReturnSoftness, &softened_);
  impulses_ = return_speeds_;
  SolveInPlace(softened_, &impulses_);
  for (int i = 0; i < static_cast<int>(rows_.size()); ++i) {
    const double missing = kReturnSoftness * row_of(i, matrix_)[i] * impulses_[i];
    rows_[i]->m_rhs -= missing * rows_[i]->m_jacDiagABInv;
  }
}

void JointBlock::Solve(btAlignedObjectArray<btSolverBody>& bodies) {
  impulses_.resize(rows_.size());
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    const btSolverConstraint& row = *rows_[i];
    impulses_[i] = row.m_rhs / row.m_jacDiagABInv - SpeedGained(row, bodies);
  }
  SolveInPlace(matrix_, &impulses_);
  for (std::size_t i = 0; i < rows_.size(); ++i) Apply(*rows_[i], impulses_[i], bodies);
}

}  // namespace smile::physics
