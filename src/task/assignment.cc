#include "task/assignment.h"

#include <limits>

#include "base/demand.h"

namespace smile::task {
namespace {

constexpr Eigen::Index kNone = -1;

/// Assigns one row after another by a shortest augmenting path, found with Dijkstra's algorithm on
/// reduced costs (cost minus the prices, that is the dual variables, of row and column). Invariant
/// between two calls of Assign(): no reduced cost is negative, and those of assigned pairs are 0.
/// So the assignment of the rows so far is optimal. O(rows^2 columns) in total.
class Assigner {
 public:
  explicit Assigner(const Eigen::MatrixXd& cost)
      : cost_(cost),
        row_of_(static_cast<std::size_t>(cost.cols()), kNone),
        price_of_row_(Eigen::VectorXd::Zero(cost.rows())),
        price_of_column_(Eigen::VectorXd::Zero(cost.cols())) {}

  /// Adds a row to the assignment; rows assigned before may move to other columns.
  void Assign(Eigen::Index row) {
    // Dijkstra's algorithm over columns: the length of the shortest path from `row` to each column,
    // and the column before it on that path. A path enters a column from a row and leaves it for
    // the row assigned there.
    const Eigen::Index columns = cost_.cols();
    std::vector<bool> is_done(static_cast<std::size_t>(columns), false);
    Eigen::VectorXd distance =
        Eigen::VectorXd::Constant(columns, std::numeric_limits<double>::infinity());
    std::vector<Eigen::Index> before(static_cast<std::size_t>(columns), kNone);
    Eigen::Index from = kNone, at_row = row;
    double length = 0;
    do {
      // Relaxes the edges from the row reached last, and selects the nearest column that is not
      // done. The first of several equally near ones wins, which makes the result deterministic.
      Eigen::Index next = kNone;
      for (Eigen::Index column = 0; column < columns; ++column) {
        if (is_done[static_cast<std::size_t>(column)]) continue;
        const double through =
            length + cost_(at_row, column) - price_of_row_(at_row) - price_of_column_(column);
        if (through < distance(column)) {
          distance(column) = through;
          before[static_cast<std::size_t>(column)] = from;
        }
        if (next == kNone || distance(column) < distance(next)) next = column;
      }
      is_done[static_cast<std::size_t>(next)] = true;
      length = distance(next);
      from = next;
      at_row = row_of_[static_cast<std::size_t>(next)];
    } while (at_row != kNone);
    // The path ends at a free column. Prices change before the assignment does, since they refer to
    // the rows that are assigned now.
    Reprice(row, is_done, distance, length);
    Swap(row, from, before);
  }

  std::vector<std::size_t> columns() const {
    std::vector<std::size_t> columns(static_cast<std::size_t>(cost_.rows()));
    for (std::size_t column = 0; column < row_of_.size(); ++column) {
      if (row_of_[column] != kNone) columns[static_cast<std::size_t>(row_of_[column])] = column;
    }
    return columns;
  }

 private:
  /// Updates the prices along the search tree so that the invariant holds: all edges of the
  /// shortest path get reduced cost 0, and no reduced cost becomes negative.
  void Reprice(Eigen::Index row, const std::vector<bool>& is_done, const Eigen::VectorXd& distance,
               double length) {
    price_of_row_(row) += length;
    for (std::size_t column = 0; column < row_of_.size(); ++column) {
      const auto index = static_cast<Eigen::Index>(column);
      if (!is_done[column] || distance(index) >= length) continue;
      price_of_row_(row_of_[column]) += length - distance(index);
      price_of_column_(index) -= length - distance(index);
    }
  }

  /// Augments along the path, from its free column back to `row`: each column takes over the row of
  /// the column before it.
  void Swap(Eigen::Index row, Eigen::Index column, const std::vector<Eigen::Index>& before) {
    while (column != kNone) {
      const Eigen::Index previous = before[static_cast<std::size_t>(column)];
      row_of_[static_cast<std::size_t>(column)] =
          previous == kNone ? row : row_of_[static_cast<std::size_t>(previous)];
      column = previous;
    }
  }

  const Eigen::MatrixXd& cost_;
  std::vector<Eigen::Index> row_of_;  ///< of each column
  Eigen::VectorXd price_of_row_, price_of_column_;
};

}  // namespace

std::vector<std::size_t> CheapestAssignment(const Eigen::MatrixXd& cost) {
  SMILE_DEMAND(cost.rows() <= cost.cols());
  Assigner assigner(cost);
  for (Eigen::Index row = 0; row < cost.rows(); ++row) assigner.Assign(row);
  return assigner.columns();
}

}  // namespace smile::task
