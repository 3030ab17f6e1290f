#pragma once

#include <vector>

#include "sparse/elimination.h"

namespace smile::sparse {

/// A symmetric matrix of blocks and its factors L D L^T: one column of blocks for each step of an
/// elimination, of which it keeps what lies on and below the diagonal.
class BlockMatrix {
 public:
  /// All zeros. The elimination must outlive the matrix.
  void Begin(const Elimination* elimination);

  /// The block of the node at `row_place` against the one at `place`, which must not come later;
  /// row by row, rows are as long as the earlier one's size.
  double* block(int row_place, int place);
  double& diagonal(int place, int i);

  /// @param least_pivots  row by row in the order of elimination: positive where the pivot shall be
  ///                      this much larger than it is and at least this, negative where it must be
  ///                      no larger than this.
  void Factor(const std::vector<double>& least_pivots);
  /// Once factored: x becomes the solution of (matrix) (solution) = x; rows in the order of
  /// elimination.
  void Solve(std::vector<double>* x) const;

  /// The first row of a place.
  int first_row(int place) const { return columns_[place].first_row; }
  int num_rows() const { return num_rows_; }

 private:
  using Step = Elimination::Step;
  struct Column {
    std::size_t start;  ///< of its entries, row by row
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
