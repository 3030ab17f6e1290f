#include "record/recording.h"

#include <algorithm>
#include <array>

#include "base/diagnostic.h"
#include "base/files.h"
#include "base/json.h"
#include "base/version.h"
#include "base/wording.h"
#include "record/append_file.h"
#include "record/trace_reader.h"
#include "robot/urdf_reader.h"
#include "scene_xml/scene_reader.h"

namespace smile::record {
namespace {

constexpr std::size_t kMaxInfoBytes = 64u << 10;
/// Nobody begins a recording after more than a month.
constexpr double kMaxStartTick = 31.0 * 86400 * sim::kTicksPerSecond;

constexpr std::array kOriginNames = {"recorded", "edited", "imported"};

Origin ParseOrigin(const std::string& name) {
  for (std::size_t i = 0; i < kOriginNames.size(); ++i) {
    if (name == kOriginNames[i]) return static_cast<Origin>(i);
  }
  throw std::invalid_argument("\"origin\" is \"" + name +
                              "\", expected recorded, edited or imported");
}

Json ToJson(const CameraView& view) {
  const CameraIntrinsics& intrinsics = view.intrinsics;
  const Vector3& p = view.X_WC.translation();
  const Quaternion q = view.X_WC.quaternion();
  return {{"width_px", intrinsics.width_px},
          {"height_px", intrinsics.height_px},
          {"fx", intrinsics.fx},
          {"fy", intrinsics.fy},
          {"cx", intrinsics.cx},
          {"cy", intrinsics.cy},
          {"position_m", {p.x(), p.y(), p.z()}},
          {"rotation_wxyz", {q.w(), q.x(), q.y(), q.z()}}};
}

CameraView ParseView(const Json& json) {
  CameraView view;
  view.intrinsics.width_px = json.at("width_px");
  view.intrinsics.height_px = json.at("height_px");
  view.intrinsics.fx = json.at("fx");
  view.intrinsics.fy = json.at("fy");
  view.intrinsics.cx = json.at("cx");
  view.intrinsics.cy = json.at("cy");
  const auto p = json.at("position_m").get<std::array<double, 3>>();
  const auto q = json.at("rotation_wxyz").get<std::array<double, 4>>();
  view.X_WC =
      RigidTransform(Quaternion(q[0], q[1], q[2], q[3]).normalized(), Vector3(p[0], p[1], p[2]));
  return view;
}

/// Recordings of ordinary robots say nothing of their bodies.
Json ToJson(const RobotInfo& info) {
  Json json = {{"name", info.name},
               {"gap_m", info.gap},
               {"height_m", info.height},
               {"urdf", info.urdf},
               {"gripper", info.gripper}};
  if (info.body.is_kinematic) json["kinematic"] = true;
  if (info.body.grasps_by_friction) json["friction_grasp"] = true;
  return json;
}

RobotInfo ParseRobot(const Json& json) {
  return {.name = json.at("name"),
          .gap = json.at("gap_m"),
          .height = json.at("height_m"),
          .urdf = json.value("urdf", kOldRobotFile),
          .gripper = json.value("gripper", ""),
          .body = {.is_kinematic = json.value("kinematic", false),
                   .grasps_by_friction = json.value("friction_grasp", false)}};
}

void CheckInfo(const DemoInfo& info) {
  const auto check = [](const char* key, double value, double low, double high) {
    if (value >= low && value <= high) return;
    throw std::invalid_argument("\"" + std::string(key) + "\" is " + NumberText(value) +
                                ", expected " + NumberText(low) + " to " + NumberText(high));
  };
  check("meters_per_unit", info.meters_per_unit, 1e-9, 1e9);
  check("frames_per_second", info.frames_per_second, 1e-6, sim::kTicksPerSecond);
  check("tick", static_cast<double>(info.start.tick), 0, kMaxStartTick);
  if (info.robot) {
    check("gap_m", info.robot->gap, -100, 100);
    check("height_m", info.robot->height, -100, 100);
    const std::filesystem::path urdf = info.robot->urdf;
    const bool is_inside =
        urdf == kOldRobotFile ||
        (urdf.parent_path() == kRobotFolder && urdf.has_filename() && urdf.filename() != "..");
    if (!is_inside) {
      throw std::invalid_argument("\"urdf\" is " + Quoted(info.robot->urdf) +
                                  ", expected a file in " + kRobotFolder + "/");
    }
    if (info.robot->body.is_kinematic && info.robot->body.grasps_by_friction) {
      throw std::invalid_argument("\"kinematic\" and \"friction_grasp\" exclude each other");
    }
  }
  if (!info.eye) return;
  check("width_px", info.eye->intrinsics.width_px, 1, 8192);
  check("height_px", info.eye->intrinsics.height_px, 1, 8192);
  if (info.eye_camera != sim::kEyeCamera && info.eye_camera != sim::kHeadCamera) {
    throw std::invalid_argument("\"camera\" is " + Quoted(info.eye_camera) +
                                ", expected \"eye\" or \"head\"");
  }
}

DemoInfo ReadInfo(const std::filesystem::path& path) {
  const std::string text = ReadFile(path, kMaxInfoBytes);
  try {
    const Json json = ParseJson(text);
    DemoInfo info{.format = json.at("format"), .program = json.at("program")};
    if (info.format < kOldestFormatVersion || info.format > kFormatVersion) {
      throw InputError({path.string(), 1, "",
                        "\"format\" is " + std::to_string(info.format) + ", expected " +
                            std::to_string(kOldestFormatVersion) + " to " +
                            std::to_string(kFormatVersion) + " (made by " + info.program + ")"});
    }
    info.scene = json.at("scene");
    info.title = json.at("title");
    info.notes = json.at("notes");
    info.meters_per_unit = json.at("meters_per_unit");
    info.frames_per_second = json.at("frames_per_second");
    if (info.format >= 2) {
      info.origin = ParseOrigin(json.at("origin"));
      info.start = {.line = json.at("start").at("line"), .tick = json.at("start").at("tick")};
      info.has_symbols = json.at("has_symbols");
    }
    if (const Json& robot = json.at("robot"); !robot.is_null()) {
      info.robot = ParseRobot(robot);
    }
    if (const Json& eye = json.at("eye"); !eye.is_null()) {
      info.eye = ParseView(eye);
      // There was only one camera once.
      info.eye_camera = eye.value("camera", sim::kEyeCamera);
    }
    CheckInfo(info);
    return info;
  } catch (const Json::exception& error) {  // a key is missing or of another type
    throw InputError({path.string(), 1, "", std::string("is not a recording's: ") + error.what()});
  } catch (const std::invalid_argument& error) {
    throw InputError({path.string(), 1, "", error.what()});
  }
}

/// The last undo, redo or checkout is in the log before it is in the trace. What ended the program
/// between the two undid it.
void LeaveOutUnfinishedReturn(Recording* recording) {
  const auto& lines = recording->log.lines();
  if (lines.empty() || !std::holds_alternative<Return>(lines.back().what)) return;
  if (TraceReader(*recording).last_return() >= lines.size()) return;
  recording->cuts.push_back("the last " +
                            std::string(ToString(std::get<Return>(lines.back().what).kind)) +
                            " was cut and is left out");
  recording->log.RemoveLast();
}

bool IsWithin(const std::filesystem::path& path, const std::filesystem::path& folder) {
  return std::mismatch(folder.begin(), folder.end(), path.begin(), path.end()).first ==
         folder.end();
}

/// From the folder of its URDF and from nowhere else, links followed; neither may that folder be a
/// link that leads out of the recording.
/// @param name  of the URDF, from the recording's directory.
robot::RobotReading ReadKeptRobot(const std::filesystem::path& directory, const std::string& name,
                                  const std::string& gripper) {
  const std::filesystem::path urdf = directory / name;
  std::error_code error;
  const auto root = std::filesystem::canonical(directory, error);
  if (error) throw InputError({directory.string(), 0, "", "no such folder"});
  const auto folder = std::filesystem::canonical(urdf.parent_path(), error);
  if (error) throw InputError({urdf.string(), 0, "", "no such file"});
  if (!IsWithin(folder, root)) {
    throw InputError({urdf.string(), 0, "", "lies elsewhere, expected it in the recording"});
  }
  const auto open = [&folder](const std::string& file,
                              std::size_t max_bytes) -> std::optional<std::string> {
    std::error_code missing;
    const auto path = std::filesystem::canonical(folder / file, missing);
    if (missing || !IsWithin(path, folder)) return std::nullopt;
    return ReadFile(path, max_bytes);
  };
  return robot::LoadKeptRobot(urdf, gripper, open);
}

/// What was commanded before the demonstration is fixed: nothing leads back to it.
void CheckStart(const Recording& recording) {
  const Moment& start = recording.info.start;
  const auto& lines = recording.log.lines();
  const auto fail = [&recording](const std::string& message) {
    throw InputError({(recording.directory / "demo.json").string(), 1, "", message});
  };
  if (start.line > lines.size()) fail("\"start\" is behind the end of commands.jsonl");
  if (recording.log.After(start.line).tick > start.tick) {
    fail("\"start\" is tick " + std::to_string(start.tick) + ", but its line is later");
  }
  for (std::size_t line = 1; line <= lines.size(); ++line) {
    const auto* back = std::get_if<Return>(&lines[line - 1].what);
    const bool is_before = line <= start.line;
    if (back != nullptr &&
        (is_before || back->to.line < start.line || back->to.tick < start.tick)) {
      throw InputError({(recording.directory / "commands.jsonl").string(), static_cast<int>(line),
                        "", "leads back to before the start of the demonstration"});
    }
    if (!is_before && lines[line - 1].tick < start.tick) {
      throw InputError({(recording.directory / "commands.jsonl").string(), static_cast<int>(line),
                        "", "is before the start of the demonstration"});
    }
  }
}

void CheckLength(const char* key, const std::string& text, std::size_t max_bytes) {
  if (text.size() <= max_bytes) return;
  throw std::invalid_argument("\"" + std::string(key) + "\" has " + std::to_string(text.size()) +
                              " bytes, expected at most " + std::to_string(max_bytes));
}

}  // namespace

std::string ToJsonText(const DemoInfo& info) {
  Json robot, eye;
  if (info.robot) robot = ToJson(*info.robot);
  if (info.eye) {
    eye = ToJson(*info.eye);
    eye["camera"] = info.eye_camera;
  }
  const Json json = {{"format", info.format},
                     {"program", info.program.empty() ? ProgramName() : info.program},
                     {"scene", info.scene},
                     {"title", info.title},
                     {"notes", info.notes},
                     {"meters_per_unit", info.meters_per_unit},
                     {"ticks_per_second", sim::kTicksPerSecond},
                     {"origin", kOriginNames[static_cast<std::size_t>(info.origin)]},
                     {"start", {{"line", info.start.line}, {"tick", info.start.tick}}},
                     {"frames_per_second", info.frames_per_second},
                     {"has_symbols", info.has_symbols},
                     {"robot", robot},
                     {"eye", eye}};
  return ToText(json, 2) + "\n";
}

DemoInfo ReadDemoInfo(const std::filesystem::path& directory) {
  return ReadInfo(directory / "demo.json");
}

void CheckTitle(const std::string& title) { CheckLength("title", title, kMaxTitleBytes); }

void Retitle(const std::filesystem::path& directory, const std::optional<std::string>& title,
             const std::optional<std::string>& notes) {
  (void)ReadDemoInfo(directory);
  const AppendFile hold(directory / "commands.jsonl", AppendFile::kExisting);
  const std::filesystem::path path = directory / "demo.json";
  Json json = ParseJson(ReadFile(path, kMaxInfoBytes));
  if (title) {
    CheckTitle(*title);
    json["title"] = *title;
  }
  if (notes) {
    CheckLength("notes", *notes, kMaxNotesBytes);
    json["notes"] = *notes;
  }
  WriteFile(path, ToText(json, 2) + "\n");
}

bool IsRecording(const std::filesystem::path& directory) {
  std::error_code error;
  return std::filesystem::is_directory(directory, error) &&
         std::filesystem::exists(directory / "demo.json", error);
}

std::optional<std::filesystem::path> RecordingAround(const std::filesystem::path& path) {
  std::error_code error;
  std::filesystem::path around = std::filesystem::weakly_canonical(path, error);
  while (!error && around.has_relative_path()) {
    around = around.parent_path();
    if (IsRecording(around)) return around;
  }
  return std::nullopt;
}

Recording OpenRecording(const std::filesystem::path& directory) {
  if (!IsRecording(directory)) {
    throw InputError({directory.string(), 0, "",
                      "is not a recording; expected a directory with a demo.json in it"});
  }
  Recording recording{.directory = directory, .info = ReadInfo(directory / "demo.json")};
  recording.scene = scene_xml::LoadScene(directory / "scene.xml");
  recording.scene.name = recording.info.scene;
  if (const auto& robot = recording.info.robot) {
    robot::RobotReading reading = ReadKeptRobot(directory, robot->urdf, robot->gripper);
    recording.robot = sim::RobotPlacement{.model = std::move(reading.model),
                                          .gripper = std::move(reading.gripper),
                                          .files = std::move(reading.files),
                                          .gap = robot->gap,
                                          .height = robot->height,
                                          .body = robot->body};
  }
  std::optional<std::string> cut;
  recording.log =
      ReadCommandLog(directory / "commands.jsonl", recording.scene.meters_per_unit, &cut);
  if (cut) recording.cuts.push_back(*cut);
  LeaveOutUnfinishedReturn(&recording);
  CheckStart(recording);
  recording.commands = recording.log.WayTo(recording.log.lines().size());
  return recording;
}

}  // namespace smile::record
