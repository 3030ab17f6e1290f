#include "physics/articulation_probe.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>

#include "physics/internal_overlap_probe.h"
#include "physics/internal_shapes.h"

// Tests poses of a robot for overlaps without a world: motion planning asks this thousands of
// times. Only geometry counts; there is no state from one query to the next.

namespace smile::physics {

struct ArticulationProbe::Parts {
  /// A convex solid S, fixed to a link L.
  struct Piece {
    int link;
    CollisionShape shape;
    RigidTransform X_LS;
    btTransform X_WS;
  };
  std::vector<scene::LinkSpec> links;
  RigidTransform X_WBase;
  std::vector<Piece> pieces;
  std::vector<std::pair<std::size_t, std::size_t>> pairs;  ///< indexes of pieces that may collide
  OverlapProbe probe;

  void Add(int link, const RigidTransform& X_WL, const std::vector<scene::Solid>& solids);
};

/// Adds the solids of a link, each as a piece of its own.
void ArticulationProbe::Parts::Add(int link, const RigidTransform& X_WL,
                                   const std::vector<scene::Solid>& solids) {
  // Each shape gets its own pose: parts are tested one pair at a time.
  for (const scene::Solid& solid : solids) {
    scene::Solid centred = solid;
    centred.X_BS = {};
    pieces.push_back(
        {link, MakeCollisionShape({centred}, {}), solid.X_BS, ToBullet(X_WL * solid.X_BS)});
  }
}

ArticulationProbe::ArticulationProbe(const scene::ArticulationSpec& spec,
                                     const std::vector<scene::Solid>& environment)
    : parts_(std::make_unique<Parts>()) {
  parts_->links = spec.links;
  parts_->X_WBase = spec.X_WBase;
  parts_->Add(kEnvironment, {}, environment);
  parts_->Add(-1, spec.X_WBase, spec.base_solids);
  for (std::size_t i = 0; i < spec.links.size(); ++i) {
    parts_->Add(static_cast<int>(i), {}, spec.links[i].solids);
  }

  // Pairs are found once here, since each query visits all of them.
  // The base may stand on the environment.
  std::set<std::pair<int, int>> never{{kEnvironment, -1}};
  for (const auto& [a, b] : spec.never_collide) never.insert(std::minmax(a, b));
  const auto& pieces = parts_->pieces;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const std::pair<int, int> links{pieces[j].link, pieces[i].link};
      if (links.first == links.second || never.contains(links)) continue;
      parts_->pairs.emplace_back(i, j);
    }
  }
}

ArticulationProbe::~ArticulationProbe() = default;
ArticulationProbe::ArticulationProbe(ArticulationProbe&&) noexcept = default;
ArticulationProbe& ArticulationProbe::operator=(ArticulationProbe&&) noexcept = default;

std::optional<LinkOverlap> ArticulationProbe::FirstOverlap(std::span<const double> q,
                                                           double depth) {
  if (q.size() != parts_->links.size()) {
    throw std::invalid_argument("q has " + std::to_string(q.size()) + " values, expected " +
                                std::to_string(parts_->links.size()));
  }
  if (!std::ranges::all_of(q, [](double x) { return std::isfinite(x); })) {
    throw std::invalid_argument("q is not finite");
  }
  const std::vector<RigidTransform> X_WL = scene::LinkPoses(parts_->links, parts_->X_WBase, q);
  for (Parts::Piece& piece : parts_->pieces) {
    if (piece.link >= 0) piece.X_WS = ToBullet(X_WL[piece.link] * piece.X_LS);
  }
  // Pairs are in the order of links, so the first overlap found is the first one in that order.
  for (const auto& [i, j] : parts_->pairs) {
    const Parts::Piece &a = parts_->pieces[i], &b = parts_->pieces[j];
    const double overlap = parts_->probe.Depth(a.shape.shape(), a.X_WS, b.shape.shape(), b.X_WS);
    if (overlap > depth) return LinkOverlap{a.link, b.link, overlap};
  }
  return std::nullopt;
}

}  // namespace smile::physics
