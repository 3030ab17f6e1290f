#pragma once

#include <span>
#include <vector>

#include "scene/articulation_spec.h"

namespace smile::mechanics {

/// Partition of the links of an articulation into trees that have no effect on each other: each
/// link at the base with all that it carries. Trees that a coupling connects are one.
struct LinkTrees {
  struct Place {
    int tree = 0;
    int index = 0;  ///< in the tree, parents before children
  };
  std::vector<Place> places;  ///< one per link
  std::vector<int> sizes;     ///< number of links of each tree, in the order of their first links
};
LinkTrees TreesOf(std::span<const scene::LinkSpec> links);

}  // namespace smile::mechanics
