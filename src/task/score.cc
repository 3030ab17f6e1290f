#include "task/score.h"

#include <cmath>
#include <vector>

namespace smile::task {
namespace {

/// Where an object was in the demonstration (A), and where its counterpart is now (B).
struct Pair {
  RigidTransform X_WA, X_WB;
};

/// A shift on the table and a turn about z.
struct TableMotion {
  double angle = 0;
  Eigen::Vector2d shift = Eigen::Vector2d::Zero();

  RigidTransform transform() const {
    return {Eigen::AngleAxisd(angle, Vector3::UnitZ()).toRotationMatrix(),
            Vector3(shift.x(), shift.y(), 0)};
  }
};

Eigen::Vector2d Ground(const RigidTransform& X) { return X.translation().head<2>(); }

double YawOf(const RigidTransform& X) { return std::atan2(X.rotation()(1, 0), X.rotation()(0, 0)); }

/// The motion with this turn that carries `from` to `to`.
TableMotion MotionTo(double angle, const Eigen::Vector2d& from, const Eigen::Vector2d& to) {
  return {angle, to - Eigen::Rotation2Dd(angle) * from};
}

double ErrorOf(const Pair& pair, const TableMotion& motion) {
  return (motion.transform() * pair.X_WA.translation() - pair.X_WB.translation()).norm();
}

std::vector<Pair> Within(const std::vector<Pair>& pairs, const TableMotion& motion,
                         double tolerance) {
  std::vector<Pair> near;
  for (const Pair& pair : pairs) {
    if (ErrorOf(pair, motion) <= tolerance) near.push_back(pair);
  }
  return near;
}

/// Least squares on the ground plane. Pairs that lie above one another say nothing about the turn:
/// then `angle` stays.
TableMotion Fit(const std::vector<Pair>& pairs, double angle) {
  constexpr double kSpread = 1e-4;  // [m2]
  Eigen::Vector2d center_a = Eigen::Vector2d::Zero(), center_b = center_a;
  for (const Pair& pair : pairs) {
    center_a += Ground(pair.X_WA) / static_cast<double>(pairs.size());
    center_b += Ground(pair.X_WB) / static_cast<double>(pairs.size());
  }
  double along = 0, across = 0, spread = 0;
  for (const Pair& pair : pairs) {
    const Eigen::Vector2d a = Ground(pair.X_WA) - center_a, b = Ground(pair.X_WB) - center_b;
    along += a.dot(b);
    across += a.x() * b.y() - a.y() * b.x();
    spread += a.squaredNorm();
  }
  if (spread > kSpread) angle = std::atan2(across, along);
  return MotionTo(angle, center_a, center_b);
}

/// The best of all motions that one object or two objects suggest.
TableMotion FindMotion(const std::vector<Pair>& pairs, double tolerance) {
  TableMotion best;
  std::size_t best_count = 0;
  double best_error = 0;
  const auto consider = [&](const TableMotion& motion) {
    const std::vector<Pair> near = Within(pairs, motion, tolerance);
    double error = 0;
    for (const Pair& pair : near) error += ErrorOf(pair, motion);
    if (near.size() > best_count || (near.size() == best_count && error < best_error)) {
      best = motion;
      best_count = near.size();
      best_error = error;
    }
  };
  for (const Pair& one : pairs) {
    consider(MotionTo(YawOf(one.X_WB) - YawOf(one.X_WA), Ground(one.X_WA), Ground(one.X_WB)));
    for (const Pair& other : pairs) {
      const Eigen::Vector2d a = Ground(other.X_WA) - Ground(one.X_WA);
      const Eigen::Vector2d b = Ground(other.X_WB) - Ground(one.X_WB);
      if (a.norm() < tolerance || b.norm() < tolerance) continue;
      consider(MotionTo(std::atan2(b.y(), b.x()) - std::atan2(a.y(), a.x()), Ground(one.X_WA),
                        Ground(one.X_WB)));
    }
  }
  const std::vector<Pair> near = Within(pairs, best, tolerance);
  if (!near.empty()) consider(Fit(near, best.angle));
  return best;
}

}  // namespace

Score ScoreOutcome(const Goal& goal, const std::map<std::string, std::string>& match,
                   const ObjectPoses& outcome, double tolerance) {
  std::vector<Pair> pairs;
  for (const scene::ObjectSpec& object : goal.objects) {
    pairs.push_back({object.pose_in_world(), outcome.at(match.at(object.id()))});
  }
  const TableMotion motion = FindMotion(pairs, tolerance);
  Score score;
  const auto count = static_cast<double>(pairs.size());
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const std::string& id = goal.objects[i].id();
    score.goal[id] = motion.transform() * pairs[i].X_WA;
    score.errors[id] = ErrorOf(pairs[i], motion);
    score.mean_error += score.errors[id] / count;
  }
  score.share = static_cast<double>(Within(pairs, motion, tolerance).size()) / count;
  return score;
}

}  // namespace smile::task
