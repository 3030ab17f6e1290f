#include "motion/inverse_kinematics.h"

#include <algorithm>
#include <random>

#include "motion/internal_descent.h"

namespace smile::motion {
namespace {

/// The attempt from which on starts lie anywhere within limits.
constexpr int kAnywhere = 8;

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
  const Descent descent(arm, X_WG_goal, options);
  std::mt19937_64 random(options.seed);
  int iterations_left = options.max_iterations;
  ArmVector q = start;
  for (int attempt = 1; iterations_left > 0; ++attempt) {
    if (descent.Run(&q, &iterations_left)) return std::vector<double>(q.begin(), q.end());
    q = Elsewhere(arm, start, attempt, &random);
  }
  return std::nullopt;
}

}  // namespace smile::motion
