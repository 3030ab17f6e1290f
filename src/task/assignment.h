#pragma once

#include <cstddef>
#include <vector>

#include <Eigen/Core>

namespace smile::task {

/// Returns one column for each row, no column twice, with the least sum of costs. Equal costs give
/// equal results.
///
/// Source: H. W. Kuhn, "The Hungarian Method for the Assignment Problem" (1955), with the shortest
/// augmenting paths of Edmonds and Karp (1972).
///
/// @param cost  finite; at least as many columns as rows.
std::vector<std::size_t> CheapestAssignment(const Eigen::MatrixXd& cost);

}  // namespace smile::task
