#pragma once

#include <array>
#include <span>
#include <vector>

#include "impulses/body.h"
#include "sparse/block_matrix.h"
#include "sparse/elimination.h"

namespace smile::impulses {

/// Direction in which a joint holds two bodies.
struct JointRow {
  /// What it has to do with one of the bodies.
  struct Side {
    int body;         ///< its index
    Vector3 linear;   ///< speed along the row per velocity of the body
    Vector3 angular;  ///< per angular velocity [m or 1]
    Vector3 turning;  ///< change of its angular velocity per unit impulse [1/(kg m) or 1/(kg m2)]
  };
  std::array<Side, 2> sides;
  /// Impulse per change of speed along the row, while no other row answers [kg or kg m2].
  double inverse_response;
  double impulse_alone;  ///< that makes the row hold, while no other row answers [N s or N m s]
  /// The part of the row's wanted speed that corrects a position error [m/s or rad/s].
  double return_speed;
};

/// Direct solver for the rows of all joints together, instead of one row after another.
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
class JointSolver {
 public:
  /// Removes all rows, for a new step.
  void Begin();
  /// Adds a row. Rows come in the order of their joints.
  /// @param is_next  true for another row of the same joint as the last one.
  void AddRow(const JointRow& row, bool is_next);
  /// Factors the matrix. Rows of islands that are too much work are left out: see is_solved().
  void Factor(std::span<const Body> bodies);
  /// Applies the impulses that make all rows hold, given all other changes of the bodies'
  /// velocities so far.
  void Solve(std::span<const Body> bodies);

  /// Returns false for a row that is left to other methods.
  bool is_solved(int row) const { return rows_[row].unknown >= 0; }
  /// Returns the sum of the impulses of a row in this step [N s or N m s].
  double impulse(int row) const { return rows_[row].impulse; }

 private:
  struct Row : JointRow {
    double self_response;  ///< its diagonal entry of J W J^T
    int unknown = -1;      ///< its index among the unknowns; -1: left out
    double impulse = 0;    ///< so far
  };
  /// The rows of one joint.
  struct JointRows {
    int first, count;
  };

  void FindJointsOfBodies(std::span<const Body> bodies);
  void FindGraph();
  void PlaceRows();
  void Assemble(std::span<const Body> bodies);
  void AssemblePair(int joint, int other, int body, double inverse_mass);
  void AssembleSupernode(int node, int body, const Body& supernode);
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

}  // namespace smile::impulses
