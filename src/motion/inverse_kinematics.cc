#include "motion/inverse_kinematics.h"

#include <algorithm>
#include <random>

#include "motion/internal_damped_least_squares.h"

namespace smile::motion {
namespace {

/// From this attempt on, starts lie anywhere within limits.
constexpr int kAnywhere = 8;
/// Number of solutions of further attempts that are compared, if they are found soon after the
/// first.
constexpr int kCandidates = 4;
constexpr int kIterationsForNearer = 100;

/// Returns a random number from 0 to below 1, the same on each machine: std distributions differ
/// between libraries.
double Share(std::mt19937_64* random) { return static_cast<double>((*random)() >> 11) * 0x1.0p-53; }

/// Returns a start for a further attempt: from `q_start` towards a random place within limits,
/// farther with each attempt.
ArmVector Elsewhere(const ArmKinematics& arm, const ArmVector& q_start, int attempt,
                    std::mt19937_64* random) {
  const double reach = std::min(1.0, static_cast<double>(attempt) / kAnywhere);
  ArmVector q = q_start;
  for (int i = 0; i < arm.num_joints(); ++i) {
    const JointLimits& limit = arm.limits()[i];
    const double anywhere = limit.lower + Share(random) * (limit.upper - limit.lower);
    q[i] = std::clamp(q[i] + reach * (anywhere - q[i]), limit.lower, limit.upper);
  }
  return q;
}

}  // namespace

std::optional<std::vector<double>> SolveInverseKinematics(const ArmKinematics& arm,
                                                          const RigidTransform& X_WG_goal,
                                                          std::span<const double> q_start,
                                                          const IkOptions& options) {
  CheckGoal(X_WG_goal);
  CheckOptions(options);
  const ArmVector start = WithinLimits(arm, q_start);
  const DampedLeastSquares solver(arm, X_WG_goal, options);
  int iterations_left = options.max_iterations;
  ArmVector q = start;
  // The first attempt usually ends near `q_start`: take its solution without a comparison.
  if (solver.Run(&q, &iterations_left)) return std::vector<double>(q.begin(), q.end());

  // Solutions of other starts may lie anywhere: take the nearest of a few.
  std::mt19937_64 random(options.seed);
  std::optional<ArmVector> nearest;
  for (int attempt = 1, num_found = 0; iterations_left > 0 && num_found < kCandidates; ++attempt) {
    q = Elsewhere(arm, start, attempt, &random);
    if (!solver.Run(&q, &iterations_left)) continue;
    if (num_found++ == 0) iterations_left = std::min(iterations_left, kIterationsForNearer);
    if (!nearest || (q - start).squaredNorm() < (*nearest - start).squaredNorm()) nearest = q;
  }
  if (nearest) return std::vector<double>(nearest->begin(), nearest->end());
  return std::nullopt;
}

std::string WhyUnreachable(const ArmKinematics& arm, const RigidTransform& X_WG_goal,
                           std::span<const double> q_start, const IkOptions& options) {
  const auto is_reached = [&](IkOptions relaxed) {
    return SolveInverseKinematics(arm, X_WG_goal, q_start, relaxed).has_value();
  };
  IkOptions turned = options, rotated = options;
  turned.any_turn = rotated.any_rotation = true;
  std::string reason = "the tool does not reach this place";
  if (!options.any_rotation && is_reached(rotated)) {
    reason = "the tool reaches this place with another rotation only";
    if (!options.any_turn && is_reached(turned)) {
      reason = "the tool reaches this place and direction with another turn about its axis only";
    }
    if (arm.num_joints() < 6) {
      reason +=
          ": an arm of " + std::to_string(arm.num_joints()) + " joints cannot take every rotation";
    }
  }
  return reason;
}

}  // namespace smile::motion
