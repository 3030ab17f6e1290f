#include "brain/internal_matrix_reader.h"

#include <algorithm>
#include <span>

#include "base/wording.h"
#include "brain/brain_values.h"

namespace smile::brain {

using wire::ElementType;
using wire::ShapeText;

Eigen::MatrixXd MatrixReader::Read(const NamedArray& array, int rows, int cols,
                                   const NameElement& name_element) {
  const std::string expected =
      (rows < 0 ? std::string("N") : std::to_string(rows)) + "x" + std::to_string(cols);
  const auto zeros = Eigen::MatrixXd::Zero(std::max(rows, 0), cols);
  const auto numbers = array.Numbers();
  if (!numbers) {
    Fail(array.name + " is text, expected a " + expected + " matrix");
    return zeros;
  }
  if (array.dims.size() != 2 || static_cast<int>(array.dims[1]) != cols ||
      (rows >= 0 && static_cast<int>(array.dims[0]) != rows)) {
    Fail(array.name + " is " + ShapeText(array.dims) + ", expected " + expected);
    return zeros;
  }
  return Checked(array, *numbers, name_element).reshaped(array.dims[0], cols);
}

Eigen::MatrixXd MatrixReader::ReadTicks(const NamedArray& array, int rows, int cols,
                                        const NameElement& name_element) {
  const int size = rows * cols;
  // Values of one column need no third dimension: 2xN.
  const std::size_t time = cols == 1 ? 1 : 2;
  const bool has_time = array.type != ElementType::kText && array.dims.size() == time + 1 &&
                        static_cast<int>(array.dims[0]) == rows &&
                        (cols == 1 || static_cast<int>(array.dims[1]) == cols);
  if (!has_time) return Read(array, rows, cols, name_element).reshaped(size, 1);
  if (array.dims[time] < 1 || array.dims[time] > kMaxChunkTicks) {
    Fail(array.name + " is " + ShapeText(array.dims) + ", expected values for 1 to " +
         std::to_string(kMaxChunkTicks) + " ticks");
    return Eigen::MatrixXd::Zero(size, 1);
  }
  return Checked(array, array.Numbers().value(), name_element).reshaped(size, array.dims[time]);
}

int MatrixReader::ReadCount(const NamedArray& array, int max) {
  const double count = Read(array, 1, 1)(0, 0);
  if (count >= 1 && count <= max && count == std::floor(count)) return static_cast<int>(count);
  Fail(array.name + " is " + NumberText(count) + ", expected a whole number from 1 to " +
       std::to_string(max));
  return 1;
}

Eigen::VectorXd MatrixReader::Checked(const NamedArray& array, const std::vector<double>& numbers,
                                      const NameElement& name_element) {
  Eigen::VectorXd columns(static_cast<Eigen::Index>(numbers.size()));
  const auto bytes = std::as_bytes(std::span(numbers));
  const auto to = std::as_writable_bytes(std::span(columns.data(), numbers.size()));
  if (array.is_row_major) {
    // A brain may send either order, whatever was negotiated for pictures. An array by rows is one
    // by columns with its dimensions reversed.
    const std::vector<std::uint32_t> reversed(array.dims.rbegin(), array.dims.rend());
    wire::CopyToRowMajor(reversed, sizeof(double), bytes, to);
  } else {
    std::ranges::copy(bytes, to.begin());
  }
  for (Eigen::Index i = 0; i < columns.size(); ++i) {
    // The comparison is also false for NaN.
    if (std::abs(columns[i]) <= kFarthest) continue;
    Fail(name_element(array, i) + " is " + NumberText(columns[i]) + ", expected " +
         (std::isfinite(columns[i]) ? "at most " + NumberText(kFarthest) : "a finite number"));
    break;
  }
  return columns;
}

// Indices count from 1, as in scripts.
std::string MatrixReader::NameByPlace(const NamedArray& array, Eigen::Index element) {
  std::string text;
  for (const std::uint32_t dim : array.dims) {
    text += (text.empty() ? "(" : ",") + std::to_string(element % dim + 1);
    element /= dim;
  }
  return array.name + text + ")";
}

}  // namespace smile::brain
