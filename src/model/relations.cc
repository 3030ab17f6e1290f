// "On" and "in" from geometry alone, without contacts of the physics: the same function serves
// scenes, recordings and previews. Pieces are convex: from above they are compared by their
// outlines, in height by their bounding boxes.

#include "model/relations.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "model/outline.h"
#include "scene/bounds.h"

namespace smile::model {
namespace {

/// Greatest distance of surfaces that touch [m].
constexpr double kContact = 0.005;
/// Least overlap, seen from above, of an object with its support [m].
constexpr double kFooting = 0.001;
/// Greatest gap in a wall that is closed: pieces that meet are apart by rounding [m].
constexpr double kSeam = 1e-6;

struct Piece {
  scene::Bounds bounds;  ///< in W
  Outline outline;
};

/// An object with its pieces, prepared for relations.
struct Placed {
  const scene::ObjectSpec* object = nullptr;
  std::vector<scene::Solid> solids;
  std::vector<Piece> pieces;
  scene::Bounds bounds;  ///< in W
};

Placed PlacedOf(const scene::ObjectSpec& object) {
  Placed placed{
      .object = &object, .solids = scene::SolidsOf(object.whole), .pieces = {}, .bounds = {}};
  for (const scene::Solid& solid : placed.solids) {
    const RigidTransform X_WS = object.pose_in_world() * solid.X_BS;
    placed.pieces.push_back({scene::BoundsOf(solid.shape, X_WS), OutlineOf(solid.shape, X_WS)});
    placed.bounds.Add(placed.pieces.back().bounds);
  }
  return placed;
}

/// Returns true if the bottom of a piece of `upper` touches the top of a piece of `lower`, with
/// enough overlap.
bool StandsOn(const Placed& upper, const Placed& lower) {
  // Cheap test first: most pairs are far apart.
  if (!upper.bounds.Meets(lower.bounds, kContact)) return false;
  for (const Piece& foot : upper.pieces) {
    for (const Piece& top : lower.pieces) {
      if (std::abs(foot.bounds.low.z() - top.bounds.high.z()) > kContact) continue;
      if (foot.bounds.Meets(top.bounds, kContact) &&
          OverlapOf(foot.outline, top.outline) > kFooting) {
        return true;
      }
    }
  }
  return false;
}

/// Returns true if pieces of two objects are within a distance [m].
bool AreNear(const Placed& a, const Placed& b, double distance) {
  if (!a.bounds.Meets(b.bounds, distance)) return false;
  for (const Piece& one : a.pieces) {
    for (const Piece& other : b.pieces) {
      // An overlap below 0 is a gap.
      if (one.bounds.Meets(other.bounds, distance) &&
          OverlapOf(one.outline, other.outline) > -distance) {
        return true;
      }
    }
  }
  return false;
}

/// Returns true if a box is beside a point, on this side along this axis, at its height.
bool IsBeside(const scene::Bounds& piece, const Vector3& p, int axis, bool is_above) {
  // The other horizontal axis.
  const int across = 1 - axis;
  const bool is_on_side = is_above ? piece.low[axis] >= p[axis] : piece.high[axis] <= p[axis];
  return is_on_side && piece.low[across] - kSeam <= p[across] &&
         p[across] <= piece.high[across] + kSeam && piece.low.z() <= p.z() &&
         p.z() <= piece.high.z();
}

/// Returns the bounds of an object in the frame of another one, where the walls of a container are
/// along the axes.
scene::Bounds BoundsIn(const Placed& object, const Placed& around) {
  return scene::BoundsOf(object.solids,
                         around.object->pose_in_world().inverse() * object.object->pose_in_world());
}

/// Returns true if pieces of an object are on all four sides of a point in its own frame.
bool HasOnAllSides(const Placed& around, const Vector3& p) {
  std::array<bool, 4> sides{};
  for (const scene::Solid& solid : around.solids) {
    const scene::Bounds piece = scene::BoundsOf(solid.shape, solid.X_BS);
    for (std::size_t side = 0; side < sides.size(); ++side) {
      sides[side] = sides[side] || IsBeside(piece, p, static_cast<int>(side / 2), side % 2 == 1);
    }
  }
  return std::ranges::all_of(sides, [](bool is_closed) { return is_closed; });
}

/// Returns true if pieces of `around` are on all four sides of a point in the lower part of the
/// object.
bool LiesIn(const Placed& object, const Placed& around) {
  if (!object.bounds.Meets(around.bounds)) return false;
  const scene::Bounds inner = BoundsIn(object, around);
  Vector3 p = inner.center();
  // A quarter of the height: an object may stick out of a flat container and is still in it.
  p.z() = inner.low.z() + inner.size().z() / 4;
  return HasOnAllSides(around, p);
}

/// Returns true if an object's lowest point is on the table top and its center above the table.
bool StandsOnTable(const Placed& object, const scene::TableSpec& table) {
  const Vector3 center = object.bounds.center();
  return !object.bounds.is_empty() && std::abs(object.bounds.low.z()) < kContact &&
         std::abs(center.x()) < table.x_span / 2 && std::abs(center.y()) < table.y_span / 2;
}

bool SlidesIn(const scene::SceneSpec& scene, const scene::ObjectSpec& drawer,
              const scene::ObjectSpec& frame) {
  return std::ranges::any_of(scene.sliders, [&](const scene::SliderSpec& slider) {
    return scene.objects[slider.first_object].id() == frame.id() &&
           scene.objects[slider.first_object + 1].id() == drawer.id();
  });
}

/// Returns the relations of one object with all others.
std::vector<Relation> RelationsOfOne(const Placed& one, const std::vector<Placed>& all,
                                     const scene::SceneSpec& scene) {
  std::vector<Relation> relations;
  for (const Placed& other : all) {
    if (one.object->id() == other.object->id() || SlidesIn(scene, *other.object, *one.object)) {
      continue;
    }
    if (LiesIn(one, other)) {
      relations.push_back({one.object->id(), Relation::Kind::kIn, other.object->id()});
    } else if (StandsOn(one, other)) {
      relations.push_back({one.object->id(), Relation::Kind::kOn, other.object->id()});
    }
  }
  if (relations.empty() && StandsOnTable(one, scene.table)) {
    relations.push_back({one.object->id(), Relation::Kind::kOn, ""});
  }
  return relations;
}

/// Returns the distance that an object can be lowered until it meets the table or another object's
/// top [m]; overlap up to kContact counts as contact.
double HeightAbove(const Placed& one, const std::vector<Placed>& all,
                   const scene::SceneSpec& scene) {
  // The table top is at z = 0.
  double height = std::max(0.0, one.bounds.low.z());
  for (const Placed& other : all) {
    if (one.object->id() == other.object->id() || SlidesIn(scene, *other.object, *one.object)) {
      continue;
    }
    for (const Piece& foot : one.pieces) {
      for (const Piece& top : other.pieces) {
        const double gap = foot.bounds.low.z() - top.bounds.high.z();
        // Tops that are beside or above the object do not count, nor those below the highest one
        // found.
        if (gap < -kContact || gap >= height) continue;
        if (OverlapOf(foot.outline, top.outline) > kFooting) height = std::max(0.0, gap);
      }
    }
  }
  return height;
}

/// Returns the most informative relation: the innermost container, else the first.
const Relation& MainOf(const std::vector<Relation>& relations, const std::vector<Placed>& all) {
  const auto size_around = [&all](const Relation& relation) {
    const auto around = std::ranges::find(all, relation.support,
                                          [](const Placed& placed) { return placed.object->id(); });
    const bool is_inside = relation.kind == Relation::Kind::kIn && around != all.end();
    return is_inside ? around->bounds.size().prod() : std::numeric_limits<double>::infinity();
  };
  // The innermost container is the smallest one.
  return *std::ranges::min_element(relations, {}, size_around);
}

}  // namespace

std::vector<Relation> RelationsOf(const scene::SceneSpec& scene,
                                  const std::vector<scene::ObjectSpec>& objects) {
  std::vector<Placed> all;
  for (const scene::ObjectSpec& object : objects) all.push_back(PlacedOf(object));
  std::vector<Relation> relations;
  for (const Placed& one : all) {
    for (Relation& relation : RelationsOfOne(one, all, scene)) {
      relations.push_back(std::move(relation));
    }
  }
  return relations;
}

bool IsAround(const scene::ObjectSpec& outer, const scene::ObjectSpec& inner) {
  const Placed ring = PlacedOf(outer), post = PlacedOf(inner);
  if (!ring.bounds.Meets(post.bounds)) return false;
  const scene::Bounds within = BoundsIn(post, ring);
  Vector3 p = within.center();
  p.z() = BoundsIn(ring, ring).center().z();
  return within.low.z() <= p.z() && p.z() <= within.high.z() && HasOnAllSides(ring, p);
}

std::vector<std::pair<std::size_t, std::size_t>> NearPairsOf(
    const std::vector<scene::ObjectSpec>& objects, double distance) {
  std::vector<Placed> all;
  for (const scene::ObjectSpec& object : objects) all.push_back(PlacedOf(object));
  std::vector<std::pair<std::size_t, std::size_t>> pairs;
  for (std::size_t i = 0; i < all.size(); ++i) {
    for (std::size_t k = i + 1; k < all.size(); ++k) {
      if (AreNear(all[i], all[k], distance)) pairs.emplace_back(i, k);
    }
  }
  return pairs;
}

std::optional<Support> SupportOf(const scene::SceneSpec& scene,
                                 const std::vector<scene::ObjectSpec>& objects,
                                 const std::string& object) {
  const auto found = std::ranges::find(objects, object, &scene::ObjectSpec::id);
  if (found == objects.end()) return std::nullopt;
  std::vector<Placed> all;
  for (const scene::ObjectSpec& other : objects) all.push_back(PlacedOf(other));
  const double height =
      HeightAbove(all[static_cast<std::size_t>(found - objects.begin())], all, scene);
  scene::ObjectSpec lowered = *found;
  // Lowered virtually, then judged by the same rules as objects at rest.
  lowered.whole.X_PE = RigidTransform(Vector3(0, 0, -height)) * found->pose_in_world();
  const std::vector<Relation> relations = RelationsOfOne(PlacedOf(lowered), all, scene);
  if (relations.empty()) return std::nullopt;
  const Relation& main = MainOf(relations, all);
  return Support{
      .object = main.support, .is_inside = main.kind == Relation::Kind::kIn, .height = height};
}

std::optional<Support> SupportOf(const scene::SceneSpec& scene,
                                 const std::vector<std::optional<RigidTransform>>& X_WBs,
                                 ObjectIndex object) {
  if (object >= X_WBs.size()) return std::nullopt;
  std::vector<scene::ObjectSpec> objects;
  for (std::size_t i = 0; i < X_WBs.size(); ++i) {
    if (!X_WBs[i]) continue;
    objects.push_back(scene.objects[i]);
    objects.back().whole.X_PE = *X_WBs[i];
  }
  return SupportOf(scene, objects, scene.objects[object].id());
}

}  // namespace smile::model
