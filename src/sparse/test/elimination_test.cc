#include "sparse/elimination.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <random>

#include "sparse/block_matrix.h"

namespace smile::sparse {
namespace {

constexpr double kEnough = 1e9;

BlockGraph Graph(int count, const std::vector<std::pair<int, int>>& ties) {
  BlockGraph graph{.sizes = std::vector<int>(count, 6),
                   .neighbours = std::vector<std::vector<int>>(count),
                   .is_deferred = std::vector<bool>(count, false)};
  for (const auto& [a, b] : ties) {
    graph.neighbours[a].push_back(b);
    graph.neighbours[b].push_back(a);
  }
  for (auto& neighbours : graph.neighbours) std::sort(neighbours.begin(), neighbours.end());
  return graph;
}

BlockGraph Complete(int count) {
  std::vector<std::pair<int, int>> ties;
  for (int i = 0; i < count; ++i) {
    for (int k = 0; k < i; ++k) ties.emplace_back(k, i);
  }
  return Graph(count, ties);
}

TEST(Elimination, EliminatesASupernodeLastWithoutFillIn) {
  std::vector<std::pair<int, int>> ties;
  for (int i = 1; i < 500; ++i) ties.emplace_back(0, i);
  const Elimination elimination = OrderElimination(Graph(500, ties), kEnough);
  EXPECT_GE(elimination.place_of_node[0], 498);
  EXPECT_EQ(elimination.num_entries(), 500u * 36 + 499u * 36);
}

TEST(Elimination, GrowsLinearlyWithARing) {
  const auto entries = [](int count) {
    std::vector<std::pair<int, int>> ties = {{0, count - 1}};
    for (int i = 0; i + 1 < count; ++i) ties.emplace_back(i, i + 1);
    return OrderElimination(Graph(count, ties), kEnough).num_entries();
  };
  EXPECT_EQ(entries(1000) - entries(500), 500u * 36 * 3);
}

TEST(Elimination, SkipsAnIslandThatIsTooExpensiveAndKeepsTheOthers) {
  BlockGraph graph = Complete(40);
  graph.sizes.resize(43, 6);
  graph.is_deferred.resize(43, false);
  graph.neighbours.push_back({41});
  graph.neighbours.push_back({40, 42});
  graph.neighbours.push_back({41});
  const Elimination elimination = OrderElimination(graph, 1e5);
  EXPECT_EQ(elimination.steps.size(), 3u);
  for (int node = 0; node < 40; ++node) EXPECT_EQ(elimination.place_of_node[node], -1);
  for (int node = 40; node < 43; ++node) EXPECT_GE(elimination.place_of_node[node], 0);
}

TEST(Elimination, EliminatesDeferredNodesLast) {
  BlockGraph graph = Graph(3, {{0, 1}, {0, 2}, {1, 2}});
  graph.sizes = {1, 6, 6};
  graph.is_deferred[1] = graph.is_deferred[2] = true;
  EXPECT_EQ(OrderElimination(graph, kEnough).steps.front().node, 0);
}

TEST(BlockMatrix, SolvesWhatItFactored) {
  // Blocks of different sizes, positive and (the last two) negative pivots.
  BlockGraph graph = Graph(7, {{0, 5}, {1, 5}, {2, 5}, {2, 6}, {3, 6}, {4, 6}, {3, 4}, {0, 1}});
  graph.sizes = {3, 6, 7, 2, 5, 6, 6};
  const Elimination elimination = OrderElimination(graph, kEnough);
  BlockMatrix matrix;
  matrix.Begin(&elimination);
  const int count = matrix.num_rows();
  Eigen::MatrixXd dense = Eigen::MatrixXd::Zero(count, count);
  std::vector<double> least(count);
  std::mt19937 random(1);
  const auto uniform = [&random] { return random() / 4294967296.0 - 0.5; };
  for (std::size_t place = 0; place < elimination.steps.size(); ++place) {
    const auto& step = elimination.steps[place];
    const int first = matrix.first_row(static_cast<int>(place));
    for (int i = 0; i < step.size; ++i) {
      const double sign = step.node < 5 ? 1 : -1;
      least[first + i] = sign * 1e-9;
      dense(first + i, first + i) = matrix.diagonal(static_cast<int>(place), i) = sign * 3;
    }
    for (int other : graph.neighbours[step.node]) {
      const int other_place = elimination.place_of_node[other];
      if (other_place < static_cast<int>(place)) continue;
      double* entry = matrix.block(other_place, static_cast<int>(place));
      for (int i = 0; i < graph.sizes[other]; ++i) {
        for (int k = 0; k < step.size; ++k) {
          const int row = matrix.first_row(other_place) + i;
          dense(row, first + k) = dense(first + k, row) = *entry++ = uniform();
        }
      }
    }
  }
  Eigen::VectorXd b(count);
  for (double& value : b) value = uniform();
  std::vector<double> x(b.begin(), b.end());
  matrix.Factor(least);
  matrix.Solve(&x);
  EXPECT_LT((dense * Eigen::Map<Eigen::VectorXd>(x.data(), count) - b).norm(), 1e-7);
}

}  // namespace
}  // namespace smile::sparse
