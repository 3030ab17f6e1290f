#include "motion/inverse_kinematics.h"

#include <algorithm>
#include <random>

#include "motion/internal_damped_least_squares.h"

namespace smile::motion {
namespace {

/// The attempt from which on starts lie anywhere within limits.
constexpr int kAnywhere = 8;
/// So many answers of further attempts are compared, if they are found soon after the first.
constexpr int kCandidates = 4;
constexpr int kIterationsForNearer = 100;

/// Between 0 and 1, the same on every machine.
double Share(std::mt19937_64* random) { return static_cast<double>((*random)() >> 11) * 0x1.0p-53; }

/// A start for a further attempt: from `q_start` towards somewhere within limits.
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
  if (solver.Run(&q, &iterations_left)) return std::vector<double>(q.begin(), q.end());

  // From here on an answer may lie anywhere: of a few, the nearest.
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

}  // namespace smile::motion
