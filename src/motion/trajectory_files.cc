// Trajectories as files: CSV as people edit it in spreadsheets, and JSON as ROS tools write it. The
// readers are strict, since a robot will execute what they return. CSV errors are collected for all
// lines, as people mend a table at once; JSON is written by programs, so its first error is enough.

#include "motion/trajectory_files.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <optional>
#include <stdexcept>
#include <utility>

#include "base/diagnostic.h"
#include "base/files.h"
#include "base/json.h"
#include "base/wording.h"
#include "motion/trajectory_shape.h"

namespace smile::motion {
namespace {

// Enough for kMaxTrajectoryPoints points of kMaxTrajectoryJoints joints; bounds memory and time.
constexpr std::size_t kMaxFileBytes = 32u << 20;
// A file of another kind would otherwise produce one finding per line.
constexpr std::size_t kMaxFindings = 100;
constexpr std::int64_t kNanoseconds = 1'000'000'000;

/// Splits a line at its commas and removes blanks around cells.
std::vector<std::string_view> CellsOf(std::string_view line) {
  std::vector<std::string_view> cells;
  for (std::size_t start = 0; start <= line.size();) {
    const std::size_t end = std::min(line.find(',', start), line.size());
    std::string_view cell = line.substr(start, end - start);
    while (!cell.empty() && (cell.front() == ' ' || cell.front() == '\t')) cell.remove_prefix(1);
    while (!cell.empty() && (cell.back() == ' ' || cell.back() == '\t')) cell.remove_suffix(1);
    cells.push_back(cell);
    start = end + 1;
  }
  return cells;
}

/// Returns the number that a whole cell spells, if it is within the bounds.
std::optional<double> NumberIn(std::string_view cell) {
  double number = 0;
  // from_chars() ignores the locale, in which 0,5 may be a number. The comparison below is false
  // for NaN, which from_chars() accepts.
  const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), number);
  const bool is_whole = error == std::errc() && end == cell.data() + cell.size();
  if (!is_whole || !(std::abs(number) <= kMaxTrajectoryNumber)) return std::nullopt;
  return number;
}

/// Reads CSV and collects the findings of all lines.
class CsvReader {
 public:
  explicit CsvReader(const std::string& file) : file_(file) {}

  JointTrajectory Read(std::string_view text) {
    // Spreadsheets may begin a table with the byte order mark of UTF-8.
    if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
    for (int line = 1; !text.empty() && findings_.size() < kMaxFindings && !is_full_; ++line) {
      const std::size_t end = std::min(text.find('\n'), text.size());
      std::string_view content = text.substr(0, end);
      text.remove_prefix(std::min(end + 1, text.size()));
      if (content.ends_with('\r')) content.remove_suffix(1);
      if (content.find_first_not_of(" \t") == std::string_view::npos) continue;
      if (!has_header_) {
        ReadHeader(CellsOf(content), line);
        // The points have no meaning without it.
        if (!findings_.empty()) break;
      } else {
        ReadPoint(CellsOf(content), line);
      }
    }
    if (findings_.empty() && trajectory_.points.empty()) {
      Note(0, has_header_ ? "no line follows the header, expected points"
                          : "the file is empty, expected a header like time,left_s0");
    }
    if (!findings_.empty()) throw InputError(std::move(findings_));
    SetVelocitiesFromPositions(&trajectory_);
    try {
      CheckShape(trajectory_);  // points may be too close in time for a bounded velocity
    } catch (const std::invalid_argument& error) {
      throw InputError({file_, 0, "", error.what()});
    }
    return std::move(trajectory_);
  }

 private:
  void ReadHeader(const std::vector<std::string_view>& cells, int line) {
    has_header_ = true;
    if (cells.front() != "time" || cells.size() < 2) {
      Note(line, "the header begins with " + Quoted(cells.front()) +
                     ", expected time and the names of joints: time,left_s0");
      return;
    }
    // Names are checked against no robot here: that is up to the command that executes the file.
    trajectory_.joint_names.assign(cells.begin() + 1, cells.end());
    if (std::string fault = FaultOfNames(trajectory_.joint_names); !fault.empty()) {
      Note(line, std::move(fault));
    }
  }

  void ReadPoint(const std::vector<std::string_view>& cells, int line) {
    const std::size_t expected = trajectory_.joint_names.size() + 1;
    if (cells.size() != expected) {
      return Note(line, "there are " + std::to_string(cells.size()) + " cells, expected " +
                            std::to_string(expected) + ", as in the header");
    }
    std::vector<double> numbers;
    for (const std::string_view cell : cells) {
      // One finding per line: a shifted line would give one per cell.
      const auto number = NumberIn(cell);
      if (!number)
        return Note(line, "found " + Quoted(cell) + ", expected a number of at most 1e6");
      numbers.push_back(*number);
    }
    const auto& points = trajectory_.points;
    if (std::string fault = FaultOfTime(numbers.front(), points.empty() ? nullptr : &points.back());
        !fault.empty()) {
      return Note(line, std::move(fault));
    }
    if (points.size() == kMaxTrajectoryPoints) {
      is_full_ = true;
      return Note(line, "there are more than " + std::to_string(kMaxTrajectoryPoints) + " points");
    }
    trajectory_.points.push_back(
        {.seconds = numbers.front(), .positions = {numbers.begin() + 1, numbers.end()}});
  }

  void Note(int line, std::string message) {
    findings_.push_back({file_, line, "", std::move(message)});
  }

  const std::string& file_;
  JointTrajectory trajectory_;
  std::vector<Diagnostic> findings_;
  bool has_header_ = false, is_full_ = false;
};

/// A JSON value with its path for messages. Its exceptions become an InputError.
class RosNode {
 public:
  RosNode(const Json& value, std::string place) : value_(value), place_(std::move(place)) {}

  RosNode Member(const char* key) const {
    if (!Has(key)) Fail("lacks \"" + std::string(key) + "\"");
    return {value_.at(key), place_.empty() ? key : place_ + "." + key};
  }
  bool Has(const char* key) const { return value_.is_object() && value_.contains(key); }
  // Unknown keys are errors: a misspelled "velocities" would silently become a motion without any.
  void ExpectKeys(std::initializer_list<const char*> keys) const {
    if (!value_.is_object()) Fail("is not an object");
    for (const auto& item : value_.items()) {
      const bool is_known =
          std::ranges::any_of(keys, [&](const char* known) { return item.key() == known; });
      if (!is_known) Fail("has an unknown key " + Quoted(item.key()));
    }
  }
  std::size_t size() const {
    if (!value_.is_array()) Fail("is not an array");
    return value_.size();
  }
  RosNode operator[](std::size_t i) const {
    return {value_.at(i), place_ + "[" + std::to_string(i) + "]"};
  }
  std::string Text() const {
    if (!value_.is_string()) Fail("is not a string");
    return value_.get<std::string>();
  }
  std::vector<double> Numbers() const {
    std::vector<double> numbers;
    for (std::size_t i = 0; i < size(); ++i) {
      if (!value_[i].is_number()) Fail("contains values other than numbers");
      numbers.push_back(value_[i].get<double>());
    }
    return numbers;
  }
  // Unsigned first: the library keeps negative and fractional numbers as other types, and numbers
  // beyond 2^63 would overflow in the cast.
  std::int64_t Whole(std::int64_t most) const {
    if (!value_.is_number_unsigned() ||
        value_.get<std::uint64_t>() > static_cast<std::uint64_t>(most)) {
      Fail("is not a whole number from 0 to " + std::to_string(most));
    }
    return value_.get<std::int64_t>();
  }
  [[noreturn]] void Fail(const std::string& message) const {
    throw std::invalid_argument((place_.empty() ? "the trajectory" : place_) + " " + message);
  }

 private:
  const Json& value_;
  std::string place_;
};

/// Returns a ROS time in seconds. Both parts are combined as an integer of nanoseconds, so that
/// there is only one rounding.
double SecondsIn(const RosNode& time) {
  time.ExpectKeys({"secs", "nsecs"});
  // Bounds first: the product of the largest allowed seconds and 1e9 fits into 64 bits.
  const std::int64_t whole =
      time.Member("secs").Whole(static_cast<std::int64_t>(kMaxTrajectorySeconds));
  const std::int64_t rest = time.Member("nsecs").Whole(kNanoseconds - 1);
  return static_cast<double>(whole * kNanoseconds + rest) / static_cast<double>(kNanoseconds);
}

/// Reads a point; accelerations and effort are accepted but ignored.
TrajectoryPoint PointIn(const RosNode& node) {
  node.ExpectKeys({"positions", "velocities", "accelerations", "effort", "time_from_start"});
  TrajectoryPoint point{.seconds = SecondsIn(node.Member("time_from_start")),
                        .positions = node.Member("positions").Numbers()};
  if (node.Has("velocities")) point.velocities = node.Member("velocities").Numbers();
  return point;
}

/// Reads a whole trajectory; computes velocities if no point has any.
JointTrajectory TrajectoryIn(const RosNode& root) {
  root.ExpectKeys({"header", "joint_names", "points"});
  JointTrajectory trajectory;
  const RosNode names = root.Member("joint_names"), points = root.Member("points");
  for (std::size_t i = 0; i < names.size(); ++i) {
    trajectory.joint_names.push_back(names[i].Text());
  }
  for (std::size_t i = 0; i < points.size(); ++i) {
    trajectory.points.push_back(PointIn(points[i]));
  }
  const bool has_velocities = std::ranges::any_of(
      trajectory.points, [](const auto& point) { return !point.velocities.empty(); });
  // Positions must be valid before velocities are computed from them.
  CheckShape(trajectory, has_velocities);
  if (!has_velocities) SetVelocitiesFromPositions(&trajectory);
  CheckShape(trajectory);
  return trajectory;
}

/// Returns a time as ROS writes it, rounded to nanoseconds.
Json RosTime(double seconds) {
  const std::int64_t nanoseconds = std::llround(seconds * static_cast<double>(kNanoseconds));
  return {{"secs", nanoseconds / kNanoseconds}, {"nsecs", nanoseconds % kNanoseconds}};
}

}  // namespace

std::string ToCsv(const JointTrajectory& trajectory) {
  std::string text = "time";
  for (const std::string& name : trajectory.joint_names) text += "," + name;
  for (const TrajectoryPoint& point : trajectory.points) {
    text += "\n" + NumberText(point.seconds);
    for (const double position : point.positions) text += "," + NumberText(position);
  }
  return text + "\n";
}

std::string ToRosJson(const JointTrajectory& trajectory) {
  Json points = Json::array();
  for (const TrajectoryPoint& point : trajectory.points) {
    points.push_back({{"positions", point.positions},
                      {"velocities", point.velocities},
                      // Empty arrays mean "not specified" in ROS.
                      {"accelerations", Json::array()},
                      {"effort", Json::array()},
                      {"time_from_start", RosTime(point.seconds)}});
  }
  const Json json = {
      // A stamp of zero means "now" to ROS controllers: begin on arrival.
      {"header", {{"seq", 0}, {"stamp", {{"secs", 0}, {"nsecs", 0}}}, {"frame_id", "base"}}},
      {"joint_names", trajectory.joint_names},
      {"points", std::move(points)}};
  return ToText(json) + "\n";
}

JointTrajectory ParseTrajectoryCsv(std::string_view text, const std::string& file) {
  return CsvReader(file).Read(text);
}

JointTrajectory ParseTrajectoryRosJson(std::string_view text, const std::string& file) {
  // Upper bound of keys: a point has five, its time two.
  constexpr int kMaxKeys = 7 * static_cast<int>(kMaxTrajectoryPoints) + 100;
  try {
    const Json json = ParseJson(text, kMaxKeys);
    return TrajectoryIn(RosNode(json, ""));
  } catch (const std::invalid_argument& error) {
    throw InputError({file, 0, "", error.what()});
  }
}

JointTrajectory ReadTrajectory(const std::filesystem::path& path) {
  const bool is_json = path.extension() == ".json";
  if (!is_json && path.extension() != ".csv") {
    throw InputError({path.string(), 0, "", "is not a trajectory file, expected .csv or .json"});
  }
  const std::string text = ReadFile(path, kMaxFileBytes);
  return (is_json ? ParseTrajectoryRosJson : ParseTrajectoryCsv)(text, path.string());
}

}  // namespace smile::motion
