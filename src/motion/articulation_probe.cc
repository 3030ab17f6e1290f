#include "motion/articulation_probe.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>
#include <string>

#include "scene/bounds.h"

// Tests poses of a robot for overlaps without a world: motion planning asks this thousands of
// times. Only geometry counts. What is remembered from one query to the next saves time only.

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

}  // namespace

ArticulationProbe::ArticulationProbe(const scene::ArticulationSpec& spec,
                                     const std::vector<scene::Solid>& environment)
    : links_(spec.links), X_WBase_(spec.X_WBase), probe_(SolidsOf(spec, environment)) {
  AddBody(kEnvironment, environment, {});
  AddBody(-1, spec.base_solids, spec.X_WBase);
  for (std::size_t i = 0; i < links_.size(); ++i) {
    AddBody(static_cast<int>(i), links_[i].solids, {});
  }

  // Pairs are found once here, since each query visits all of them.
  // The base may stand on the environment.
  std::set<std::pair<int, int>> never{{kEnvironment, -1}};
  for (const auto& [a, b] : spec.never_collide) never.insert(std::minmax(a, b));
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const bool is_empty = bodies_[i].X_LP.empty() || bodies_[j].X_LP.empty();
      const std::pair<int, int> links{bodies_[j].link, bodies_[i].link};
      if (!is_empty && !never.contains(links)) pairs_.push_back({i, j});
    }
  }
}

void ArticulationProbe::AddBody(int link, const std::vector<scene::Solid>& solids,
                                const RigidTransform& X_WL) {
  const std::size_t first =
      bodies_.empty() ? 0 : bodies_.back().first_piece + bodies_.back().X_LP.size();
  const scene::Bounds bounds = scene::BoundsOf(solids, RigidTransform());
  const Vector3 p_LQ = bounds.center();
  Body body{link, {}, first, p_LQ, bounds.size().norm() / 2, X_WL, X_WL * p_LQ};
  for (const scene::Solid& solid : solids) body.X_LP.push_back(solid.X_BS);
  bodies_.push_back(std::move(body));
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
  for (Body& body : bodies_) {
    if (body.link < 0 || X_WL[body.link] == body.X_WL) continue;
    body.X_WL = X_WL[body.link];
    body.p_WQ = body.X_WL * body.p_LQ;
    ++body.num_moves;
    for (std::size_t i = 0; i < body.X_LP.size(); ++i) {
      probe_.SetPose(body.first_piece + i, body.X_WL * body.X_LP[i]);
    }
  }
}

double ArticulationProbe::DepthOf(Pair& pair, double depth) {
  const Body &body = bodies_[pair.body], &other = bodies_[pair.other];
  // Along a path of one arm, most of the robot stands as it did when it was last tested.
  const std::pair<std::int64_t, std::int64_t> moves{body.num_moves, other.num_moves};
  if (pair.clear_at_moves == moves && pair.clear_depth <= depth) return 0;
  // Most of the others are far apart.
  const double reach = body.radius + other.radius;
  if ((body.p_WQ - other.p_WQ).squaredNorm() <= reach * reach) {
    for (std::size_t i = 0; i < body.X_LP.size(); ++i) {
      for (std::size_t j = 0; j < other.X_LP.size(); ++j) {
        const double overlap = probe_.Depth(body.first_piece + i, other.first_piece + j);
        if (overlap > depth) return overlap;
      }
    }
  }
  pair.clear_at_moves = moves;
  pair.clear_depth = depth;
  return 0;
}

std::optional<LinkOverlap> ArticulationProbe::FirstOverlap(std::span<const double> q,
                                                           double depth) {
  Pose(q);
  // Pairs are in the order of links, so the first overlap found is the first one in that order.
  for (Pair& pair : pairs_) {
    const double overlap = DepthOf(pair, depth);
    if (overlap > 0) return LinkOverlap{bodies_[pair.body].link, bodies_[pair.other].link, overlap};
  }
  return std::nullopt;
}

std::vector<std::pair<int, int>> ArticulationProbe::AllOverlaps(std::span<const double> q,
                                                                double depth) {
  Pose(q);
  std::vector<std::pair<int, int>> found;
  for (Pair& pair : pairs_) {
    if (DepthOf(pair, depth) > 0) {
      found.emplace_back(bodies_[pair.other].link, bodies_[pair.body].link);
    }
  }
  std::ranges::sort(found);
  return found;
}

}  // namespace smile::motion
