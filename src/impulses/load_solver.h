#pragma once

#include <array>
#include <span>
#include <vector>

#include "impulses/vector6.h"

namespace smile::impulses {

/// Finds what the patches of an island bear, for all of them together.
///
/// Sweeps carry the weight of a body down a stack by one body each, so that a high stack sinks
/// while its impulses grow. Here a patch has up to three unknowns, the changes of its load and of
/// the torques that tip one body over on the other. Conjugate gradients reach the bottom of a stack
/// in as many iterations as it has bodies, and an iteration costs a small part of a sweep.
class LoadSolver {
 public:
  /// What a load has to do with one of the bodies between which it acts.
  struct Side {
    int body;          ///< its index
    Vector6 jacobian;  ///< speed along the load per velocity of the body; 0 if it cannot move
    Vector6 response;  ///< velocity of the body that a unit of the load causes
  };
  struct Load {
    std::array<Side, 2> sides;
    double wanted;      ///< change of speed along the load
    double most;        ///< change of the load, either way
    double change = 0;  ///< result
  };

  /// Finds the changes of loads that give the changes of speed wanted.
  void Solve(int num_bodies, std::span<Load> loads);

 private:
  /// A load in the course of iterations.
  struct Row {
    double inverse;   ///< of the response along the load, while no other load changes
    double residual;  ///< change of speed still wanted
    double direction, image;
  };
  void Multiply(std::span<const Load> loads);
  void MakeRows(std::span<Load> loads);

  std::vector<Row> rows_;
  std::vector<Vector6> velocities_;  ///< by body; scratch space of Multiply()
};

}  // namespace smile::impulses
