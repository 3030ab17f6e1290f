// Right-looking block factorization: each step factors its diagonal block, solves for the blocks
// below it and subtracts their outer product from the columns of the later nodes. No pivoting is
// needed: the matrices are quasidefinite (R. J. Vanderbei, Symmetric quasidefinite matrices, SIAM
// J. Optim. 1995), and the bounds of Factor() keep pivots away from zero.

#include "sparse/block_matrix.h"

#include <algorithm>

namespace smile::sparse {
namespace {

/// Computes target -= a b^T. All matrices are stored row by row; rows of a and b have `width`
/// entries.
void Subtract(const double* a, int rows_a, const double* b, int rows_b, int width, double* target) {
  for (int i = 0; i < rows_a; ++i, a += width, target += rows_b) {
    for (int j = 0; j < rows_b; ++j) {
      double sum = 0;
      for (int k = 0; k < width; ++k) sum += a[k] * b[j * width + k];
      target[j] -= sum;
    }
  }
}

}  // namespace

void BlockMatrix::Begin(const Elimination* elimination) {
  elimination_ = elimination;
  columns_.clear();
  num_rows_ = 0;
  // Column blocks follow one another in one array, in the order of elimination.
  std::size_t start = 0;
  for (const Step& step : elimination->steps) {
    columns_.push_back({start, num_rows_});
    start += static_cast<std::size_t>(step.num_rows) * step.size;
    num_rows_ += step.size;
  }
  entries_.assign(start, 0.0);
}

double* BlockMatrix::block(int row_place, int place) {
  const Step& step = elimination_->steps[place];
  double* column = &entries_[columns_[place].start];
  if (row_place == place) return column;
  // Blocks below the diagonal are sorted by place.
  const auto later =
      std::lower_bound(step.later.begin(), step.later.end(), row_place,
                       [](const auto& one, int wanted) { return one.place < wanted; });
  return column + later->offset * step.size;
}

double& BlockMatrix::diagonal(int place, int i) {
  return entries_[columns_[place].start + i * (elimination_->steps[place].size + 1)];
}

void BlockMatrix::Factor(const std::vector<double>& least_pivots) {
  for (std::size_t place = 0; place < columns_.size(); ++place) {
    const Step& step = elimination_->steps[place];
    double* column = &entries_[columns_[place].start];
    FactorOwn(step, &least_pivots[columns_[place].first_row], column);
    SolveBelow(step, column);
    UpdateLater(step, column);
  }
}

/// Factors the diagonal block in place: L below its diagonal (unit diagonal not stored), D on it.
void BlockMatrix::FactorOwn(const Step& step, const double* least_pivots, double* column) const {
  const int size = step.size;
  for (int i = 0; i < size; ++i) {
    double* row = column + i * size;
    // Forward substitution with the rows of L that are complete.
    for (int j = 0; j < i; ++j) {
      const double* other = column + j * size;
      for (int k = 0; k < j; ++k) row[j] -= row[k] * other[k];
    }
    // The row now holds L D: divide by D, and subtract L D L^T from the pivot.
    double pivot = row[i];
    for (int k = 0; k < i; ++k) {
      const double scaled = row[k];
      row[k] = scaled / column[k * (size + 1)];
      pivot -= scaled * row[k];
    }
    // Regularize: soften a positive pivot and bound it from below, or bound a negative one from
    // above.
    const double least = least_pivots[i];
    row[i] = least > 0 ? std::max(pivot + least, least) : std::min(pivot, least);
  }
}

/// Turns the blocks below the diagonal into L D; UpdateLater() divides them by D.
void BlockMatrix::SolveBelow(const Step& step, double* column) const {
  const int size = step.size;
  for (int i = size; i < step.num_rows; ++i) {
    double* row = column + i * size;
    for (int j = 1; j < size; ++j) {
      const double* other = column + j * size;
      for (int k = 0; k < j; ++k) row[j] -= row[k] * other[k];
    }
  }
}

/// Subtracts L D L^T of the blocks below the diagonal from the later columns (the Schur
/// complement), and leaves L in this column.
void BlockMatrix::UpdateLater(const Step& step, double* column) {
  const int size = step.size;
  for (std::size_t a = 0; a < step.later.size(); ++a) {
    const Step& target = elimination_->steps[step.later[a].place];
    double* target_column = &entries_[columns_[step.later[a].place].start];
    double* rows_a = column + step.later[a].offset * size;
    scratch_.assign(rows_a, rows_a + target.size * size);  // L D
    // This block becomes L; the blocks below it are still L D, so each product is L D L^T.
    for (int i = 0; i < target.size; ++i) {
      for (int k = 0; k < size; ++k) rows_a[i * size + k] /= column[k * (size + 1)];
    }
    Subtract(scratch_.data(), target.size, rows_a, target.size, size, target_column);
    // Elimination made all later nodes of this step neighbors of each other, so the target column
    // has a block for each of them. Both lists ascend.
    auto there = target.later.begin();
    for (std::size_t b = a + 1; b < step.later.size(); ++b) {
      while (there->place != step.later[b].place) ++there;
      const double* rows_b = column + step.later[b].offset * size;  // L D still
      Subtract(rows_b, elimination_->steps[there->place].size, rows_a, target.size, size,
               target_column + there->offset * target.size);
    }
  }
}

void BlockMatrix::Solve(std::vector<double>* x) const {
  // L (D (L^T solution)) = x: forward through L, then backward through D and L^T.
  for (std::size_t place = 0; place < columns_.size(); ++place) Forward(place, x->data());
  for (std::size_t place = columns_.size(); place-- > 0;) Backward(place, x->data());
}

/// Solves for the rows of one step and subtracts their part from the rows of later steps.
void BlockMatrix::Forward(std::size_t place, double* x) const {
  const Step& step = elimination_->steps[place];
  const double* row = &entries_[columns_[place].start];
  double* own = x + columns_[place].first_row;
  for (int i = 0; i < step.size; ++i, row += step.size) {
    for (int k = 0; k < i; ++k) own[i] -= row[k] * own[k];
  }
  for (const auto& later : step.later) {
    double* theirs = x + columns_[later.place].first_row;
    const int count = elimination_->steps[later.place].size;
    for (int i = 0; i < count; ++i, row += step.size) {
      for (int k = 0; k < step.size; ++k) theirs[i] -= row[k] * own[k];
    }
  }
}

/// Computes the solution of one step from the solutions of all later ones.
void BlockMatrix::Backward(std::size_t place, double* x) const {
  const Step& step = elimination_->steps[place];
  const double* column = &entries_[columns_[place].start];
  double* own = x + columns_[place].first_row;
  for (int i = 0; i < step.size; ++i) own[i] /= column[i * (step.size + 1)];
  for (const auto& later : step.later) {
    const double* theirs = x + columns_[later.place].first_row;
    const double* row = column + later.offset * step.size;
    const int count = elimination_->steps[later.place].size;
    for (int i = 0; i < count; ++i, row += step.size) {
      for (int k = 0; k < step.size; ++k) own[k] -= row[k] * theirs[i];
    }
  }
  for (int i = step.size - 1; i > 0; --i) {
    for (int k = 0; k < i; ++k) own[k] -= column[i * step.size + k] * own[i];
  }
}

}  // namespace smile::sparse
