#pragma once

#include <Eigen/Core>
#include <string>
#include <string_view>
#include <vector>

#include "image/image.h"
#include "wire/wire.h"

namespace smile::brain_client {

/// Fields of a message from the simulator: arrays with the names, shapes and units of
/// docs/brains.md, the same for all languages. Includes fields that a newer simulator adds.
///
/// Reading a field that is missing, or of another kind, throws std::invalid_argument that names
/// what is available.
class Fields {
 public:
  Fields() = default;
  explicit Fields(wire::Message message) : message_(std::move(message)) {}

  bool Has(std::string_view name) const { return message_.Find(name) != nullptr; }
  double Number(std::string_view name) const;
  Eigen::MatrixXd Matrix(std::string_view name) const;
  std::string Text(std::string_view name) const;
  /// Returns the numbers of an array of doubles of this size, in its own order; without a copy of
  /// its shape, for arrays that each step has.
  std::vector<double> Doubles(std::string_view name, std::size_t size) const;
  /// Returns colors row by row from the top: height x width x 3 bytes.
  Image Picture(std::string_view name) const;

 private:
  const wire::NamedArray& At(std::string_view name) const;

  wire::Message message_;
};

}  // namespace smile::brain_client
