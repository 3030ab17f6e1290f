#include "physics/internal_joint_block.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace smile::physics {
namespace {

/// Softens every row by this share of itself, so that joints that say the same thing twice, as in a
/// closed loop, share the work.
constexpr double kSoftness = 1e-9;
/// The same for taking back what came apart: with 1e-3, a chain of 20 links that is 1 % too long
/// for its ends breaks into a tangle; with 0.1 it bends. A sag of 0.1 um is not made worse by it,
/// since velocities are exact.
constexpr double kReturnSoftness = 0.1;
/// Multiplications for a factor, about 30 ms. 300 guests on a hub take a hundredth of it.
constexpr double kMaxWork = 3e7;

constexpr int kHubRows = 6;
/// A body of more joints is a hub.
constexpr std::size_t kMaxJointsOfLight = 2;

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

/// A hub's velocity change in units in which its inertia is 1.
class HubScale {
 public:
  explicit HubScale(const btSolverBody& body)
      : root_inverse_mass_(std::sqrt(body.internalGetInvMass().x())) {
    // Cholesky; a body without inertia has zeros here.
    const btMatrix3x3& inverse = body.m_originalBody->getInvInertiaTensorWorld();
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j <= i; ++j) {
        double sum = inverse[i][j];
        for (int k = 0; k < j; ++k) sum -= root_[i][k] * root_[j][k];
        if (i == j) {
          root_[i][i] = std::sqrt(std::max(sum, 0.0));
        } else {
          root_[i][j] = root_[j][j] > 0 ? sum / root_[j][j] : 0;
        }
      }
    }
  }

  /// How each of its unknowns counts in the speed along a row.
  std::array<double, kHubRows> SpeedsOf(const Side& side) const {
    const btVector3 linear = side.normal * root_inverse_mass_;
    const btVector3 angular = side.turn * root_;  // transposed times turn
    return {linear.x(), linear.y(), linear.z(), angular.x(), angular.y(), angular.z()};
  }

 private:
  double root_inverse_mass_;
  btMatrix3x3 root_ = btMatrix3x3(0, 0, 0, 0, 0, 0, 0, 0, 0);
};

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
  joints_.clear();
}

void JointBlock::AddRow(btSolverConstraint* row, double return_speed) {
  const bool is_next = !rows_.empty() && rows_.back().constraint->m_originalContactPoint ==
                                             row->m_originalContactPoint;
  if (!is_next) joints_.push_back({static_cast<int>(rows_.size()), 0});
  ++joints_.back().count;
  rows_.push_back({row, return_speed, 1 / row->m_jacDiagABInv, -1});
}

void JointBlock::Factor(btAlignedObjectArray<btSolverBody>& bodies) {
  FindJointsOfBodies(bodies);
  FindGraph();
  if (graph_ != ordered_graph_) {
    elimination_ = sparse::OrderElimination(graph_, kMaxWork);
    ordered_graph_ = graph_;
  }
  matrix_.Begin(&elimination_);
  PlaceRows();
  Assemble(bodies);
  std::erase_if(rows_, [](const Row& row) { return row.unknown < 0; });
  ReduceReturns();
  FactorSoftened(kSoftness, &matrix_);
}

void JointBlock::FindJointsOfBodies(const btAlignedObjectArray<btSolverBody>& bodies) {
  joints_of_.resize(std::max<std::size_t>(joints_of_.size(), bodies.size()));
  for (auto& joints : joints_of_) joints.clear();
  light_bodies_.clear();
  hubs_.clear();
  for (std::size_t joint = 0; joint < joints_.size(); ++joint) {
    const btSolverConstraint& row = *rows_[joints_[joint].first].constraint;
    for (int body : {row.m_solverBodyIdA, row.m_solverBodyIdB}) {
      if (bodies[body].internalGetInvMass().x() == 0) continue;
      joints_of_[body].push_back(static_cast<int>(joint));
      const std::size_t count = joints_of_[body].size();
      if (count == 1) light_bodies_.push_back(body);
      if (count == kMaxJointsOfLight + 1) hubs_.push_back(body);
    }
  }
  std::erase_if(light_bodies_,
                [this](int body) { return joints_of_[body].size() > kMaxJointsOfLight; });
}

/// Joints are the first nodes, hubs the others.
void JointBlock::FindGraph() {
  graph_.sizes.clear();
  for (const JointRows& joint : joints_) graph_.sizes.push_back(joint.count);
  graph_.sizes.resize(joints_.size() + hubs_.size(), kHubRows);
  graph_.neighbours.assign(graph_.sizes.size(), {});
  graph_.waits.assign(graph_.sizes.size(), false);
  std::fill_n(graph_.waits.begin(), joints_.size(), true);
  const auto connect = [this](int a, int b) {
    graph_.neighbours[a].push_back(b);
    graph_.neighbours[b].push_back(a);
  };
  for (int body : light_bodies_) {
    const std::vector<int>& joints = joints_of_[body];
    for (int joint : joints) graph_.waits[joint] = false;
    if (joints.size() == 2) connect(joints[0], joints[1]);
  }
  for (std::size_t i = 0; i < hubs_.size(); ++i) {
    for (int joint : joints_of_[hubs_[i]]) connect(joint, static_cast<int>(joints_.size() + i));
  }
  for (auto& neighbours : graph_.neighbours) {
    std::sort(neighbours.begin(), neighbours.end());
    neighbours.erase(std::unique(neighbours.begin(), neighbours.end()), neighbours.end());
  }
}

void JointBlock::PlaceRows() {
  for (std::size_t joint = 0; joint < joints_.size(); ++joint) {
    const int place = elimination_.place_of_node[joint];
    if (place < 0) continue;
    for (int i = 0; i < joints_[joint].count; ++i) {
      Row& row = rows_[joints_[joint].first + i];
      row.unknown = matrix_.first_row(place) + i;
      row.constraint->m_overrideNumSolverIterations = 0;  // Bullet leaves it alone
    }
  }
}

void JointBlock::Assemble(const btAlignedObjectArray<btSolverBody>& bodies) {
  for (int body : light_bodies_) {
    const double inverse_mass = bodies[body].internalGetInvMass().x();
    const std::vector<int>& joints = joints_of_[body];
    for (int joint : joints) AssemblePair(joint, joint, body, inverse_mass);
    if (joints.size() == 2) AssemblePair(joints[0], joints[1], body, inverse_mass);
  }
  for (std::size_t i = 0; i < hubs_.size(); ++i) {
    AssembleHub(static_cast<int>(joints_.size() + i), hubs_[i], bodies[hubs_[i]]);
  }
}

/// What two joints do to each other through a light body.
void JointBlock::AssemblePair(int joint, int other, int body, double inverse_mass) {
  int place = elimination_.place_of_node[joint], other_place = elimination_.place_of_node[other];
  if (place < 0) return;
  if (place > other_place) {
    std::swap(joint, other);
    std::swap(place, other_place);
  }
  double* entry = matrix_.block(other_place, place);
  const JointRows columns = joints_[joint], rows = joints_[other];
  for (int i = 0; i < rows.count; ++i) {
    for (int k = 0; k < columns.count; ++k) {
      *entry++ += Response(*rows_[rows.first + i].constraint, *rows_[columns.first + k].constraint,
                           body, inverse_mass);
    }
  }
}

/// The hub's unknowns are its velocity change, scaled so that its inertia is 1.
void JointBlock::AssembleHub(int node, int body, const btSolverBody& solver_body) {
  const int place = elimination_.place_of_node[node];
  if (place < 0) return;
  const HubScale scale(solver_body);
  for (int i = 0; i < kHubRows; ++i) matrix_.diagonal(place, i) = -1;
  for (int joint : joints_of_[body]) {
    const int joint_place = elimination_.place_of_node[joint];
    const JointRows rows = joints_[joint];
    const bool is_joint_first = joint_place < place;
    double* block =
        is_joint_first ? matrix_.block(place, joint_place) : matrix_.block(joint_place, place);
    for (int i = 0; i < rows.count; ++i) {
      const auto speeds = scale.SpeedsOf(Side(*rows_[rows.first + i].constraint, body));
      for (int k = 0; k < kHubRows; ++k) {
        block[is_joint_first ? k * rows.count + i : i * kHubRows + k] = speeds[k];
      }
    }
  }
}

void JointBlock::FactorSoftened(double softness, sparse::BlockMatrix* matrix) {
  least_pivots_.assign(matrix->num_rows(), -1);  // hubs
  for (const Row& row : rows_) least_pivots_[row.unknown] = softness * row.self_response;
  matrix->Factor(least_pivots_);
}

/// Asks for the speeds e' = A x that the impulses x of the softened rows, (A + s D) x = e, make.
void JointBlock::ReduceReturns() {
  if (std::ranges::all_of(rows_, [](const Row& row) { return row.return_speed == 0; })) return;
  softened_ = matrix_;
  FactorSoftened(kReturnSoftness, &softened_);
  unknowns_.assign(matrix_.num_rows(), 0);
  for (const Row& row : rows_) unknowns_[row.unknown] = row.return_speed;
  softened_.Solve(&unknowns_);
  for (const Row& row : rows_) {
    const double missing = kReturnSoftness * row.self_response * unknowns_[row.unknown];
    row.constraint->m_rhs -= missing * row.constraint->m_jacDiagABInv;
  }
}

void JointBlock::Solve(btAlignedObjectArray<btSolverBody>& bodies) {
  unknowns_.assign(matrix_.num_rows(), 0);
  for (const Row& row : rows_) {
    unknowns_[row.unknown] = row.constraint->m_rhs / row.constraint->m_jacDiagABInv -
                             SpeedGained(*row.constraint, bodies);
  }
  matrix_.Solve(&unknowns_);
  for (const Row& row : rows_) Apply(*row.constraint, unknowns_[row.unknown], bodies);
}

}  // namespace smile::physics
