#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "math/camera_projection.h"
#include "record/command_log.h"
#include "scene/scene_spec.h"
#include "sim/eye.h"
#include "sim/simulation.h"

namespace smile::record {

/// Written; those from kOldestFormatVersion on are read.
inline constexpr int kFormatVersion = 3, kOldestFormatVersion = 1;
/// The folder in a recording with all files its robot was read from.
inline constexpr const char* kRobotFolder = "robot";
/// Before there was the folder: the robot, its side file beside it.
inline constexpr const char* kOldRobotFile = "robot.urdf";

/// Where a recording comes from.
enum class Origin {
  kRecorded,  ///< a simulation
  kEdited,    ///< another recording, and a simulation
  kImported,  ///< a classic recording: what was seen, without commands
};

struct RobotInfo {
  std::string name;
  double gap = 0, height = 0;        ///< where it stands, see sim::RobotPlacement [m]
  std::string urdf = kOldRobotFile;  ///< from the recording's directory
  std::string gripper;               ///< see sim::RobotPlacement
  robot::RobotBodyOptions body;

  bool operator==(const RobotInfo&) const = default;
};

/// `demo.json`: what a recording is.
struct DemoInfo {
  int format = kFormatVersion;
  std::string program;  ///< that made it; empty = this one
  std::string scene;    ///< name
  std::string title, notes;
  double meters_per_unit = scene::kMetersPerUnit;
  Origin origin = Origin::kRecorded;
  Moment start;                    ///< what was done before is no part of the demonstration
  double frames_per_second = 4;    ///< of the classic view
  bool has_symbols = true;         ///< in the classic view
  std::optional<RobotInfo> robot;  ///< nullopt for a table without one
  std::optional<CameraView> eye;   ///< of the pictures; nullopt for text only
  std::string eye_camera = sim::kEyeCamera;  ///< which camera that is; see sim::CameraNames()

  bool operator==(const DemoInfo&) const = default;
};

std::string ToJsonText(const DemoInfo& info);

/// What a recording is, and nothing else of it: quick.
/// @throws InputError as OpenRecording().
DemoInfo ReadDemoInfo(const std::filesystem::path& directory);

inline constexpr std::size_t kMaxTitleBytes = 256, kMaxNotesBytes = 8 << 10;
/// @throws std::invalid_argument if it is longer than kMaxTitleBytes.
void CheckTitle(const std::string& title);

/// Says it otherwise; all else in `demo.json` stays as it is.
/// @param title, notes  nullopt: as they are.
/// @throws std::invalid_argument if they are longer than kMaxTitleBytes and kMaxNotesBytes;
///         InputError if it is no recording; std::runtime_error while it is being recorded.
void Retitle(const std::filesystem::path& directory, const std::optional<std::string>& title,
             const std::optional<std::string>& notes);

/// A recording, opened. It stands for itself: the scene file it was made from is not needed.
struct Recording {
  std::filesystem::path directory;
  DemoInfo info;
  scene::SceneSpec scene;
  std::optional<sim::RobotPlacement> robot;
  CommandLog log;  ///< the whole history
  /// The way the recording ends with, from the first tick of the simulation on, in order.
  std::vector<LoggedCommand> commands;
  /// What had to be left out, in words: a last line or tick cut by whatever ended the program.
  std::vector<std::string> cuts;
};

/// True when the directory looks like a recording.
bool IsRecording(const std::filesystem::path& directory);

/// The recording within whose directory a path lies, or would lie; nullopt if in none.
std::optional<std::filesystem::path> RecordingAround(const std::filesystem::path& path);

/// @throws InputError with all findings, each with its file.
Recording OpenRecording(const std::filesystem::path& directory);

}  // namespace smile::record
