#pragma once

#include <cstddef>
#include <vector>

namespace smile::sparse {

/// A symmetric matrix of blocks: which of its block rows (nodes) have entries in common.
struct BlockGraph {
  std::vector<int> sizes;                    ///< of each node: its number of scalar rows
  std::vector<std::vector<int>> neighbours;  ///< of each node, ascending, both ways
  /// Of each node: it has no pivots of its own before the first of its neighbours is eliminated.
  /// Nodes that wait are not neighbours of each other.
  std::vector<bool> waits;

  bool operator==(const BlockGraph&) const = default;
};

/// The order in which to eliminate nodes, so that little fills in: always the one that touches the
/// fewest rows, ties by number. Leaves of a tree come first, and what many hang on comes last: a
/// tree costs a time linear in its size.
struct Elimination {
  struct Later {
    int place;
    int offset;  ///< of its rows in the column, where the node's own rows come first
  };
  struct Step {
    int node;
    int size;                  ///< its own rows
    int num_rows;              ///< with those of the later ones
    std::vector<Later> later;  ///< those it touches when its turn comes, ascending
  };
  std::vector<Step> steps;
  std::vector<int> place_of_node;  ///< -1: left out

  std::size_t num_entries() const;
};

/// Islands, nodes that hang together, are taken by their first node; one that would bring the sum
/// of all multiplications over `max_work` is left out as a whole.
Elimination OrderElimination(const BlockGraph& graph, double max_work);

}  // namespace smile::sparse
