#include "brain/brain_messages.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <sstream>
#include <stdexcept>

#include "base/wording.h"

namespace smile::brain {
namespace {

constexpr std::size_t kMaxMarkers = 10'000;
constexpr std::size_t kMaxErrorLetters = 2'000;

template <class Matrix>
void AddMatrix(MessageWriter& writer, std::string_view name, const Matrix& matrix) {
  const Eigen::MatrixXd column_major = matrix;
  const std::array dims{static_cast<std::uint32_t>(matrix.rows()),
                        static_cast<std::uint32_t>(matrix.cols())};
  writer.AddDoubles(name, dims,
                    {column_major.data(), static_cast<std::size_t>(column_major.size())});
}

void AddCamera(MessageWriter& writer, const CameraDescription& camera) {
  Eigen::Matrix3d K;
  K << camera.fx, 0, camera.cx, 0, camera.fy, camera.cy, 0, 0, 1;
  AddMatrix(writer, "cameraIntrinsics", K);
  AddMatrix(writer, "cameraSize", Eigen::RowVector2d(camera.height_px, camera.width_px));
  AddMatrix(writer, "cameraPose", camera.X_WC);
}

/// Names in one text, a line each; positions in the same order.
void AddTrackers(MessageWriter& writer, const Sensor& sensor) {
  std::string names;
  Eigen::MatrixX3d positions(sensor.tracker_locations.size(), 3);
  Eigen::Index row = 0;
  for (const auto& [name, p_WQ] : sensor.tracker_locations) {
    if (name.find('\n') != std::string::npos) {
      throw std::invalid_argument("tracker name '" + name + "' holds a line break");
    }
    names += (row > 0 ? "\n" : "") + name;
    positions.row(row++) = p_WQ;
  }
  writer.AddText("trackerNames", names);
  AddMatrix(writer, "trackerPositions", positions);
}

/// One object a line, with its properties behind it, between commas.
void AddAttention(MessageWriter& writer, const Attention& attention) {
  std::string text;
  for (const auto& [object, properties] : attention) {
    std::string line = object;
    for (const std::string& property : properties) line += "," + property;
    const auto num_commas = static_cast<std::size_t>(std::count(line.begin(), line.end(), ','));
    if (line.find('\n') != std::string::npos || num_commas != properties.size()) {
      throw std::invalid_argument("'" + object +
                                  "' or a property of it holds a comma or line break");
    }
    text += (text.empty() ? "" : "\n") + line;
  }
  writer.AddText("attention", text);
}

/// From rows of interleaved pixels to Matlab's columns of one color after the other.
void AddImage(MessageWriter& writer, const Image& image) {
  const auto width = static_cast<std::size_t>(std::max(0, image.width_px));
  const auto height = static_cast<std::size_t>(std::max(0, image.height_px));
  if (image.color.empty() || image.color.size() != width * height * 3) {
    throw std::invalid_argument("rgb_vision: " + std::to_string(image.color.size()) +
                                " bytes do not make " + std::to_string(height) + "x" +
                                std::to_string(width) + "x3");
  }
  const std::array dims{static_cast<std::uint32_t>(height), static_cast<std::uint32_t>(width), 3u};
  const auto planes = writer.AddSpace("rgbVision", ElementType::kByte, true, dims);
  const std::uint8_t* pixels = image.color.data();
  std::byte* out = planes.data();
  const std::size_t plane = width * height;
  for (std::size_t column = 0; column < width; ++column) {
    for (std::size_t row = 0; row < height; ++row, ++out) {
      const std::uint8_t* pixel = pixels + 3 * (row * width + column);
      out[0] = std::byte{pixel[0]};
      out[plane] = std::byte{pixel[1]};
      out[2 * plane] = std::byte{pixel[2]};
    }
  }
}

/// A finite matrix from outside. `variable` is what the script calls it, for example `motor.`.
class MatrixReader {
 public:
  explicit MatrixReader(std::string prefix) : prefix_(std::move(prefix)) {}

  /// Reads an array of exactly `rows` x `cols`; -1 as `rows` takes any number of them.
  /// On failure the first error is kept and zeros are returned.
  Eigen::MatrixXd Read(const NamedArray& array, int rows, int cols) {
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
    const Eigen::MatrixXd matrix =
        Eigen::Map<const Eigen::MatrixXd>(numbers->data(), array.dims[0], array.dims[1]);
    CheckFinite(array.name, matrix);
    return matrix;
  }

  void Fail(const std::string& message) {
    if (error_.message.empty()) error_.message = prefix_ + message;
  }
  bool ok() const { return error_.message.empty(); }
  const WireError& error() const { return error_; }

 private:
  void CheckFinite(const std::string& name, const Eigen::MatrixXd& matrix) {
    for (Eigen::Index row = 0; row < matrix.rows(); ++row) {
      for (Eigen::Index col = 0; col < matrix.cols(); ++col) {
        if (std::isfinite(matrix(row, col))) continue;
        Fail(name + "(" + std::to_string(row + 1) + "," + std::to_string(col + 1) + ") is " +
             NumberText(matrix(row, col)) + ", expected a finite number");
      }
    }
  }

  std::string prefix_;
  WireError error_;
};

void ReadMotorField(MatrixReader& reader, const NamedArray& field, Motor* motor) {
  if (field.name == "jointVelocities") {
    motor->joint_velocities = reader.Read(field, kLimbCount, kJointCount);
  } else if (field.name == "gripperVelocities") {
    // A row is taken too: it is what sensor.gripperOpening looks like.
    const bool is_row = field.dims.size() == 2 && field.dims[0] == 1 && field.dims[1] == kLimbCount;
    motor->gripper_velocities = is_row ? Eigen::Vector2d(reader.Read(field, 1, 2).transpose())
                                       : Eigen::Vector2d(reader.Read(field, 2, 1));
  } else if (field.name == "jointAngles") {
    motor->joint_angles = reader.Read(field, kLimbCount, kJointCount);
  } else if (field.name == "headVelocity") {
    motor->head_velocity = reader.Read(field, 1, 1)(0, 0);
  } else {
    reader.Fail(field.name +
                " is unknown, expected jointVelocities, gripperVelocities, jointAngles or "
                "headVelocity");
  }
}

int LineOf(const Message& message) {
  const NamedArray* array = message.Find("line");
  const auto numbers = array ? array->Numbers() : std::nullopt;
  if (!numbers || numbers->size() != 1) return 0;
  const double line = numbers->front();
  return line >= 1 && line <= std::numeric_limits<int>::max() ? static_cast<int>(line) : 0;
}

}  // namespace

std::vector<std::byte> EncodeAux(std::uint32_t sequence, const Aux& aux, std::string_view path) {
  MessageWriter writer(MessageType::kInit, sequence);
  writer.AddText("path", path);
  writer.AddScalar("numLimbs", kLimbCount);
  writer.AddScalar("numJoints", kJointCount);
  AddMatrix(writer, "minJointAngles", aux.min_joint_angles);
  AddMatrix(writer, "maxJointAngles", aux.max_joint_angles);
  if (aux.camera) AddCamera(writer, *aux.camera);
  if (!aux.demonstration.empty()) writer.AddText("demonstration", aux.demonstration);
  AddAttention(writer, aux.attention);
  return writer.Finish();
}

std::vector<std::byte> EncodeSensor(std::uint32_t sequence, const Sensor& sensor) {
  MessageWriter writer(MessageType::kStep, sequence);
  writer.AddScalar("timeElapsed", sensor.time_elapsed);
  writer.AddScalar("simTime", sensor.sim_time);
  AddMatrix(writer, "jointAngles", sensor.joint_angles);
  AddMatrix(writer, "endEffPos", sensor.end_effector_positions);
  AddMatrix(writer, "gripperOpening", sensor.gripper_openings);
  writer.AddLogical("demoCue", sensor.demo_cue);
  if (!sensor.tracker_locations.empty()) AddTrackers(writer, sensor);
  if (sensor.rgb_vision) AddImage(writer, *sensor.rgb_vision);
  return writer.Finish();
}

std::variant<InitReply, WireError> DecodeInitReply(const Message& message) {
  MatrixReader reader("aux.");
  InitReply reply;
  if (const NamedArray* angles = message.Find("initJointAngles")) {
    reply.init_joint_angles = reader.Read(*angles, kLimbCount, kJointCount);
  }
  // `[]` has no columns; it means no markers.
  const NamedArray* markers = message.Find("drawMarkers");
  if (markers && (!markers->data.empty() || markers->dims.back() == 3)) {
    reply.draw_markers = reader.Read(*markers, -1, 3);
    if (reply.draw_markers.rows() > static_cast<Eigen::Index>(kMaxMarkers)) {
      reader.Fail("drawMarkers has " + std::to_string(reply.draw_markers.rows()) +
                  " rows, expected at most " + std::to_string(kMaxMarkers));
    }
  }
  if (!reader.ok()) return reader.error();
  return reply;
}

std::variant<StepReply, WireError> DecodeStepReply(const Message& message) {
  MatrixReader reader("motor.");
  StepReply reply;
  reply.exit = message.type == MessageType::kFinalMotor;
  for (const NamedArray& field : message.arrays) ReadMotorField(reader, field, &reply.motor);
  if (!message.Find("jointVelocities") && !reply.motor.joint_angles) {
    reader.Fail("jointVelocities is missing, expected 2x7");
  }
  if (!message.Find("gripperVelocities")) reader.Fail("gripperVelocities is missing, expected 2x1");
  if (!reader.ok()) return reader.error();
  return reply;
}

BrainError DecodeError(const Message& message) {
  BrainError error;
  error.message = PrintableText(message.TextOf("message"), kMaxErrorLetters);
  if (error.message.empty()) error.message = "an error without a message";
  error.file = PrintableText(message.TextOf("file"), kMaxErrorLetters);
  error.line = LineOf(message);
  return error;
}

std::string PrintableText(std::string_view text, std::size_t max_letters) {
  std::string printable(text.substr(0, max_letters));
  for (char& letter : printable) {
    const auto code = static_cast<unsigned char>(letter);
    if ((code < 0x20 && letter != '\t') || code == 0x7f) letter = letter == '\n' ? ' ' : '?';
  }
  if (text.size() > max_letters) printable += "...";
  return printable;
}

}  // namespace smile::brain
