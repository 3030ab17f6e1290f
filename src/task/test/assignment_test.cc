#include "task/assignment.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>
#include <set>

#include "base/uniform.h"

namespace smile::task {
namespace {

double CostOfChoice(const Eigen::MatrixXd& cost, const std::vector<std::size_t>& columns) {
  double sum = 0;
  for (Eigen::Index row = 0; row < cost.rows(); ++row) {
    sum += cost(row, static_cast<Eigen::Index>(columns[static_cast<std::size_t>(row)]));
  }
  return sum;
}

TEST(CheapestAssignment, IsOptimal) {
  std::mt19937_64 random(3);
  for (int trial = 0; trial < 200; ++trial) {
    const auto rows = static_cast<Eigen::Index>(1 + trial % 5);
    Eigen::MatrixXd cost(rows, 6);
    for (Eigen::Index i = 0; i < cost.size(); ++i) {
      cost(i) = std::floor(Uniform(&random, 0, 10)) * (i % 3 == 0 ? 1e6 : 1);
    }
    std::vector<std::size_t> order(6);
    std::iota(order.begin(), order.end(), 0u);
    double least = 1e12;
    do {
      least = std::min(least, CostOfChoice(cost, order));
    } while (std::next_permutation(order.begin(), order.end()));
    const std::vector<std::size_t> chosen = CheapestAssignment(cost);
    EXPECT_EQ(CostOfChoice(cost, chosen), least);
    EXPECT_EQ(std::set<std::size_t>(chosen.begin(), chosen.end()).size(), chosen.size());
  }
}

}  // namespace
}  // namespace smile::task
