#pragma once

#include <string>
#include <vector>

#include "scene/scene_spec.h"

namespace smile::task {

/// What an object stands on, or lies in.
struct Relation {
  enum class Kind { kOn, kIn };

  std::string object;
  Kind kind = Kind::kOn;
  std::string support;  ///< id of what is beneath or around; empty: the table

  bool operator==(const Relation&) const = default;
};

/// Of objects where they are, in their order, as far as their convex pieces tell.
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

}  // namespace smile::task
