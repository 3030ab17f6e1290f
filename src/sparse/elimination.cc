// Minimum degree ordering on an explicit elimination graph (A. George, J. W. H. Liu, The evolution
// of the minimum degree ordering algorithm, SIAM Review 1989), with scalar rows as weights.
// Eliminating a node connects its neighbors with each other; those edges are the fill-in.

#include "sparse/elimination.h"

#include <algorithm>
#include <iterator>
#include <numeric>
#include <set>
#include <utility>

namespace smile::sparse {
namespace {

/// Removes a value from a sorted list if it is there.
void EraseFrom(std::vector<int>* sorted, int value) {
  const auto place = std::lower_bound(sorted->begin(), sorted->end(), value);
  if (place != sorted->end() && *place == value) sorted->erase(place);
}

/// Merges one sorted list into another, without duplicates.
void MergeInto(std::vector<int>* sorted, const std::vector<int>& others) {
  std::vector<int> merged;
  merged.reserve(sorted->size() + others.size());
  std::set_union(sorted->begin(), sorted->end(), others.begin(), others.end(),
                 std::back_inserter(merged));
  *sorted = std::move(merged);
}

/// Returns the connected component of a node, ascending, and marks its members.
std::vector<int> IslandOf(const BlockGraph& graph, int first, std::vector<bool>* is_marked) {
  std::vector<int> island = {first};
  (*is_marked)[first] = true;
  // Breadth-first search; the list of results is also the queue.
  for (std::size_t i = 0; i < island.size(); ++i) {
    for (int next : graph.neighbours[island[i]]) {
      if ((*is_marked)[next]) continue;
      (*is_marked)[next] = true;
      island.push_back(next);
    }
  }
  std::sort(island.begin(), island.end());
  return island;
}

using Order =
    std::vector<std::pair<int, std::vector<int>>>;  ///< Nodes in the order of elimination, each
                                                    ///< with its neighbors at that time.

/// Eliminates the nodes of an island one after another.
class Eliminator {
 public:
  /// `graph` is reduced as nodes are eliminated.
  Eliminator(BlockGraph* graph, const std::vector<int>& island) : graph_(*graph) {
    for (int node : island) PutInQueue(node);
  }

  /// Returns the order, or nothing if it takes more than `work_left` multiplications; otherwise
  /// subtracts its work from `work_left`.
  Order Run(double* work_left) {
    Order order;
    double work = 0;
    while (!queue_.empty()) {
      const auto [rows_touched, node] = *queue_.begin();
      queue_.erase(queue_.begin());
      const double rows = graph_.sizes[node] + rows_touched;
      // The update of later columns dominates: an outer product of all rows, once per own row.
      work += rows * rows * graph_.sizes[node];
      if (work > *work_left) return {};
      order.emplace_back(node, Eliminate(node));
    }
    *work_left -= work;
    return order;
  }

 private:
  /// Returns the priority of a node: the rows of its neighbors, then its number to break ties.
  std::pair<int, int> KeyOf(int node) const {
    int rows = 0;
    for (int other : graph_.neighbours[node]) rows += graph_.sizes[other];
    return {rows, node};
  }
  void PutInQueue(int node) {
    if (!graph_.is_deferred[node]) queue_.insert(KeyOf(node));
  }

  /// Removes a node and returns its neighbors, which become neighbors of each other.
  std::vector<int> Eliminate(int node) {
    std::vector<int> touched = std::move(graph_.neighbours[node]);
    // Priorities change with the neighbors: take the old ones out of the queue first.
    for (int other : touched) queue_.erase(KeyOf(other));
    for (int other : touched) {
      std::vector<int>& theirs = graph_.neighbours[other];
      if (touched.size() > 1) MergeInto(&theirs, touched);
      EraseFrom(&theirs, other);
      EraseFrom(&theirs, node);
      // The Schur complement of the eliminated node makes this one's diagonal block nonsingular.
      graph_.is_deferred[other] = false;
    }
    for (int other : touched) PutInQueue(other);
    return touched;
  }

  BlockGraph& graph_;
  std::set<std::pair<int, int>> queue_;  ///< rows touched, node
};

/// Fills in each step's later nodes with their offsets, once the order is known.
void FillSteps(const BlockGraph& graph, const Order& order, Elimination* elimination) {
  for (const auto& [node, touched] : order) {
    Elimination::Step step{.node = node, .size = graph.sizes[node]};
    for (int other : touched) step.later.push_back({elimination->place_of_node[other], 0});
    std::sort(step.later.begin(), step.later.end(),
              [](const auto& a, const auto& b) { return a.place < b.place; });
    step.num_rows = step.size;
    for (auto& later : step.later) {
      later.offset = step.num_rows;
      step.num_rows += graph.sizes[order[later.place].first];
    }
    elimination->steps.push_back(std::move(step));
  }
}

}  // namespace

std::size_t Elimination::num_entries() const {
  return std::accumulate(steps.begin(), steps.end(), std::size_t{0},
                         [](std::size_t sum, const Step& step) {
                           return sum + static_cast<std::size_t>(step.num_rows) * step.size;
                         });
}

Elimination OrderElimination(const BlockGraph& graph, double max_work) {
  // A copy, since the eliminator consumes its graph.
  BlockGraph rest = graph;
  Order order;
  std::vector<bool> is_marked(graph.sizes.size(), false);
  for (int node = 0; node < static_cast<int>(graph.sizes.size()); ++node) {
    if (is_marked[node]) continue;
    const std::vector<int> island = IslandOf(graph, node, &is_marked);
    Order more = Eliminator(&rest, island).Run(&max_work);
    std::move(more.begin(), more.end(), std::back_inserter(order));
  }
  Elimination elimination;
  elimination.place_of_node.assign(graph.sizes.size(), -1);
  for (std::size_t place = 0; place < order.size(); ++place) {
    elimination.place_of_node[order[place].first] = static_cast<int>(place);
  }
  FillSteps(graph, order, &elimination);
  return elimination;
}

}  // namespace smile::sparse
