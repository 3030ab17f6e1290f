#include "impulses/load_solver.h"

#include <algorithm>

// Conjugate gradients, preconditioned by the diagonal. With the Jacobian J of all loads and the
// inverse masses W, the changes x satisfy (J W J^T + softness) x = wanted changes of speed.

namespace smile::impulses {
namespace {

/// Iterations at most, and the part of the residual at which they end. Where more bear a body than
/// need to, further iterations move loads to and fro between them from step to step.
constexpr int kMaxIterations = 24;
constexpr double kTolerance = 1e-3;
/// A load yields by this part of its response, so that loads between immovable bodies stay finite.
constexpr double kLoadSoftness = 1e-3;

}  // namespace

void LoadSolver::MakeRows(std::span<Load> loads) {
  rows_.clear();
  for (Load& load : loads) {
    load.change = 0;
    double response = 0;
    for (const Side& side : load.sides) response += side.jacobian.Dot(side.response);
    rows_.push_back({.inverse = 1 / response,
                     .residual = load.wanted,
                     .direction = load.wanted / response,
                     .image = 0});
  }
}

/// Makes each image that of all directions.
void LoadSolver::Multiply(std::span<const Load> loads) {
  std::ranges::fill(velocities_, Vector6());
  for (std::size_t i = 0; i < loads.size(); ++i) {
    for (const Side& side : loads[i].sides) {
      velocities_[side.body].Add(rows_[i].direction, side.response);
    }
  }
  for (std::size_t i = 0; i < loads.size(); ++i) {
    Row& row = rows_[i];
    row.image = kLoadSoftness * row.direction / row.inverse;
    for (const Side& side : loads[i].sides) row.image += side.jacobian.Dot(velocities_[side.body]);
  }
}

void LoadSolver::Solve(int num_bodies, std::span<Load> loads) {
  MakeRows(loads);
  velocities_.resize(num_bodies);
  double squared = 0;
  for (const Row& row : rows_) squared += row.residual * row.inverse * row.residual;
  const double enough = kTolerance * kTolerance * squared;
  for (int iteration = 0; iteration < kMaxIterations && squared > enough; ++iteration) {
    Multiply(loads);
    double curvature = 0;
    for (const Row& row : rows_) curvature += row.direction * row.image;
    const double length = squared / curvature;
    double next = 0;
    for (std::size_t i = 0; i < loads.size(); ++i) {
      Row& row = rows_[i];
      loads[i].change += length * row.direction;
      row.residual -= length * row.image;
      next += row.residual * row.inverse * row.residual;
    }
    for (Row& row : rows_) {
      row.direction = row.inverse * row.residual + next / squared * row.direction;
    }
    squared = next;
  }
  for (Load& load : loads) load.change = std::clamp(load.change, -load.most, load.most);
}

}  // namespace smile::impulses
