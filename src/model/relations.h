#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "model/indices.h"
#include "scene/scene_spec.h"

namespace smile::model {

/// What an object stands on, or lies in. The one definition of both, for all that describes scenes
/// and demonstrations.
struct Relation {
  enum class Kind { kOn, kIn };

  std::string object;
  Kind kind = Kind::kOn;
  std::string support;  ///< id of what is beneath or around; empty: the table

  bool operator==(const Relation&) const = default;
};

/// The relations of objects where they are, in their order, as far as their convex pieces tell.
///
/// An object stands on all those whose tops it touches with its feet. It lies in what is around it:
/// in a container, drawer or ring whose pieces are on all four sides of a point a quarter of its
/// height up, in the other's own directions; then that is not also what it stands on. It stands on
/// the table when it stands on nothing else and lies in nothing. A drawer stands on what it slides
/// in, never the other way round.
/// @param scene    theirs; where they are in it does not matter.
/// @param objects  those that are there.
std::vector<Relation> RelationsOf(const scene::SceneSpec& scene,
                                  const std::vector<scene::ObjectSpec>& objects);

/// What an object would come to stand on or lie in if it were released.
struct Support {
  std::string object;      ///< its id; empty: the table
  bool is_inside = false;  ///< it lies in it rather than on it
  double height = 0;       ///< from there up to the object [m]

  /// True when it is as good as there already.
  bool is_near() const { return height < 0.02; }
  bool operator==(const Support&) const = default;
};

/// The support of one of the objects: its relation, as RelationsOf() has it, once it is lowered
/// until it meets what is straight beneath. Of several the innermost that it lies in, else the
/// first that it stands on.
/// @param scene, objects  as RelationsOf() takes them.
/// @returns nullopt beyond the table's edge, or when the object is not there.
std::optional<Support> SupportOf(const scene::SceneSpec& scene,
                                 const std::vector<scene::ObjectSpec>& objects,
                                 const std::string& object);

/// The same of a scene at some moment.
/// @param X_WBs  of the objects of the scene, in its order; nullopt of what is gone.
std::optional<Support> SupportOf(const scene::SceneSpec& scene,
                                 const std::vector<std::optional<RigidTransform>>& X_WBs,
                                 ObjectIndex object);

}  // namespace smile::model
