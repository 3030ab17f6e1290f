// Assembly and solution of the joint equations. In block form, with the joint impulses x and the
// scaled velocity changes u of the supernodes,
//
//     [ A    B ] [ x ]   [ wanted changes of speed ]
//     [ B^T -I ] [ u ] = [ 0                       ]
//
// A holds the responses through low-degree bodies, B = J_hub R with W_hub = R R^T. Eliminating u
// gives A + B B^T = J W J^T. The matrix is quasidefinite, so L D L^T exists for each order in which
// a joint with a zero block in A comes after one of its supernodes. docs/decisions/physics.md has
// the measurements.

#include "impulses/joint_solver.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace smile::impulses {
namespace {

/// Softens each row by this fraction of its own response, so that redundant joints, as in a closed
/// loop, share the load instead of making the matrix singular.
constexpr double kSoftness = 1e-9;
/// Softness for position errors: with 1e-3, a chain of 20 links that is 1 % too long for its ends
/// breaks into a tangle; with 0.1 it bends. It does not increase a sag of 0.1 um, since velocities
/// are exact.
constexpr double kReturnSoftness = 0.1;
/// Upper bound of multiplications per factorization, about 30 ms. 300 guests on a supernode take a
/// hundredth of it.
constexpr double kMaxWork = 3e7;

/// Unknowns of a supernode: linear and angular velocity change.
constexpr int kSupernodeRows = 6;
/// A body with more joints than this is a supernode.
constexpr std::size_t kMaxJointsOfLowDegree = 2;

// The order of these sums is part of what replays: Eigen's products have another.

double Dot(const Vector3& a, const Vector3& b) {
  return a.x() * b.x() + a.y() * b.y() + a.z() * b.z();
}

const JointRow::Side& SideOf(const JointRow& row, int body) {
  return row.sides[0].body == body ? row.sides[0] : row.sides[1];
}

/// Returns the change of speed along `row` per unit impulse along `other`, through one body that
/// both rows act on.
double Response(const JointRow& row, const JointRow& other, int body, double inverse_mass) {
  const JointRow::Side &a = SideOf(row, body), &b = SideOf(other, body);
  return Dot(a.linear, b.linear) * inverse_mass + Dot(a.angular, b.turning);
}

/// Scales a supernode's velocity change by the root R of its inverse inertia (R R^T = W), so that
/// its own block of the matrix is -I.
class SupernodeScale {
 public:
  explicit SupernodeScale(const Body& body) : root_inverse_mass_(std::sqrt(body.inverse_mass)) {
    // Cholesky factor of the inverse inertia; a body that cannot rotate has zeros here.
    const Matrix3& inverse = body.inverse_inertia;
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j <= i; ++j) {
        double sum = inverse(i, j);
        for (int k = 0; k < j; ++k) sum -= root_(i, k) * root_(j, k);
        if (i == j) {
          root_(i, i) = std::sqrt(std::max(sum, 0.0));
        } else {
          root_(i, j) = root_(j, j) > 0 ? sum / root_(j, j) : 0;
        }
      }
    }
  }

  /// Returns the row of B: the derivative of the speed along a row by each unknown of the
  /// supernode.
  std::array<double, kSupernodeRows> SpeedsOf(const JointRow::Side& side) const {
    const Vector3 linear = side.linear * root_inverse_mass_;
    const auto angular = [&](int k) { return Dot(root_.col(k), side.angular); };
    return {linear.x(), linear.y(), linear.z(), angular(0), angular(1), angular(2)};
  }

 private:
  double root_inverse_mass_;
  Matrix3 root_ = Matrix3::Zero();
};

/// Returns the speed along a row that this step's impulses have produced so far, in m/s or rad/s.
double SpeedGained(const JointRow& row, std::span<const Body> bodies) {
  const auto& [side_a, side_b] = row.sides;
  const Body &a = bodies[side_a.body], &b = bodies[side_b.body];
  return Dot(side_a.linear, ChangeOfV(a)) + Dot(side_a.angular, ChangeOfW(a)) +
         Dot(side_b.linear, ChangeOfV(b)) + Dot(side_b.angular, ChangeOfW(b));
}

/// Applies an impulse along a row to both bodies.
void Apply(const JointRow& row, double impulse, std::span<const Body> bodies) {
  for (const JointRow::Side& side : row.sides) {
    const Body& body = bodies[side.body];
    if (!body.is_movable()) continue;
    ChangeOfV(body) += side.linear * body.inverse_mass * impulse;
    ChangeOfW(body) += side.turning * impulse;
  }
}

}  // namespace

void JointSolver::Begin() {
  rows_.clear();
  joints_.clear();
}

void JointSolver::AddRow(const JointRow& row, bool is_next) {
  if (!is_next) joints_.push_back({static_cast<int>(rows_.size()), 0});
  ++joints_.back().count;
  rows_.push_back({row, /*self_response=*/1 / row.inverse_response});
}

void JointSolver::Factor(std::span<const Body> bodies) {
  FindJointsOfBodies(bodies);
  FindGraph();
  // The order depends only on the pattern of the matrix: keep it while joints and bodies stay the
  // same.
  if (graph_ != ordered_graph_) {
    elimination_ = sparse::OrderElimination(graph_, kMaxWork);
    ordered_graph_ = graph_;
  }
  matrix_.Begin(&elimination_);
  PlaceRows();
  Assemble(bodies);
  ReduceReturns();
  FactorSoftened(kSoftness, &matrix_);
}

/// Sorts movable bodies into low-degree ones and supernodes, in the order of their joints.
void JointSolver::FindJointsOfBodies(std::span<const Body> bodies) {
  joints_of_.resize(std::max<std::size_t>(joints_of_.size(), bodies.size()));
  for (auto& joints : joints_of_) joints.clear();
  low_degree_bodies_.clear();
  supernodes_.clear();
  for (std::size_t joint = 0; joint < joints_.size(); ++joint) {
    const JointRow& row = rows_[joints_[joint].first];
    for (const int body : {row.sides[0].body, row.sides[1].body}) {
      // Static and kinematic bodies respond to no impulse: they couple no rows.
      if (!bodies[body].is_movable()) continue;
      joints_of_[body].push_back(static_cast<int>(joint));
      const std::size_t count = joints_of_[body].size();
      if (count == 1) low_degree_bodies_.push_back(body);
      if (count == kMaxJointsOfLowDegree + 1) supernodes_.push_back(body);
    }
  }
  std::erase_if(low_degree_bodies_,
                [this](int body) { return joints_of_[body].size() > kMaxJointsOfLowDegree; });
}

/// Builds the graph of the matrix. Nodes are the joints, followed by the supernodes.
void JointSolver::FindGraph() {
  graph_.sizes.clear();
  for (const JointRows& joint : joints_) graph_.sizes.push_back(joint.count);
  graph_.sizes.resize(joints_.size() + supernodes_.size(), kSupernodeRows);
  graph_.neighbours.assign(graph_.sizes.size(), {});
  graph_.is_deferred.assign(graph_.sizes.size(), false);
  // A joint without a low-degree body has a zero block in A and must wait for a supernode.
  std::fill_n(graph_.is_deferred.begin(), joints_.size(), true);
  const auto connect = [this](int a, int b) {
    graph_.neighbours[a].push_back(b);
    graph_.neighbours[b].push_back(a);
  };
  for (int body : low_degree_bodies_) {
    const std::vector<int>& joints = joints_of_[body];
    for (int joint : joints) graph_.is_deferred[joint] = false;
    if (joints.size() == 2) connect(joints[0], joints[1]);
  }
  for (std::size_t i = 0; i < supernodes_.size(); ++i) {
    for (int joint : joints_of_[supernodes_[i]])
      connect(joint, static_cast<int>(joints_.size() + i));
  }
  for (auto& neighbours : graph_.neighbours) {
    std::sort(neighbours.begin(), neighbours.end());
    neighbours.erase(std::unique(neighbours.begin(), neighbours.end()), neighbours.end());
  }
}

/// Assigns each row its unknown.
void JointSolver::PlaceRows() {
  for (std::size_t joint = 0; joint < joints_.size(); ++joint) {
    const int place = elimination_.place_of_node[joint];
    if (place < 0) continue;
    for (int i = 0; i < joints_[joint].count; ++i) {
      rows_[joints_[joint].first + i].unknown = matrix_.first_row(place) + i;
    }
  }
}

/// Fills in A through low-degree bodies, and B through supernodes.
void JointSolver::Assemble(std::span<const Body> bodies) {
  for (int body : low_degree_bodies_) {
    const double inverse_mass = bodies[body].inverse_mass;
    const std::vector<int>& joints = joints_of_[body];
    for (int joint : joints) AssemblePair(joint, joint, body, inverse_mass);
    if (joints.size() == 2) AssemblePair(joints[0], joints[1], body, inverse_mass);
  }
  for (std::size_t i = 0; i < supernodes_.size(); ++i) {
    AssembleSupernode(static_cast<int>(joints_.size() + i), supernodes_[i], bodies[supernodes_[i]]);
  }
}

/// Adds the responses between the rows of two joints through a low-degree body. Only blocks on and
/// below the diagonal exist, so the joint that is eliminated first is the column.
void JointSolver::AssemblePair(int joint, int other, int body, double inverse_mass) {
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
      *entry++ += Response(rows_[rows.first + i], rows_[columns.first + k], body, inverse_mass);
    }
  }
}

/// Fills in -I and the blocks of B or B^T, depending on whether the joint or the supernode comes
/// first.
void JointSolver::AssembleSupernode(int node, int body, const Body& supernode) {
  const int place = elimination_.place_of_node[node];
  if (place < 0) return;
  const SupernodeScale scale(supernode);
  for (int i = 0; i < kSupernodeRows; ++i) matrix_.diagonal(place, i) = -1;
  for (int joint : joints_of_[body]) {
    const int joint_place = elimination_.place_of_node[joint];
    const JointRows rows = joints_[joint];
    const bool is_joint_first = joint_place < place;
    double* block =
        is_joint_first ? matrix_.block(place, joint_place) : matrix_.block(joint_place, place);
    for (int i = 0; i < rows.count; ++i) {
      const auto speeds = scale.SpeedsOf(SideOf(rows_[rows.first + i], body));
      for (int k = 0; k < kSupernodeRows; ++k) {
        block[is_joint_first ? k * rows.count + i : i * kSupernodeRows + k] = speeds[k];
      }
    }
  }
}

/// Factors with a softness: each joint row is regularized by this fraction of its own response. Hub
/// pivots stay at or below -1.
void JointSolver::FactorSoftened(double softness, sparse::BlockMatrix* matrix) {
  least_pivots_.assign(matrix->num_rows(), -1);  // supernodes
  for (const Row& row : rows_) {
    if (row.unknown >= 0) least_pivots_[row.unknown] = softness * row.self_response;
  }
  matrix->Factor(least_pivots_);
}

/// Reduces the return speeds e to the speeds e' = A x that the impulses x of the softened system
/// (A + s D) x = e produce; e - e' = s D x.
void JointSolver::ReduceReturns() {
  const auto has_none = [](const Row& row) { return row.unknown < 0 || row.return_speed == 0; };
  if (std::ranges::all_of(rows_, has_none)) return;
  softened_ = matrix_;
  FactorSoftened(kReturnSoftness, &softened_);
  unknowns_.assign(matrix_.num_rows(), 0);
  for (const Row& row : rows_) {
    if (row.unknown >= 0) unknowns_[row.unknown] = row.return_speed;
  }
  softened_.Solve(&unknowns_);
  for (Row& row : rows_) {
    if (row.unknown < 0) continue;
    const double missing = kReturnSoftness * row.self_response * unknowns_[row.unknown];
    row.impulse_alone -= missing * row.inverse_response;
  }
}

/// Solves for the impulses that make up the difference between each row's wanted change of speed
/// and its change so far.
void JointSolver::Solve(std::span<const Body> bodies) {
  unknowns_.assign(matrix_.num_rows(), 0);
  for (const Row& row : rows_) {
    if (row.unknown < 0) continue;
    unknowns_[row.unknown] = row.impulse_alone / row.inverse_response - SpeedGained(row, bodies);
  }
  matrix_.Solve(&unknowns_);
  for (Row& row : rows_) {
    if (row.unknown < 0) continue;
    Apply(row, unknowns_[row.unknown], bodies);
    row.impulse += unknowns_[row.unknown];
  }
}

}  // namespace smile::impulses
