#include "recording/recording.h"

#include <system_error>
#include <utility>

#include "base/diagnostic.h"
#include "base/files.h"
#include "image/png.h"
#include "recording/beginning.h"
#include "recording/segment_files.h"
#include "recording/trace_reader.h"
#include "robot/urdf_reader.h"
#include "scene_xml/scene_reader.h"
#include "sim/spawning.h"

// Opens a recording: reads its files in the order of their dependence, checks that they fit each
// other, and drops what an interrupted program left unfinished. Files are untrusted: recordings are
// shared.

namespace smile::recording {
namespace {

/// Drops a last undo, redo or checkout that is in the log but not in the trace. The log is written
/// first; a program that died between the two writes has not carried it out.
void LeaveOutUnfinishedReturn(Recording* recording) {
  const auto& lines = recording->log.lines();
  if (lines.empty() || !std::holds_alternative<Return>(lines.back().what)) return;
  if (TraceReader(*recording).last_return() >= lines.size()) return;
  recording->cuts.push_back("the last " +
                            std::string(ToString(std::get<Return>(lines.back().what).kind)) +
                            " was cut and is skipped");
  recording->log.RemoveLast();
}

/// Reads the robot of a recording, from the folder of its URDF only. Links are resolved first, so
/// that neither a file nor the folder itself can lead out of the recording.
/// @param name  of the URDF, from the recording's directory.
robot::RobotReading ReadKeptRobot(const std::filesystem::path& directory, const std::string& name,
                                  const std::string& gripper) {
  const std::filesystem::path urdf = directory / name;
  std::error_code error;
  const auto folder = std::filesystem::canonical(urdf.parent_path(), error);
  if (error) throw InputError({urdf.string(), 0, "", "no such file"});
  if (!IsWithin(folder, directory)) {
    throw InputError({urdf.string(), 0, "", "is outside the recording, expected inside"});
  }
  // Opens a file that the URDF refers to, such as a mesh; nullopt if it is missing or lies
  // elsewhere.
  const auto open = [&folder](const std::string& file,
                              std::size_t max_bytes) -> std::optional<std::string> {
    std::error_code missing;
    const auto path = std::filesystem::canonical(folder / file, missing);
    if (missing || !IsWithin(path, folder)) return std::nullopt;
    return ReadFile(path, max_bytes);
  };
  return robot::LoadKeptRobot(urdf, gripper, open);
}

/// Checks that the eye in `demo.json` has the size of the pictures, since programs that continue or
/// learn from a recording rely on it.
void CheckEye(const Recording& recording) {
  const auto& eye = recording.info.eye;
  const auto picture = SegmentPictures(recording.directory, 0) / "0.png";
  std::error_code error;
  if (!eye || !std::filesystem::is_regular_file(picture, error)) return;
  const std::optional<PngSize> size = ReadPngSize(picture);
  if (!size) throw InputError({picture.string(), 0, "", "is not a picture, expected a PNG"});
  const auto [width, height] = std::pair(eye->intrinsics.width_px, eye->intrinsics.height_px);
  if (size->width_px == width && size->height_px == height) return;
  const auto text = [](int x, int y) { return std::to_string(x) + "x" + std::to_string(y); };
  throw InputError({(recording.directory / "demo.json").string(), 0, "eye",
                    "is of " + text(width, height) + " pixels, expected " +
                        text(size->width_px, size->height_px) + " as " + picture.string()});
}

/// Checks that `start` lies in the log, and that no line after it leads to a point before it: the
/// actions before the demonstration are fixed.
void CheckStart(const Recording& recording) {
  const HistoryPoint& start = recording.info.start;
  const auto& lines = recording.log.lines();
  const auto fail = [&recording](const std::string& message) {
    throw InputError({(recording.directory / "demo.json").string(), 1, "", message});
  };
  if (start.line > lines.size()) fail("\"start\" is after the end of commands.jsonl");
  if (recording.log.After(start.line).tick > start.tick) {
    fail("\"start\" is tick " + std::to_string(start.tick) + ", but its line is later");
  }
  for (std::size_t line = 1; line <= lines.size(); ++line) {
    const auto* back = std::get_if<Return>(&lines[line - 1].what);
    const bool is_before = line <= start.line;
    if (back != nullptr &&
        (is_before || back->to.line < start.line || back->to.tick < start.tick)) {
      throw InputError({(recording.directory / "commands.jsonl").string(), static_cast<int>(line),
                        "", "returns to a moment before the start of the demonstration"});
    }
    if (!is_before && lines[line - 1].tick < start.tick) {
      throw InputError({(recording.directory / "commands.jsonl").string(), static_cast<int>(line),
                        "", "is before the start of the demonstration"});
    }
  }
}

/// Compiles the model of scene and robot as recorded in the directory.
std::shared_ptr<const model::Model> ModelOf(const std::filesystem::path& directory,
                                            const DemoInfo& info) {
  // The name is that of the original scene; the file here is always scene.xml.
  scene::SceneSpec scene = scene_xml::LoadScene(directory / "scene.xml");
  scene.name = info.scene;
  scene.physics_version = info.physics_version;
  std::optional<model::RobotPlacement> placement;
  if (const auto& robot = info.robot) {
    robot::RobotReading reading = ReadKeptRobot(directory, robot->urdf, robot->gripper);
    placement = model::RobotPlacement{.model = std::move(reading.model),
                                      .gripper = std::move(reading.gripper),
                                      .files = std::move(reading.files),
                                      .gap = robot->gap,
                                      .height = robot->height,
                                      .body = robot->body};
  }
  return std::make_shared<const model::Model>(std::move(scene), std::move(placement));
}

}  // namespace

scene::SceneSpec SceneAfter(const Recording& recording, std::size_t line) {
  scene::SceneSpec scene = recording.start_scene();
  for (const LoggedCommand& logged : recording.log.PathTo(line)) {
    const auto* spawn = std::get_if<sim::Spawn>(&logged.command);
    if (spawn == nullptr) continue;
    sim::Refusal refusal;
    auto grown = sim::WithSpawned(scene, *spawn, &refusal);
    // A command that succeeded when it was recorded: the log or the scene has been changed.
    if (!grown) {
      throw InputError({(recording.directory / "commands.jsonl").string(),
                        static_cast<int>(logged.line), "", refusal});
    }
    scene = *std::move(grown);
  }
  return scene;
}

std::string NameOf(const Recording& recording) {
  // The path may be relative, or end with a slash.
  const auto path = std::filesystem::absolute(recording.directory).lexically_normal();
  return path.has_filename() ? path.filename() : path.parent_path().filename();
}

std::string TitleOf(const Recording& recording) {
  return recording.info.title.empty() ? NameOf(recording) : recording.info.title;
}

std::string CorrectedTitleOf(const Recording& recording) {
  return TitleOf(recording) + " (corrected)";
}

bool IsRecording(const std::filesystem::path& directory) {
  std::error_code error;
  return std::filesystem::is_directory(directory, error) &&
         std::filesystem::exists(directory / "demo.json", error);
}

std::optional<std::filesystem::path> RecordingAround(const std::filesystem::path& path) {
  std::error_code error;
  // weakly_canonical resolves links and accepts a path that does not exist yet.
  std::filesystem::path around = std::filesystem::weakly_canonical(path, error);
  while (!error && around.has_relative_path()) {
    around = around.parent_path();
    if (IsRecording(around)) return around;
  }
  return std::nullopt;
}

Recording OpenRecording(const std::filesystem::path& directory) {
  if (IsAbandoned(directory)) {
    throw InputError({directory.string(), 0, "",
                      "contains no recording: the program was killed before the recording began; a "
                      "new recording can replace it"});
  }
  if (!IsRecording(directory)) {
    throw InputError({directory.string(), 0, "",
                      "is not a recording; expected a directory with a demo.json in it"});
  }
  // The order matters: the log is parsed in units of the scene; the trace reader needs log and
  // model; the path is known only after an unfinished return has been dropped.
  Recording recording{.directory = directory, .info = ReadDemoInfo(directory / "demo.json")};
  recording.start_model = recording.model = ModelOf(directory, recording.info);
  CheckEye(recording);
  std::optional<std::string> cut;
  recording.log =
      ReadCommandLog(directory / "commands.jsonl", recording.scene().meters_per_unit, &cut);
  if (cut) recording.cuts.push_back(*cut);
  LeaveOutUnfinishedReturn(&recording);
  CheckStart(recording);
  recording.commands = recording.log.PathTo(recording.log.lines().size());
  scene::SceneSpec whole = SceneAfter(recording, recording.log.lines().size());
  // Objects that commands added on the path make a larger scene; most recordings share one model.
  if (whole != recording.start_scene()) {
    recording.model = std::make_shared<const model::Model>(std::move(whole), recording.robot());
  }
  return recording;
}

}  // namespace smile::recording
