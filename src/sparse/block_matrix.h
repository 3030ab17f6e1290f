#pragma once

#include <vector>

#include "sparse/elimination.h"

namespace smile::sparse {

/// Symmetric block matrix and its factors L D L^T. It has one column of blocks per step of an
/// elimination and stores only the blocks on and below the diagonal.
class BlockMatrix {
 public:
  /// Sets all entries to zero. The elimination must outlive the matrix.
  void Begin(const Elimination* elimination);

  /// Returns the block in the row of the node at `row_place` and the column of the node at `place`,
  /// which must not come later. It is stored row by row; each row is as long as the size of the
  /// node at `place`.
  double* block(int row_place, int place);
  /// Returns the i-th diagonal entry of the block on the diagonal at `place`.
  double& diagonal(int place, int i);

  /// Replaces the matrix by its factors L D L^T.
  /// @param least_pivots  one per row, in the order of elimination. A positive value is added to
  /// the
  ///                      pivot, which is then at least this value; a negative one is an upper
  ///                      bound of the pivot.
  void Factor(const std::vector<double>& least_pivots);
  /// Solves (matrix) (solution) = x after Factor() and stores the solution in x; rows are in the
  /// order of elimination.
  void Solve(std::vector<double>* x) const;

  /// Returns the first scalar row of the node at a place.
  int first_row(int place) const { return columns_[place].first_row; }
  int num_rows() const { return num_rows_; }

 private:
  using Step = Elimination::Step;
  struct Column {
    std::size_t start;  ///< index of its first entry; entries are stored row by row
    int first_row;
  };

  void FactorOwn(const Step& step, const double* least_pivots, double* column) const;
  void SolveBelow(const Step& step, double* column) const;
  void UpdateLater(const Step& step, double* column);
  void Forward(std::size_t place, double* x) const;
  void Backward(std::size_t place, double* x) const;

  const Elimination* elimination_ = nullptr;
  std::vector<Column> columns_;
  std::vector<double> entries_;
  std::vector<double> scratch_;
  int num_rows_ = 0;
};

}  // namespace smile::sparse
