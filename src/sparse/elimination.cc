#include "sparse/elimination.h"

#include <algorithm>
#include <iterator>
#include <numeric>
#include <set>
#include <utility>

namespace smile::sparse {
namespace {

void EraseFrom(std::vector<int>* sorted, int value) {
  const auto place = std::lower_bound(sorted->begin(), sorted->end(), value);
  if (place != sorted->end() && *place == value) sorted->erase(place);
}

/// Both must be sorted.
void MergeInto(std::vector<int>* sorted, const std::vector<int>& others) {
  std::vector<int> merged;
  merged.reserve(sorted->size() + others.size());
  std::set_union(sorted->begin(), sorted->end(), others.begin(), others.end(),
                 std::back_inserter(merged));
  *sorted = std::move(merged);
}

/// The nodes that hang together with this one, ascending; marks them.
std::vector<int> IslandOf(const BlockGraph& graph, int first, std::vector<bool>* is_marked) {
  std::vector<int> island = {first};
  (*is_marked)[first] = true;
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

using Order = std::vector<std::pair<int, std::vector<int>>>;  ///< nodes with those they touch

/// Eliminates the nodes of an island one after another.
class Eliminator {
 public:
  /// `graph` becomes what is left of it.
  Eliminator(BlockGraph* graph, const std::vector<int>& island) : graph_(*graph) {
    for (int node : island) PutInQueue(node);
  }

  /// Empty if that is more than the work that is left, of which it takes its part otherwise.
  Order Run(double* work_left) {
    Order order;
    double work = 0;
    while (!queue_.empty()) {
      const auto [rows_touched, node] = *queue_.begin();
      queue_.erase(queue_.begin());
      const double rows = graph_.sizes[node] + rows_touched;
      work += rows * rows * graph_.sizes[node];
      if (work > *work_left) return {};
      order.emplace_back(node, Eliminate(node));
    }
    *work_left -= work;
    return order;
  }

 private:
  std::pair<int, int> KeyOf(int node) const {
    int rows = 0;
    for (int other : graph_.neighbours[node]) rows += graph_.sizes[other];
    return {rows, node};
  }
  void PutInQueue(int node) {
    if (!graph_.waits[node]) queue_.insert(KeyOf(node));
  }

  /// Those it touched now touch each other.
  std::vector<int> Eliminate(int node) {
    std::vector<int> touched = std::move(graph_.neighbours[node]);
    for (int other : touched) queue_.erase(KeyOf(other));
    for (int other : touched) {
      std::vector<int>& theirs = graph_.neighbours[other];
      if (touched.size() > 1) MergeInto(&theirs, touched);
      EraseFrom(&theirs, other);
      EraseFrom(&theirs, node);
      graph_.waits[other] = false;
    }
    for (int other : touched) PutInQueue(other);
    return touched;
  }

  BlockGraph& graph_;
  std::set<std::pair<int, int>> queue_;  ///< rows touched, node
};

/// Tells each step who comes later in it, now that the order is known.
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
