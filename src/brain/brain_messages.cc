// Translation between the structs of brain_values.h and messages of wire.h, in both directions.
// Writing trusts its caller and throws on misuse. Reading trusts nothing: a brain is a foreign
// program, so each array is checked for type, shape and range before a value is used, and the first
// fault becomes a message that names the variable as the script's author wrote it.

#include "brain/brain_messages.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <stdexcept>

#include "base/wording.h"
#include "brain/internal_matrix_reader.h"
#include "brain/internal_motor_reader.h"
#include "brain/internal_note_reader.h"
#include "sim/tick.h"

namespace smile::brain {
namespace {

// Limits on what a brain can make the simulator print, render or wait for.
constexpr std::size_t kMaxExtraCameras = 8;
constexpr double kMaxImageSeconds = 3600;

/// Adds a matrix. The protocol's order is column-major; a copy into a column-major matrix converts
/// Eigen types that are stored by rows.
template <class Matrix>
void AddMatrix(MessageWriter& writer, std::string_view name, const Matrix& matrix) {
  const Eigen::Matrix<double, Matrix::RowsAtCompileTime, Matrix::ColsAtCompileTime> column_major =
      matrix;
  const std::array dims{static_cast<std::uint32_t>(matrix.rows()),
                        static_cast<std::uint32_t>(matrix.cols())};
  writer.AddDoubles(name, dims,
                    {column_major.data(), static_cast<std::size_t>(column_major.size())});
}

Eigen::Matrix3d IntrinsicsOf(const CameraDescription& camera) {
  Eigen::Matrix3d K;
  K << camera.fx, 0, camera.cx, 0, camera.fy, camera.cy, 0, 0, 1;
  return K;
}

void AddCamera(MessageWriter& writer, const CameraDescription& camera) {
  AddMatrix(writer, "cameraIntrinsics", IntrinsicsOf(camera));
  AddMatrix(writer, "cameraSize", Eigen::RowVector2d(camera.height_px, camera.width_px));
  AddMatrix(writer, "cameraPose", camera.X_WC);
}

/// Adds names as one text, one per line.
void AddLines(MessageWriter& writer, std::string_view field, std::span<const std::string> names) {
  std::string text;
  for (const std::string& name : names) {
    if (name.find('\n') != std::string::npos) {
      throw std::invalid_argument(std::string(field) + ": '" + name + "' contains a line break");
    }
    // Not before the first name; an empty first name (an empty hand in `heldObject`) is still a
    // line.
    if (&name != &names.front()) text += "\n";
    text += name;
  }
  writer.AddText(field, text);
}

/// Adds the trackers: names, and positions in the same order.
void AddTrackers(MessageWriter& writer, const Sensor& sensor) {
  // A map of the struct is sorted by name, so equal sensors give equal bytes.
  std::vector<std::string> names;
  Eigen::MatrixX3d positions(sensor.tracker_locations.size(), 3);
  for (const auto& [name, p_WQ] : sensor.tracker_locations) {
    positions.row(static_cast<Eigen::Index>(names.size())) = p_WQ;
    names.push_back(name);
  }
  AddLines(writer, "trackerNames", names);
  AddMatrix(writer, "trackerPositions", positions);
}

/// Adds attention as one text: one object per line, followed by its properties, separated by
/// commas.
void AddAttention(MessageWriter& writer, const Attention& attention) {
  std::string text;
  for (const auto& [object, properties] : attention) {
    std::string line = object;
    for (const std::string& property : properties) line += "," + property;
    // The reader splits at commas and line breaks without any escaping, so a name with one of them
    // would silently become two.
    const auto num_commas = static_cast<std::size_t>(std::count(line.begin(), line.end(), ','));
    if (line.find('\n') != std::string::npos || num_commas != properties.size()) {
      throw std::invalid_argument("'" + object +
                                  "' or one of its properties contains a comma or line break");
    }
    text += (text.empty() ? "" : "\n") + line;
  }
  writer.AddText("attention", text);
}

/// Returns ids in one line, separated by commas.
/// @throws std::invalid_argument if one contains a comma or a line break, see AddAttention().
std::string InOneLine(const std::vector<std::string>& ids) {
  std::string line;
  for (const std::string& id : ids) {
    if (id.find_first_of(",\n") != std::string::npos) {
      throw std::invalid_argument("'" + id + "' contains a comma or line break");
    }
    line += (line.empty() ? "" : ",") + id;
  }
  return line;
}

/// Adds the plan; its subtasks are counted from 1.
void AddPlan(MessageWriter& writer, const TaskPlan& plan) {
  std::vector<std::string> words, objects;
  Eigen::MatrixX2d segments(plan.subtasks.size(), 2), order(plan.order.size(), 2);
  Eigen::RowVectorXd necessary(plan.subtasks.size()), sufficient(plan.sufficient.size());
  for (const PlanSubtask& subtask : plan.subtasks) {
    const auto row = static_cast<Eigen::Index>(words.size());
    segments.row(row) << subtask.first, subtask.last;
    necessary[row] = subtask.is_necessary ? 1 : 0;
    words.push_back(subtask.words);
    objects.push_back(InOneLine(subtask.objects));
  }
  for (std::size_t i = 0; i < plan.order.size(); ++i) {
    const auto [before, after] = plan.order[i];
    order.row(static_cast<Eigen::Index>(i)) << static_cast<double>(before + 1),
        static_cast<double>(after + 1);
  }
  for (std::size_t i = 0; i < plan.sufficient.size(); ++i) {
    sufficient[static_cast<Eigen::Index>(i)] = static_cast<double>(plan.sufficient[i] + 1);
  }
  AddLines(writer, "planWords", words);
  AddLines(writer, "planObjects", objects);
  AddMatrix(writer, "planSegments", segments);
  AddMatrix(writer, "planNecessary", necessary);
  AddMatrix(writer, "planOrder", order);
  AddMatrix(writer, "planSufficient", sufficient);
  AddLines(writer, "planGoals", plan.goals);
}

/// Throws std::invalid_argument unless a channel has one value per pixel and component.
void CheckChannel(const std::string& field, std::size_t found, const Image& image, int depth) {
  const auto width = static_cast<std::size_t>(std::max(0, image.width_px));
  const auto height = static_cast<std::size_t>(std::max(0, image.height_px));
  if (found > 0 && found == width * height * depth) return;
  throw std::invalid_argument(field + ": " + std::to_string(found) + " values do not make " +
                              std::to_string(height) + "x" + std::to_string(width) + "x" +
                              std::to_string(depth));
}

/// Calls `visit(column, first row, end row)` for parts of all columns, tile by tile: transposing a
/// picture touches rows and columns that are far apart in memory; within a tile, both stay in the
/// cache.
template <class Visit>
void VisitColumnsInTiles(std::size_t width, std::size_t height, Visit visit) {
  constexpr std::size_t kTileRows = 64, kTileColumns = 64;
  for (std::size_t left = 0; left < width; left += kTileColumns) {
    const std::size_t right = std::min(width, left + kTileColumns);
    for (std::size_t top = 0; top < height; top += kTileRows) {
      const std::size_t bottom = std::min(height, top + kTileRows);
      for (std::size_t column = left; column < right; ++column) visit(column, top, bottom);
    }
  }
}

/// Converts rows of interleaved pixels to Matlab's order: one color after the other, each by
/// columns.
void FillPlanes(const std::uint8_t* pixels, std::size_t width, std::size_t height,
                std::byte* planes) {
  const std::size_t plane = width * height;
  VisitColumnsInTiles(width, height, [=](std::size_t column, std::size_t top, std::size_t bottom) {
    const std::uint8_t* pixel = pixels + 3 * (top * width + column);
    std::byte* out = planes + column * height + top;
    for (std::size_t row = top; row < bottom; ++row, ++out, pixel += 3 * width) {
      out[0] = std::byte{pixel[0]};
      out[plane] = std::byte{pixel[1]};
      out[2 * plane] = std::byte{pixel[2]};
    }
  });
}

// Bytes with the flag "fraction": a script sees 0 to 1, while the message takes an eighth of
// doubles.
void AddColors(MessageWriter& writer, const std::string& field, const Image& image,
               PixelOrder order) {
  CheckChannel(field, image.color.size(), image, 3);
  const auto width = static_cast<std::size_t>(image.width_px);
  const auto height = static_cast<std::size_t>(image.height_px);
  const std::array dims{static_cast<std::uint32_t>(height), static_cast<std::uint32_t>(width), 3u};
  const bool is_row_major = order == PixelOrder::kRows;
  const auto space = writer.AddSpace(field, ElementType::kByte, true, dims, is_row_major);
  if (is_row_major) {
    std::ranges::copy(std::as_bytes(std::span(image.color)), space.begin());
  } else {
    FillPlanes(image.color.data(), width, height, space.data());
  }
}

/// Adds depths or ids as doubles.
template <class Value>
void AddValues(MessageWriter& writer, const std::string& field, const std::vector<Value>& values,
               const Image& image, PixelOrder order) {
  CheckChannel(field, values.size(), image, 1);
  const auto width = static_cast<std::size_t>(image.width_px);
  const auto height = static_cast<std::size_t>(image.height_px);
  const std::array dims{static_cast<std::uint32_t>(height), static_cast<std::uint32_t>(width)};
  const bool is_row_major = order == PixelOrder::kRows;
  // The space is only byte-aligned as far as C++ knows, hence memcpy() instead of a pointer to
  // double.
  std::byte* out = writer.AddSpace(field, ElementType::kDouble, false, dims, is_row_major).data();
  const auto put = [out, &values](std::size_t to, std::size_t from) {
    const auto number = static_cast<double>(values[from]);
    std::memcpy(out + to * sizeof number, &number, sizeof number);
  };
  if (is_row_major) {
    for (std::size_t k = 0; k < values.size(); ++k) put(k, k);
    return;
  }
  VisitColumnsInTiles(width, height, [=](std::size_t column, std::size_t top, std::size_t bottom) {
    for (std::size_t row = top; row < bottom; ++row)
      put(column * height + row, row * width + column);
  });
}

/// Field names of a picture's channels.
struct PictureFields {
  std::string rgb, depth, segments, pose;
};

PictureFields FieldsOf(const std::string& camera) {
  if (camera.empty()) return {"rgbVision", "depthVision", "segmentVision", "cameraPose"};
  // Names of arrays have no dots; the clients split these into `sensor.cameras.NAME.rgb`.
  const std::string prefix = "cameras_" + camera + "_";
  return {prefix + "rgb", prefix + "depth", prefix + "segments", prefix + "pose"};
}

void AddPicture(MessageWriter& writer, const CameraPicture& picture, PixelOrder order) {
  const PictureFields fields = FieldsOf(picture.name);
  const Image& image = picture.image;
  if (!image.color.empty()) AddColors(writer, fields.rgb, image, order);
  if (!image.depth.empty()) AddValues(writer, fields.depth, image.depth, image, order);
  if (!image.ids.empty()) AddValues(writer, fields.segments, image.ids, image, order);
  AddMatrix(writer, fields.pose, picture.camera.X_WC);
  // The eye's intrinsics are in `aux`, as they never change.
  if (!picture.name.empty()) {
    AddMatrix(writer, "cameras_" + picture.name + "_intrinsics", IntrinsicsOf(picture.camera));
  }
}

/// Returns the approximate size of the pictures of a message [bytes], to reserve memory: names and
/// poses are small.
std::size_t PictureBytes(const Sensor& sensor) {
  std::size_t bytes = 0;
  for (const CameraPicture& picture : sensor.pictures) {
    const Image& image = picture.image;
    bytes += image.color.size() + sizeof(double) * (image.depth.size() + image.ids.size()) + 2000;
  }
  return bytes;
}

/// Returns the classic variable of joints: one row per arm. `values` is a member of its elements.
template <class Arm>
Eigen::MatrixXd LimbJoints(const std::vector<Arm>& arms, std::vector<double> Arm::*values) {
  Eigen::MatrixXd rows(arms.size(), kJointCount);
  for (std::size_t arm = 0; arm < arms.size(); ++arm) {
    const std::vector<double>& row = arms[arm].*values;
    rows.row(static_cast<Eigen::Index>(arm)) =
        Eigen::Map<const Eigen::RowVectorXd>(row.data(), kJointCount);
  }
  return rows;
}

/// Adds values of all arms' joints, arm by arm, as one row.
template <class Arm>
void AddJoints(MessageWriter& writer, std::string_view name, const std::vector<Arm>& arms,
               std::vector<double> Arm::*values) {
  std::vector<double> row;
  for (const Arm& arm : arms) row.insert(row.end(), (arm.*values).begin(), (arm.*values).end());
  writer.AddDoubles(name, std::array{1u, static_cast<std::uint32_t>(row.size())}, row);
}

/// Adds matrices as 4x4xN.
void AddPoses(MessageWriter& writer, std::string_view name,
              const std::vector<Eigen::Matrix4d>& poses) {
  std::vector<double> numbers;
  for (const Eigen::Matrix4d& pose : poses) {
    const double* column_major = pose.data();
    numbers.insert(numbers.end(), column_major, column_major + 16);
  }
  writer.AddDoubles(name, std::array{4u, 4u, static_cast<std::uint32_t>(poses.size())}, numbers);
}

/// Adds a 4x4 matrix of each arm: 4x4xN.
template <class Arm>
void AddPoses(MessageWriter& writer, std::string_view name, const std::vector<Arm>& arms,
              Eigen::Matrix4d Arm::*pose) {
  std::vector<Eigen::Matrix4d> poses;
  for (const Arm& arm : arms) poses.push_back(arm.*pose);
  AddPoses(writer, name, poses);
}

/// Adds the description of arms in the general form: joints arm by arm, of which `armJointCounts`
/// belong to each.
void AddArms(MessageWriter& writer, const std::vector<ArmDescription>& arms) {
  std::vector<std::string> names, joint_names;
  Eigen::RowVectorXd counts(arms.size());
  // Not a number stands for no gripper: messages have no empty elements.
  Eigen::MatrixXd grippers =
      Eigen::MatrixXd::Constant(2, static_cast<Eigen::Index>(arms.size()), std::nan(""));
  for (std::size_t k = 0; k < arms.size(); ++k) {
    const auto column = static_cast<Eigen::Index>(k);
    names.push_back(arms[k].name);
    joint_names.insert(joint_names.end(), arms[k].joint_names.begin(), arms[k].joint_names.end());
    counts[column] = arms[k].num_joints();
    if (arms[k].gripper) grippers.col(column) = *arms[k].gripper;
  }
  AddLines(writer, "armNames", names);
  AddMatrix(writer, "armJointCounts", counts);
  AddLines(writer, "armJointNames", joint_names);
  AddJoints(writer, "armMinJoints", arms, &ArmDescription::min_joints);
  AddJoints(writer, "armMaxJoints", arms, &ArmDescription::max_joints);
  AddJoints(writer, "armMaxVelocities", arms, &ArmDescription::max_velocities);
  AddMatrix(writer, "armGrippers", grippers);
  AddPoses(writer, "armToolPoses", arms, &ArmDescription::X_LG);
}

/// Adds the state of arms in the general form.
void AddArms(MessageWriter& writer, const std::vector<ArmSensor>& arms) {
  std::vector<std::string> held;
  Eigen::RowVectorXd grippers(arms.size());
  for (std::size_t k = 0; k < arms.size(); ++k) {
    held.push_back(arms[k].held_object);
    grippers[static_cast<Eigen::Index>(k)] = arms[k].gripper.value_or(std::nan(""));
  }
  AddJoints(writer, "armJoints", arms, &ArmSensor::joints);
  AddJoints(writer, "armVelocities", arms, &ArmSensor::velocities);
  AddMatrix(writer, "armGrippers", grippers);
  AddPoses(writer, "armEndEffectors", arms, &ArmSensor::X_WG);
  AddLines(writer, "armHeldObjects", held);
}

/// Returns true for the state of two arms of seven joints.
bool IsClassic(const std::vector<ArmSensor>& arms) {
  return arms.size() == kLimbCount && std::ranges::all_of(arms, [](const ArmSensor& arm) {
           return arm.joints.size() == kJointCount;
         });
}

/// Adds the classic variables of where the arms are.
void AddClassicPosition(MessageWriter& writer, const std::vector<ArmSensor>& arms) {
  Eigen::Matrix<double, kLimbCount, 3> positions;
  Eigen::RowVector2d openings;
  for (int arm = 0; arm < kLimbCount; ++arm) {
    positions.row(arm) = arms[arm].X_WG.topRightCorner<3, 1>().transpose();
    openings[arm] = arms[arm].gripper.value_or(0);
  }
  AddMatrix(writer, "jointAngles", LimbJoints(arms, &ArmSensor::joints));
  AddMatrix(writer, "endEffPos", positions);
  AddMatrix(writer, "gripperOpening", openings);
}

void AddHeld(MessageWriter& writer, const std::vector<ArmSensor>& arms) {
  // `isHolding` repeats what the names show: in a script, a logical array is easier to test than
  // texts.
  const std::array dims{1u, static_cast<std::uint32_t>(arms.size())};
  const auto flags = writer.AddSpace("isHolding", ElementType::kLogical, false, dims);
  std::vector<std::string> held;
  for (std::size_t arm = 0; arm < arms.size(); ++arm) {
    flags[arm] = std::byte{!arms[arm].held_object.empty()};
    held.push_back(arms[arm].held_object);
  }
  AddLines(writer, "heldObject", held);
}

/// Returns the words of a text from a brain, separated by line breaks, commas or blanks.
std::vector<std::string> ReadWords(const NamedArray& array, MatrixReader& reader) {
  const auto text = array.Text();
  if (!text && !array.data.empty()) {
    reader.Fail(array.name + " is " + ShapeText(array.dims) + " numbers, expected names");
    return {};
  }
  // Octave makes a matrix of characters from several lines; read by columns, it would be nonsense.
  if (text && !text->empty() && (array.dims.size() != 2 || array.dims[0] != 1)) {
    reader.Fail(array.name + " is " + ShapeText(array.dims) + " characters, expected one line");
    return {};
  }
  // The last element collects the letters of the present word; separators in a row add no empty
  // word.
  std::vector<std::string> words(1);
  for (const char letter : text.value_or("")) {
    if (letter != '\n' && letter != ',' && letter != ' ') {
      words.back() += letter;
    } else if (!words.back().empty()) {
      words.emplace_back();
    }
  }
  if (words.back().empty()) words.pop_back();
  return words;
}

/// Returns words that must be among `known`, each once; otherwise reports the first error.
std::vector<std::string> ReadChoice(const NamedArray& array,
                                    std::span<const std::string_view> known, MatrixReader& reader) {
  std::vector<std::string> words = ReadWords(array, reader);
  for (std::size_t i = 0; i < words.size(); ++i) {
    const std::string named = array.name + " names " + Quoted(PrintableText(words[i], 100));
    if (std::ranges::find(known, words[i]) == known.end()) {
      reader.Fail(named + ", expected " + OneOf(known) + DidYouMean(words[i], known));
    } else if (std::find(words.begin(), words.begin() + static_cast<std::ptrdiff_t>(i), words[i]) !=
               words.begin() + static_cast<std::ptrdiff_t>(i)) {
      reader.Fail(named + " twice, expected it once");
    }
    if (!reader.ok()) return {};
  }
  return words;
}

sim::Channels ReadChannels(const NamedArray& array, MatrixReader& reader) {
  constexpr std::array<std::string_view, 3> kNames{"rgb", "depth", "segmentation"};
  // The default has color on; here only what is named counts, and an empty text turns pictures off.
  sim::Channels channels{.rgb = false};
  for (const std::string& name : ReadChoice(array, kNames, reader)) {
    (name == kNames[0] ? channels.rgb : name == kNames[1] ? channels.depth : channels.id) = true;
  }
  return channels;
}

/// Reads which of the cameras that the brain requested in init it wants to see from now on.
std::vector<std::string> ReadCamerasOf(const NamedArray& array,
                                       std::span<const std::string> requested,
                                       MatrixReader& reader) {
  if (requested.empty()) {
    if (!ReadWords(array, reader).empty()) {
      reader.Fail(array.name + " names a camera, expected none: init requested none");
    }
    return {};
  }
  return ReadChoice(array, std::vector<std::string_view>(requested.begin(), requested.end()),
                    reader);
}

double ReadImageSeconds(const NamedArray& array, MatrixReader& reader) {
  const double seconds = reader.Read(array, 1, 1)(0, 0);
  if (reader.ok() && !(seconds >= 0 && seconds <= kMaxImageSeconds)) {
    reader.Fail(array.name + " is " + NumberText(seconds) + ", expected a number from 0 to " +
                NumberText(kMaxImageSeconds));
  }
  return seconds;
}

// A brain that waits for a demonstration that never comes would stand still without any hint.
bool ReadWatch(const NamedArray& array, const Aux& aux, MatrixReader& reader) {
  const bool watch = reader.Read(array, 1, 1)(0, 0) != 0;
  if (watch && aux.demonstration.empty()) {
    reader.Fail(array.name + " is true, but no demonstration is given");
  }
  return watch;
}

/// Reports an error if the requested pictures do not fit into a message.
void CheckSize(const PictureWishes& wishes, const Aux& aux, MatrixReader& reader) {
  if (!aux.camera) return;
  // Sizes as sent: three bytes of color, and one double for each depth and id. All requested
  // cameras have the resolution of the eye and are due at the same time, in one message.
  const std::size_t pixel_bytes =
      3 * wishes.channels.rgb + sizeof(double) * (wishes.channels.depth + wishes.channels.id);
  const std::size_t bytes = pixel_bytes * static_cast<std::size_t>(aux.camera->width_px) *
                            static_cast<std::size_t>(aux.camera->height_px) *
                            (1 + wishes.cameras.size());
  if (bytes <= kMaxPictureBytes) return;
  reader.Fail("channels and cameras require " + std::to_string(bytes >> 20) +
              " MiB per image time, expected at most " + std::to_string(kMaxPictureBytes >> 20) +
              "; request smaller or fewer pictures");
}

PictureWishes ReadPictureWishes(const Message& message, const Aux& aux, MatrixReader& reader) {
  PictureWishes wishes;
  if (const NamedArray* channels = message.Find("channels")) {
    wishes.channels = ReadChannels(*channels, reader);
  }
  if (const NamedArray* cameras = message.Find("cameras")) {
    const std::vector<std::string_view> known(aux.camera_names.begin(), aux.camera_names.end());
    wishes.cameras = ReadChoice(*cameras, known, reader);
    if (wishes.cameras.size() > kMaxExtraCameras) {
      reader.Fail("cameras names " + std::to_string(wishes.cameras.size()) + ", expected at most " +
                  std::to_string(kMaxExtraCameras));
    }
  }
  if (const NamedArray* seconds = message.Find("imageSeconds")) {
    wishes.image_seconds = ReadImageSeconds(*seconds, reader);
  }
  CheckSize(wishes, aux, reader);
  return wishes;
}

/// Reads `done` or `gave up`, with an optional reason after a colon.
std::optional<Claim> ReadClaim(const NamedArray& array, MatrixReader& reader) {
  constexpr std::array<std::string_view, 2> kWords{"done", "gave up"};
  const std::optional<std::string> text = array.Text();
  if (!text) {
    reader.Fail(array.name + " is no text, expected " + OneOf(kWords));
    return std::nullopt;
  }
  const std::string printable = PrintableText(*text, kMaxErrorLetters);
  const std::size_t colon = printable.find(':');
  const std::string word = printable.substr(0, colon);
  if (std::ranges::find(kWords, word) == kWords.end()) {
    reader.Fail(array.name + " is " + Quoted(printable.substr(0, 100)) + ", expected " +
                OneOf(kWords) + ", optionally followed by a colon and a reason");
    return std::nullopt;
  }
  Claim claim{.is_done = word == kWords[0], .reason = {}};
  if (colon != std::string::npos) {
    const std::size_t begin = printable.find_first_not_of(' ', colon + 1);
    if (begin != std::string::npos) claim.reason = printable.substr(begin);
  }
  return claim;
}

Points ReadMarkers(const NamedArray& markers, MatrixReader& reader) {
  // `[]` has no columns; it stands for no markers.
  if (markers.data.empty() && markers.dims.back() != 3) return Points(0, 3);
  if (markers.dims[0] > sim::kMaxMarkers) {
    reader.Fail("drawMarkers has " + std::to_string(markers.dims[0]) + " rows, expected at most " +
                std::to_string(sim::kMaxMarkers));
    return Points(0, 3);
  }
  return reader.Read(markers, -1, 3);
}

/// Returns the line of an error message; 0 if it is missing or invalid.
int LineOf(const Message& message) {
  const NamedArray* array = message.Find("line");
  const auto numbers = array ? array->Numbers() : std::nullopt;
  if (!numbers || numbers->size() != 1) return 0;
  const double line = numbers->front();
  return line >= 1 && line <= std::numeric_limits<int>::max() ? static_cast<int>(line) : 0;
}

void AddVariation(MessageWriter& writer, const BehaviorVariation& variation) {
  if (variation.speed) writer.AddScalar("variationSpeed", *variation.speed);
  for (const auto& [name, seed] :
       {std::pair("variationOrder", variation.order), std::pair("variationGrasp", variation.grasp),
        std::pair("variationPath", variation.path)}) {
    if (seed) writer.AddScalar(name, static_cast<double>(*seed));
  }
}

void AddObjects(MessageWriter& writer, const std::vector<ObjectDescription>& objects) {
  if (objects.empty()) return;
  std::vector<std::string> names;
  Eigen::MatrixX3d sizes(objects.size(), 3), colors(objects.size(), 3);
  for (const ObjectDescription& object : objects) {
    const auto row = static_cast<Eigen::Index>(names.size());
    names.push_back(object.id);
    sizes.row(row) = object.size;
    colors.row(row) = object.color;
  }
  AddLines(writer, "objectNames", names);
  AddMatrix(writer, "objectSizes", sizes);
  AddMatrix(writer, "objectColors", colors);
}

}  // namespace

std::vector<std::byte> EncodeAux(std::uint32_t sequence, const Aux& aux, std::string_view path,
                                 std::string_view robot) {
  MessageWriter writer(MessageType::kInit, sequence);
  writer.AddText("path", path);
  // Field names are fixed by docs/brain-protocol.md; clients of other versions read them by name,
  // so new fields may follow anywhere.
  if (IsClassic(aux.arms)) {
    writer.AddScalar("numLimbs", kLimbCount);
    writer.AddScalar("numJoints", kJointCount);
    AddMatrix(writer, "minJointAngles", LimbJoints(aux.arms, &ArmDescription::min_joints));
    AddMatrix(writer, "maxJointAngles", LimbJoints(aux.arms, &ArmDescription::max_joints));
    AddMatrix(writer, "maxJointVelocities", LimbJoints(aux.arms, &ArmDescription::max_velocities));
  }
  if (aux.sends_arms) AddArms(writer, aux.arms);
  writer.AddScalar("tickSeconds", 1.0 / sim::kTicksPerSecond);
  writer.AddScalar("maxTicks", kMaxChunkTicks);
  writer.AddScalar("unit", aux.meters_per_unit);
  AddMatrix(writer, "robotBase", aux.X_WBase);
  AddMatrix(writer, "tableSize", aux.table_size);
  if (!robot.empty()) writer.AddText("robot", robot);
  writer.AddText("robotGripper", aux.robot_gripper);
  AddLines(writer, "cameraNames", aux.camera_names);
  if (aux.camera) AddCamera(writer, *aux.camera);
  if (!aux.demonstration.empty()) writer.AddText("demonstration", aux.demonstration);
  AddAttention(writer, aux.attention);
  if (aux.plan) AddPlan(writer, *aux.plan);
  AddVariation(writer, aux.variation);
  AddObjects(writer, aux.objects);
  return writer.Finish();
}

std::vector<std::byte> EncodeSensor(std::uint32_t sequence, const Sensor& sensor,
                                    PixelOrder order) {
  MessageWriter writer(MessageType::kStep, sequence, 2000 + PictureBytes(sensor));
  writer.AddScalar("timeElapsed", sensor.time_elapsed);
  writer.AddScalar("simTime", sensor.sim_time);
  const bool is_classic = IsClassic(sensor.arms);
  if (is_classic) AddClassicPosition(writer, sensor.arms);
  writer.AddLogical("demoCue", sensor.demo_cue);
  if (!sensor.tracker_locations.empty()) AddTrackers(writer, sensor);
  if (is_classic) {
    AddMatrix(writer, "jointVelocities", LimbJoints(sensor.arms, &ArmSensor::velocities));
  }
  writer.AddScalar("headAngle", sensor.head_angle);
  if (is_classic) AddHeld(writer, sensor.arms);
  if (sensor.sends_arms) AddArms(writer, sensor.arms);
  for (const CameraPicture& picture : sensor.pictures) AddPicture(writer, picture, order);
  if (!sensor.segment_names.empty()) AddLines(writer, "segmentNames", sensor.segment_names);
  if (!sensor.object_poses.empty()) AddPoses(writer, "objectPoses", sensor.object_poses);
  return writer.Finish();
}

std::variant<InitReply, WireError> DecodeInitReply(const Message& message, const Aux& aux) {
  MatrixReader reader("aux.");
  InitReply reply;
  reply.init_joints = MotorReader::ReadPosture(message, aux.arms, &reader);
  if (const NamedArray* markers = message.Find("drawMarkers")) {
    reply.draw_markers = ReadMarkers(*markers, reader);
  }
  reply.pictures = ReadPictureWishes(message, aux, reader);
  if (const NamedArray* watch = message.Find("watch")) {
    reply.watch = ReadWatch(*watch, aux, reader);
  }
  reply.notes = ReadNotes(message, reply.pictures.cameras, reader);
  if (!reader.ok()) return reader.error();
  return reply;
}

std::variant<StepReply, WireError> DecodeStepReply(const Message& message,
                                                   std::span<const ArmDescription> arms,
                                                   std::span<const std::string> cameras) {
  MatrixReader reader("motor."), aux_reader("aux.");
  MotorReader motor(arms, &reader);
  StepReply reply;
  // The end of a brain is a type of message, not a field: a client cannot forget to reset it.
  reply.exit = message.type == MessageType::kFinalMotor;
  // Unknown fields are errors, so that misspelled ones are noticed.
  for (const NamedArray& field : message.arrays) {
    if (field.name == "drawMarkers") {
      reply.draw_markers = ReadMarkers(field, aux_reader);
    } else if (field.name == "imageSeconds") {
      reply.image_seconds = ReadImageSeconds(field, aux_reader);
    } else if (field.name == "cameras") {
      reply.cameras = ReadCamerasOf(field, cameras, aux_reader);
    } else if (field.name == "claim" && reply.exit) {
      reply.claim = ReadClaim(field, aux_reader);
    } else if (IsOfNotes(field)) {
      reply.notes = ReadNotes(message, cameras, aux_reader);
    } else {
      motor.Take(field);
    }
  }
  motor.Finish(&reply);
  if (!reader.ok()) return reader.error();
  if (!aux_reader.ok()) return aux_reader.error();
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
  // Cuts by bytes. A cut within a multi-byte letter leaves an incomplete one at the end, which
  // terminals show as a placeholder.
  std::string printable(text.substr(0, max_letters));
  for (char& letter : printable) {
    const auto code = static_cast<unsigned char>(letter);
    // Control characters could change the state of a terminal.
    if ((code < 0x20 && letter != '\t') || code == 0x7f) letter = letter == '\n' ? ' ' : '?';
  }
  if (text.size() > max_letters) printable += "...";
  return printable;
}

}  // namespace smile::brain
