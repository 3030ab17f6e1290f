#pragma once

#include <Eigen/Core>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "wire/wire.h"

namespace smile::brain {

using wire::Message;
using wire::NamedArray;
using wire::WireError;

/// Limit of all numbers from brains, far beyond any table [units].
inline constexpr double kFarthest = 1e6;

/// Reader of matrices from a brain. Numbers beyond kFarthest are errors, as they could be logged
/// but not read again. `prefix` is the name of the variable in the script, for example `motor.`.
/// The first error is kept.
class MatrixReader {
 public:
  /// Returns the name and place of an element of an array, as a script has it: `jointAngles(2,3)`.
  using NameElement = std::function<std::string(const NamedArray& array, Eigen::Index element)>;

  explicit MatrixReader(std::string prefix) : prefix_(std::move(prefix)) {}

  /// Reads an array of exactly `rows` x `cols`; -1 as `rows` takes any number of them.
  /// On failure the first error is kept and zeros are returned.
  /// @param name_element  of one in column-major order, for messages; default: by rows and columns.
  Eigen::MatrixXd Read(const NamedArray& array, int rows, int cols,
                       const NameElement& name_element = &NameByPlace);

  /// Reads the values of successive ticks, `rows` x `cols` each: an array with time as its last
  /// dimension, of 1 to kMaxChunkTicks. An array of `rows` x `cols` is the value of one tick.
  /// @returns one column of rows * cols numbers per tick; one of zeros on failure.
  Eigen::MatrixXd ReadTicks(const NamedArray& array, int rows, int cols,
                            const NameElement& name_element = &NameByPlace);

  /// Reads a whole number from 1 to `max`; 1 on failure.
  int ReadCount(const NamedArray& array, int max);

  void Fail(const std::string& message) {
    if (error_.message.empty()) error_.message = prefix_ + message;
  }
  bool ok() const { return error_.message.empty(); }
  const WireError& error() const { return error_; }

 private:
  static std::string NameByPlace(const NamedArray& array, Eigen::Index element);
  /// Returns the numbers of an array in column-major order, after a check of each.
  Eigen::VectorXd Checked(const NamedArray& array, const std::vector<double>& numbers,
                          const NameElement& name_element);

  std::string prefix_;
  WireError error_;
};

}  // namespace smile::brain
