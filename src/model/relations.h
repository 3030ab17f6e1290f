#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "model/indices.h"
#include "scene/scene_spec.h"

namespace smile::model {

/// Support relation of an object. The one definition for all descriptions of scenes and
/// demonstrations.
struct Relation {
  enum class Kind { kOn, kIn };

  std::string object;
  Kind kind = Kind::kOn;
  std::string support;  ///< id of the object beneath or around it; empty: the table

  bool operator==(const Relation&) const = default;
};

/// Returns the relations of objects at their present poses, in their order, based on their convex
/// pieces.
///
/// An object stands on all objects whose tops it touches with its feet. It lies in an object around
/// it: in a container, drawer or ring whose pieces are on all four sides of a point at a quarter of
/// its height, in the container's own directions; it then does not also stand on that object. It
/// stands on the table if it stands on nothing else and lies in nothing. A drawer stands on the
/// object it slides in, never the reverse.
/// @param scene    the scene of the objects; their poses in it do not matter.
/// @param objects  the objects that are present.
std::vector<Relation> RelationsOf(const scene::SceneSpec& scene,
                                  const std::vector<scene::ObjectSpec>& objects);

/// Returns true if an object's pieces are on all four sides of another one, in the middle of the
/// first one's height: a ring around a post, however high the post is.
bool IsAround(const scene::ObjectSpec& outer, const scene::ObjectSpec& inner);

/// Returns the pairs of objects whose surfaces are within a distance of each other [m], as indices,
/// the lower one first; in ascending order. Distances are those of bounding boxes in height, and of
/// outlines from above.
std::vector<std::pair<std::size_t, std::size_t>> NearPairsOf(
    const std::vector<scene::ObjectSpec>& objects, double distance);

/// Support of an object if it were released.
struct Support {
  std::string object;      ///< id of the support; empty: the table
  bool is_inside = false;  ///< true if it lies in the support rather than on it
  double height = 0;       ///< from the support up to the object [m]

  /// Returns true if it practically rests there already.
  bool is_near() const { return height < 0.02; }
  bool operator==(const Support&) const = default;
};

/// Returns the support of one of the objects: its relation, as in RelationsOf(), after it is
/// lowered until it meets what is straight beneath. Of several, the innermost container, else the
/// first one that it stands on.
/// @param scene, objects  as in RelationsOf().
/// @returns nullopt beyond the table's edge, or if the object is not present.
std::optional<Support> SupportOf(const scene::SceneSpec& scene,
                                 const std::vector<scene::ObjectSpec>& objects,
                                 const std::string& object);

/// The same for a scene at a moment.
/// @param X_WBs  of the objects of the scene, in its order; nullopt for missing ones.
std::optional<Support> SupportOf(const scene::SceneSpec& scene,
                                 const std::vector<std::optional<RigidTransform>>& X_WBs,
                                 ObjectIndex object);

}  // namespace smile::model
