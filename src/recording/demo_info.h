#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "math/camera_projection.h"
#include "recording/command_log.h"
#include "scene/scene_spec.h"
#include "scene/units.h"
#include "sim/eye.h"
#include "sim/simulation.h"

namespace smile::recording {

/// Version that is written; all versions from kOldestFormatVersion on can be read.
inline constexpr int kFormatVersion = 3, kOldestFormatVersion = 1;
/// Folder in a recording with all files that its robot was read from.
inline constexpr const char* kRobotFolder = "robot";
/// Robot file of recordings older than the folder, with its side file beside it.
inline constexpr const char* kOldRobotFile = "robot.urdf";

/// Origin of a recording.
enum class Origin {
  kRecorded,  ///< a simulation
  kEdited,    ///< another recording, and a simulation
  kImported,  ///< a classic recording: poses without commands
};

/// Appearance of the demonstrator in pictures.
enum class DemonstratorAppearance {
  kInvisible,  ///< not visible; only its effects are
  kGhost,      ///< translucent hands
  kForearm,    ///< hands and arms of a person, which occlude objects behind them
};
inline constexpr std::array<std::string_view, 3> kDemonstratorAppearances{"invisible", "ghost",
                                                                          "forearm"};
/// Returns `invisible`, `ghost` or `forearm`.
std::string_view ToString(DemonstratorAppearance appearance);
/// Parses the text of ToString().
/// @throws std::invalid_argument with what was found and expected.
DemonstratorAppearance ParseDemonstratorAppearance(std::string_view text);

struct RobotInfo {
  std::string name;
  double gap = 0, height = 0;        ///< its place, see sim::RobotPlacement [m]
  std::string urdf = kOldRobotFile;  ///< from the recording's directory
  std::string gripper;               ///< see sim::RobotPlacement
  model::RobotBodyOptions body;

  bool operator==(const RobotInfo&) const = default;
};

/// What a recording corrects: it is the same as another one up to a moment, at which a user took
/// over.
struct Correction {
  std::string recording;  ///< name of the other recording's directory
  double seconds = 0;     ///< from the start of both demonstrations to that moment

  bool operator==(const Correction&) const = default;
};

/// Content of `demo.json`: description of a recording.
struct DemoInfo {
  int format = kFormatVersion;
  std::string program;  ///< that made it; empty = this one
  std::string scene;    ///< name
  std::string title, notes;
  double meters_per_unit = scene::kMetersPerUnit;
  int physics_version = scene::kPhysicsVersion;  ///< see SceneSpec; `physics`, absent = 1
  Origin origin = Origin::kRecorded;
  HistoryPoint start;              ///< actions before it are not part of the demonstration
  double frames_per_second = 4;    ///< of the classic view
  bool has_symbols = true;         ///< in the classic view
  std::optional<RobotInfo> robot;  ///< nullopt for a table without one
  std::optional<CameraView> eye;   ///< of the pictures; nullopt for text only
  std::string eye_camera = sim::kEyeCamera;  ///< which camera that is; see model::CameraNames()
  DemonstratorAppearance demonstrator = DemonstratorAppearance::kInvisible;  ///< in the pictures
  std::optional<Correction> corrects;

  bool operator==(const DemoInfo&) const = default;
};

std::string ToJsonText(const DemoInfo& info);

/// @throws InputError naming the place in the file, what was found and what was expected.
DemoInfo ReadDemoInfo(const std::filesystem::path& path);

inline constexpr std::size_t kMaxTitleBytes = 256, kMaxNotesBytes = 8 << 10;
/// Returns the message about a title that IsBlank().
texts::UserMessage BlankTitle();
/// True if a title is not empty but consists of white space.
bool IsBlank(std::string_view title);
/// Validates a title.
/// @throws std::invalid_argument if it is longer than kMaxTitleBytes or blank.
void CheckTitle(const std::string& title);

/// Changes title and notes of a recording; the rest of its `demo.json` stays as it is.
/// @param title, notes  nullopt: unchanged.
/// @throws std::invalid_argument if they are longer than kMaxTitleBytes and kMaxNotesBytes, or
///         the title is blank; InputError if it is no recording; std::runtime_error while it is
///         being recorded.
void Retitle(const std::filesystem::path& directory, const std::optional<std::string>& title,
             const std::optional<std::string>& notes);

}  // namespace smile::recording
