// MoveThrough(): see arm_moves.h.

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "motion/arm_moves.h"
#include "motion/internal_timing.h"

namespace smile::motion {
namespace {

/// Spans of time are made longer at most so often; what is left, slowing down the whole mends.
constexpr int kMaxRounds = 50;

std::vector<TrajectoryPoint> PointsAt(std::span<const std::vector<double>> waypoints,
                                      std::span<const JointLimits> limits) {
  std::vector<TrajectoryPoint> points;
  for (std::size_t k = 0; k < waypoints.size(); ++k) {
    CheckConfiguration(waypoints[k], limits, "waypoint " + std::to_string(k));
    if (!points.empty() && points.back().positions == waypoints[k]) continue;
    points.push_back({.positions = waypoints[k], .velocities = std::vector(limits.size(), 0.0)});
  }
  return points;
}

/// How long it would take from rest to rest [s].
double SecondsBetween(const TrajectoryPoint& from, const TrajectoryPoint& to,
                      std::span<const JointLimits> limits, double speed) {
  double seconds = 0;
  for (std::size_t i = 0; i < limits.size(); ++i) {
    const double way = std::abs(to.positions[i] - from.positions[i]);
    seconds = std::max({seconds, way / (speed * limits[i].max_velocity),
                        std::sqrt(way / limits[i].max_acceleration)});
  }
  return seconds;
}

/// Times and velocities of all points, for these spans of time.
void Arrange(const std::vector<double>& spans, std::vector<TrajectoryPoint>* points) {
  auto& p = *points;
  for (std::size_t k = 1; k < p.size(); ++k) p[k].seconds = p[k - 1].seconds + spans[k - 1];
  for (std::size_t k = 1; k + 1 < p.size(); ++k) {
    for (std::size_t i = 0; i < p[k].positions.size(); ++i) {
      const double before = (p[k].positions[i] - p[k - 1].positions[i]) / spans[k - 1];
      const double after = (p[k + 1].positions[i] - p[k].positions[i]) / spans[k];
      p[k].velocities[i] = CalmSlope(before, after, spans[k - 1], spans[k]);
    }
  }
}

}  // namespace

std::vector<TrajectoryPoint> MoveThrough(std::span<const std::vector<double>> waypoints,
                                         std::span<const JointLimits> limits, double speed) {
  CheckSpeed(speed);
  if (waypoints.empty()) throw std::invalid_argument("there are no waypoints");
  std::vector<TrajectoryPoint> points = PointsAt(waypoints, limits);
  if (points.size() < 3) {
    return MoveStraight(points.front().positions, points.back().positions, limits, speed);
  }
  std::vector<double> spans;
  for (std::size_t k = 1; k < points.size(); ++k) {
    spans.push_back(SecondsBetween(points[k - 1], points[k], limits, speed));
  }
  // Each span is made as long as it needs; that changes its neighbours, so again.
  for (int round = 0; round < kMaxRounds; ++round) {
    Arrange(spans, &points);
    bool is_done = true;
    for (std::size_t k = 0; k < spans.size(); ++k) {
      const double needed = SlownessNeeded(points[k], points[k + 1], limits, speed);
      if (needed > 1) {
        spans[k] *= needed;
        is_done = false;
      }
    }
    if (is_done) break;
  }
  Arrange(spans, &points);
  SlowDownToLimits(limits, speed, &points);
  return points;
}

}  // namespace smile::motion
