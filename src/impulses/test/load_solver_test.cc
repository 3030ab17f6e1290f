#include "impulses/load_solver.h"

#include <gtest/gtest.h>

#include <vector>

namespace smile::impulses {
namespace {

constexpr double kFall = 9.81 / 480;  ///< speed that gravity adds in a step [m/s]

/// Loads in a stack of bodies on the ground, of these masses from below.
std::vector<LoadSolver::Load> StackOf(const std::vector<double>& masses) {
  const Vector6 up = Vector6::Of(Vector3::UnitZ(), Vector3::Zero());
  std::vector<LoadSolver::Load> loads;
  for (int i = 0; i < static_cast<int>(masses.size()); ++i) {
    LoadSolver::Load load{.wanted = i == 0 ? kFall : 0, .most = 1000};
    load.sides[0] = {.body = i, .jacobian = up};
    load.sides[0].response.Add(1 / masses[i], up);
    load.sides[1].body = i > 0 ? i - 1 : static_cast<int>(masses.size());
    if (i > 0) {
      load.sides[1].jacobian.Add(-1, up);
      load.sides[1].response.Add(-1 / masses[i - 1], up);
    }
    loads.push_back(load);
  }
  return loads;
}

TEST(LoadSolver, FindsWhatEachBodyOfAStackBears) {
  const std::vector<double> masses(5, 1.0);
  std::vector<LoadSolver::Load> loads = StackOf(masses);
  LoadSolver solver;
  solver.Solve(static_cast<int>(masses.size()) + 1, loads);
  double above = static_cast<double>(masses.size());
  for (const LoadSolver::Load& load : loads) {
    EXPECT_NEAR(load.change, above * kFall, 0.05 * above * kFall);
    above -= 1;
  }
  // What is found remains: the same stack is solved from where nothing is wanted.
  for (LoadSolver::Load& load : loads) load.wanted = 0;
  solver.Solve(static_cast<int>(masses.size()) + 1, loads);
  for (const LoadSolver::Load& load : loads) EXPECT_EQ(load.change, 0);
}

TEST(LoadSolver, KeepsWithinReasonWhatNothingCanHold) {
  // A body that is pressed from both sides.
  std::vector<LoadSolver::Load> loads = StackOf({1});
  loads.push_back(loads.front());
  for (LoadSolver::Side& side : loads.back().sides) {
    Vector6 jacobian, response;
    jacobian.Add(-1, side.jacobian);
    response.Add(-1, side.response);
    side.jacobian = jacobian;
    side.response = response;
  }
  for (LoadSolver::Load& load : loads) load.most = 3;
  LoadSolver().Solve(2, loads);
  for (const LoadSolver::Load& load : loads) EXPECT_EQ(load.change, 3);
}

}  // namespace
}  // namespace smile::impulses
