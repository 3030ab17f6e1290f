#pragma once

#include <cstddef>
#include <vector>

namespace smile::sparse {

/// Sparsity pattern of a symmetric block matrix: a node per block row, an edge per nonzero block
/// off the diagonal.
struct BlockGraph {
  std::vector<int> sizes;                    ///< number of scalar rows of each node
  std::vector<std::vector<int>> neighbours;  ///< of each node, ascending; symmetric
  /// Deferred nodes, by node: such a node has no pivots of its own before its first neighbor is
  /// eliminated. Deferred nodes are not neighbors of each other.
  std::vector<bool> is_deferred;

  bool operator==(const BlockGraph&) const = default;
};

/// Order of elimination with little fill-in, by minimum degree: the next node is always the one
/// whose neighbors have the fewest scalar rows, ties by number. Leaves of a tree come first and
/// nodes with many neighbors last, so the cost of a tree is linear in its size.
struct Elimination {
  struct Later {
    int place;
    int offset;  ///< first of its rows in the column; the node's own rows come first
  };
  struct Step {
    int node;
    int size;                  ///< its own rows
    int num_rows;              ///< own rows and those of the later nodes
    std::vector<Later> later;  ///< neighbors when the node is eliminated, ascending
  };
  std::vector<Step> steps;
  std::vector<int> place_of_node;  ///< step of each node, -1 if left out

  /// Returns the number of scalar entries of all columns.
  std::size_t num_entries() const;
};

/// Orders the nodes of a graph, one island (connected component) after another, by first node. An
/// island that would raise the total number of multiplications above `max_work` is left out as a
/// whole; later islands may still fit.
Elimination OrderElimination(const BlockGraph& graph, double max_work);

}  // namespace smile::sparse
