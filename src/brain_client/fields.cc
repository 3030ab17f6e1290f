#include "brain_client/fields.h"

#include <algorithm>
#include <map>
#include <span>
#include <stdexcept>
#include <string>

namespace smile::brain_client {
namespace {

// Names what is there and what was expected; the shape is what people usually get wrong.
[[noreturn]] void Reject(const wire::NamedArray& array, const char* expected) {
  const bool is_text = array.type == wire::ElementType::kText;
  throw std::invalid_argument(array.name + " is " +
                              (is_text ? "text" : wire::ShapeText(array.dims)) + ", expected " +
                              expected);
}

/// Returns a hint for a classic variable, which exists for robots with two arms of seven joints
/// only; otherwise an empty text.
std::string CounterpartOf(std::string_view name) {
  static const std::map<std::string_view, const char*> kInstead = {
      {"numLimbs", "aux.arms.size()"},
      {"numJoints", "aux.arms[k].joints.size()"},
      {"minJointAngles", "aux.arms[k].min_joints"},
      {"maxJointAngles", "aux.arms[k].max_joints"},
      {"maxJointVelocities", "aux.arms[k].max_velocities"},
      {"jointAngles", "sensor.arms[k].joints"},
      {"jointVelocities", "sensor.arms[k].velocities"},
      {"gripperOpening", "sensor.arms[k].gripper"},
      {"endEffPos", "sensor.arms[k].end_effector"},
      {"isHolding", "sensor.arms[k].held_object"},
      {"heldObject", "sensor.arms[k].held_object"}};
  const auto found = kInstead.find(name);
  if (found == kInstead.end()) return "";
  return std::string("; it is for two arms of seven joints, use ") + found->second;
}

}  // namespace

const wire::NamedArray& Fields::At(std::string_view name) const {
  if (const wire::NamedArray* array = message_.Find(name)) return *array;
  // The list of what exists is the quickest help for a misspelled name.
  std::string names;
  for (const wire::NamedArray& array : message_.arrays) {
    names += (names.empty() ? "" : ", ") + array.name;
  }
  throw std::invalid_argument(std::string(name) + " is missing, found " +
                              (names.empty() ? "nothing" : names) + CounterpartOf(name));
}

double Fields::Number(std::string_view name) const {
  const wire::NamedArray& array = At(name);
  const auto numbers = array.Numbers();
  if (!numbers || numbers->size() != 1) Reject(array, "one number");
  return numbers->front();
}

Eigen::MatrixXd Fields::Matrix(std::string_view name) const {
  const wire::NamedArray& array = At(name);
  const auto numbers = array.Numbers();
  if (!numbers || array.dims.size() != 2) Reject(array, "a matrix");
  // The message describes its own order: which one is used depends on what the client asked for.
  if (array.is_row_major) {
    return Eigen::Map<const Eigen::Matrix<double, -1, -1, Eigen::RowMajor>>(
        numbers->data(), array.dims[0], array.dims[1]);
  }
  return Eigen::Map<const Eigen::MatrixXd>(numbers->data(), array.dims[0], array.dims[1]);
}

std::vector<double> Fields::Doubles(std::string_view name, std::size_t size) const {
  const wire::NamedArray& array = At(name);
  if (array.type != wire::ElementType::kDouble || array.data.size() != size * sizeof(double)) {
    Reject(array, (std::to_string(size) + " numbers").c_str());
  }
  std::vector<double> numbers(size);
  std::ranges::copy(array.data, std::as_writable_bytes(std::span(numbers)).begin());
  return numbers;
}

std::string Fields::Text(std::string_view name) const {
  const wire::NamedArray& array = At(name);
  if (array.type != wire::ElementType::kText) Reject(array, "text");
  return array.Text().value_or("");
}

Image Fields::Picture(std::string_view name) const {
  const wire::NamedArray& array = At(name);
  if (array.type != wire::ElementType::kByte || array.dims.size() != 3 || array.dims[2] != 3) {
    Reject(array, "HxWx3 bytes");
  }
  const std::size_t height = array.dims[0], width = array.dims[1];
  Image image{.width_px = static_cast<int>(width),
              .height_px = static_cast<int>(height),
              .color = std::vector<std::uint8_t>(array.data.size()),
              .depth = {},
              .ids = {}};
  if (array.is_row_major) {
    std::ranges::copy(std::span(array.data),
                      std::as_writable_bytes(std::span(image.color)).begin());
    return image;
  }
  // Planes by columns (Matlab's order) become rows of interleaved pixels (the order of Image).
  wire::CopyToRowMajor(array.dims, 1, array.data, std::as_writable_bytes(std::span(image.color)));
  return image;
}

}  // namespace smile::brain_client
