#include "mechanics/link_trees.h"

#include <algorithm>

namespace smile::mechanics {

LinkTrees TreesOf(std::span<const scene::LinkSpec> links) {
  const int count = static_cast<int>(links.size());
  // The link at the base that carries each link; then, of those that are coupled, the first one.
  std::vector<int> root_of(count);
  for (int i = 0; i < count; ++i) {
    const int parent = links[i].parent;
    root_of[i] = parent < 0 ? i : root_of[parent];
  }
  for (int i = 0; i < count; ++i) {
    if (!links[i].mimic) continue;
    const int own = root_of[i], other = root_of[links[i].mimic->leader];
    std::ranges::replace(root_of, std::max(own, other), std::min(own, other));
  }
  LinkTrees trees;
  trees.places.resize(count);
  for (int i = 0; i < count; ++i) {
    const bool is_first = root_of[i] == i;
    if (is_first) trees.sizes.push_back(0);
    const int tree =
        is_first ? static_cast<int>(trees.sizes.size()) - 1 : trees.places[root_of[i]].tree;
    trees.places[i] = {tree, trees.sizes[tree]++};
  }
  return trees;
}

}  // namespace smile::mechanics
