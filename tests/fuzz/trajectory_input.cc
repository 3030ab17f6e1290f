#include "trajectory_input.h"

#include "base/diagnostic.h"
#include "motion/trajectory_files.h"
#include "motion/trajectory_shape.h"

namespace smile::fuzz {

motion::JointTrajectory ReadTrajectoryText(std::string_view text) {
  if (text.starts_with('{')) return motion::ParseTrajectoryRosJson(text, "f.json");
  return motion::ParseTrajectoryCsv(text, "f.csv");
}

std::string FaultWithTrajectory(std::string_view text) {
  motion::JointTrajectory trajectory;
  try {
    trajectory = ReadTrajectoryText(text);
  } catch (const InputError& error) {
    for (const Diagnostic& finding : error.diagnostics()) {
      if (finding.file.empty()) return "refused without a place";
      if (finding.message.empty()) return "refused without a reason";
    }
    return {};
  }
  motion::CheckShape(trajectory);
  try {
    const auto from_json =
        motion::ParseTrajectoryRosJson(motion::ToRosJson(trajectory), "own.json");
    if (from_json.points.back().positions != trajectory.points.back().positions) {
      return "comes back from JSON as another";
    }
  } catch (const InputError& error) {
    // Two times may be less than a nanosecond apart, which that format cannot say.
    if (std::string(error.what()).find("expected more than") == std::string::npos) {
      return std::string("its own JSON is refused: ") + error.what();
    }
  }
  const bool is_table = !text.starts_with('{');
  if (is_table && motion::ParseTrajectoryCsv(motion::ToCsv(trajectory), "own.csv") != trajectory) {
    return "comes back from its table as another";
  }
  return {};
}

}  // namespace smile::fuzz
