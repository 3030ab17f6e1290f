#pragma once

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <cmath>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "math/rigid_transform.h"

// Values of C++ as numpy arrays, and back. All are SI units and radians; quaternions are w, x, y,
// z.

namespace smile::python {

namespace py = pybind11;

using Array = py::array_t<double, py::array::c_style | py::array::forcecast>;

inline std::string ShapeText(const Array& array) {
  std::string text = "(";
  for (py::ssize_t i = 0; i < array.ndim(); ++i) {
    text += (i > 0 ? ", " : "") + std::to_string(array.shape(i));
  }
  return text + (array.ndim() == 1 ? ",)" : ")");
}

/// Returns the finite numbers of an argument.
/// @param size  number expected; 0 for any.
/// @throws std::invalid_argument with the shape or number found and expected.
inline std::vector<double> NumbersFrom(const char* name, const Array& array, std::size_t size) {
  const auto count = static_cast<std::size_t>(array.size());
  if (array.ndim() != 1 || (size != 0 && count != size)) {
    throw std::invalid_argument(std::string(name) + " has shape " + ShapeText(array) +
                                ", expected (" + (size != 0 ? std::to_string(size) : "n") + ",)");
  }
  for (std::size_t i = 0; i < count; ++i) {
    if (!std::isfinite(array.data()[i])) {
      throw std::invalid_argument(std::string(name) + "[" + std::to_string(i) +
                                  "] is not finite, expected a finite number");
    }
  }
  return {array.data(), array.data() + count};
}

/// Demands that a speed, if given, is a finite number above 0 [m/s].
inline void RequireSpeed(const std::optional<double>& speed) {
  if (speed && !(*speed > 0 && std::isfinite(*speed))) {
    throw std::invalid_argument("speed is " + std::to_string(*speed) +
                                " m/s, expected a finite number above 0");
  }
}

inline Vector3 Vector3From(const char* name, const Array& array) {
  const std::vector<double> v = NumbersFrom(name, array, 3);
  return {v[0], v[1], v[2]};
}

/// Returns the shape of a vector. Arrays are always made of a shape: for a bare number of elements,
/// pybind11 before 2.12 asks numpy for the strides, and misreads the answer of numpy 2.
inline std::vector<py::ssize_t> VectorShape(std::size_t size) {
  return {static_cast<py::ssize_t>(size)};
}

inline Array ArrayOf(std::span<const double> values) {
  return Array(VectorShape(values.size()), values.data());
}
inline Array ArrayOf(const Vector3& v) { return Array(VectorShape(3), v.data()); }
inline Array ArrayOf(const std::vector<double>& values) {
  return ArrayOf(std::span<const double>(values));
}

/// Writes a pose as position and quaternion: x, y, z, w, qx, qy, qz.
inline void WritePose(const RigidTransform& X, double* out) {
  const Quaternion q = X.quaternion();
  const Vector3& p = X.translation();
  const double values[7] = {p.x(), p.y(), p.z(), q.w(), q.x(), q.y(), q.z()};
  std::copy(values, values + 7, out);
}
inline Array PoseArray(const RigidTransform& X) {
  Array array(VectorShape(7));
  WritePose(X, array.mutable_data());
  return array;
}

/// Returns a 4x4 matrix of a pose.
inline Array MatrixOf(const RigidTransform& X) {
  Array array({py::ssize_t{4}, py::ssize_t{4}});
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < 4; ++j) {
      array.mutable_at(i, j) = i == 3   ? double(j == 3)
                               : j == 3 ? X.translation()[i]
                                        : X.rotation()(i, j);
    }
  }
  return array;
}

/// Moves a vector into a numpy array of a shape, without a copy.
template <class T>
py::array OwnedArray(std::vector<T> values, std::vector<py::ssize_t> shape) {
  auto* owner = new std::vector<T>(std::move(values));
  const py::capsule capsule(owner, [](void* data) { delete static_cast<std::vector<T>*>(data); });
  return py::array_t<T>(std::move(shape), owner->data(), capsule);
}

}  // namespace smile::python
