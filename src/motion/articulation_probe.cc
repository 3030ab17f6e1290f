#include "motion/articulation_probe.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>
#include <string>

#include "scene/bounds.h"

// Tests poses of a robot for overlaps without a world: motion planning asks this thousands of
// times. Only geometry counts; there is no state from one query to the next.

namespace smile::motion {
namespace {

/// Returns the solids of the environment, the base and the links, in this order.
std::vector<scene::Solid> SolidsOf(const scene::ArticulationSpec& spec,
                                   const std::vector<scene::Solid>& environment) {
  std::vector<scene::Solid> all = environment;
  for (const scene::Solid& solid : spec.base_solids) {
    all.push_back(solid);
    all.back().X_BS = spec.X_WBase * solid.X_BS;
  }
  // Links get their poses with each query.
  for (const scene::LinkSpec& link : spec.links) {
    all.insert(all.end(), link.solids.begin(), link.solids.end());
  }
  return all;
}

/// Ball around a piece, in the world.
struct Ball {
  Vector3 p_WQ = Vector3::Zero();
  double radius = HUGE_VAL;
};

/// Returns balls around the pieces of the links, which are the last ones; those of the environment
/// and the base have no bound.
std::vector<Ball> BallsAround(std::span<const scene::LinkSpec> links,
                              std::span<const RigidTransform> X_WL, std::size_t num_pieces) {
  std::vector<Ball> balls;
  for (std::size_t i = 0; i < links.size(); ++i) {
    for (const scene::Solid& solid : links[i].solids) {
      const scene::Bounds bounds = scene::BoundsOf(solid.shape, RigidTransform());
      balls.push_back({X_WL[i] * (solid.X_BS * bounds.center()), bounds.size().norm() / 2});
    }
  }
  balls.insert(balls.begin(), num_pieces - balls.size(), Ball());
  return balls;
}

}  // namespace

ArticulationProbe::ArticulationProbe(const scene::ArticulationSpec& spec,
                                     const std::vector<scene::Solid>& environment)
    : links_(spec.links), X_WBase_(spec.X_WBase), probe_(SolidsOf(spec, environment)) {
  const auto add_pieces = [this](int link, const std::vector<scene::Solid>& solids) {
    for (const scene::Solid& solid : solids) pieces_.push_back({link, solid.X_BS});
  };
  add_pieces(kEnvironment, environment);
  add_pieces(-1, spec.base_solids);
  for (std::size_t i = 0; i < links_.size(); ++i) {
    add_pieces(static_cast<int>(i), links_[i].solids);
  }

  // Pairs are found once here, since each query visits all of them.
  // The base may stand on the environment.
  std::set<std::pair<int, int>> never{{kEnvironment, -1}};
  for (const auto& [a, b] : spec.never_collide) never.insert(std::minmax(a, b));
  for (std::size_t i = 0; i < pieces_.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const std::pair<int, int> links{pieces_[j].link, pieces_[i].link};
      if (links.first == links.second || never.contains(links)) continue;
      pairs_.emplace_back(i, j);
    }
  }
}

void ArticulationProbe::Pose(std::span<const double> q) {
  if (q.size() != links_.size()) {
    throw std::invalid_argument("q has " + std::to_string(q.size()) + " values, expected " +
                                std::to_string(links_.size()));
  }
  if (!std::ranges::all_of(q, [](double x) { return std::isfinite(x); })) {
    throw std::invalid_argument("q is not finite");
  }
  const std::vector<RigidTransform> X_WL = scene::LinkPoses(links_, X_WBase_, q);
  for (std::size_t i = 0; i < pieces_.size(); ++i) {
    const Piece& piece = pieces_[i];
    if (piece.link >= 0) probe_.SetPose(i, X_WL[piece.link] * piece.X_LS);
  }
}

std::optional<LinkOverlap> ArticulationProbe::FirstOverlap(std::span<const double> q,
                                                           double depth) {
  Pose(q);
  // Pairs are in the order of links, so the first overlap found is the first one in that order.
  for (const auto& [i, j] : pairs_) {
    const double overlap = probe_.Depth(i, j);
    if (overlap > depth) return LinkOverlap{pieces_[i].link, pieces_[j].link, overlap};
  }
  return std::nullopt;
}

std::vector<std::pair<int, int>> ArticulationProbe::AllOverlaps(std::span<const double> q,
                                                                double depth) {
  Pose(q);
  const std::vector<RigidTransform> X_WL = scene::LinkPoses(links_, X_WBase_, q);
  const std::vector<Ball> balls = BallsAround(links_, X_WL, pieces_.size());
  std::set<std::pair<int, int>> found;
  for (const auto& [i, j] : pairs_) {
    const std::pair<int, int> links = std::minmax(pieces_[i].link, pieces_[j].link);
    // Most pairs are far apart, or have been found by other pieces.
    const bool is_near = (balls[i].p_WQ - balls[j].p_WQ).norm() < balls[i].radius + balls[j].radius;
    if (!is_near || found.contains(links)) continue;
    if (probe_.Depth(i, j) > depth) found.insert(links);
  }
  return {found.begin(), found.end()};
}

}  // namespace smile::motion
