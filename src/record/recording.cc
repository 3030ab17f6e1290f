#include "record/recording.h"

#include "base/diagnostic.h"
#include "base/files.h"
#include "base/json.h"
#include "base/version.h"
#include "base/wording.h"
#include "robot/urdf_reader.h"
#include "scene_xml/scene_reader.h"
#include "sim/command_json.h"

namespace smile::record {
namespace {

constexpr std::size_t kMaxInfoBytes = 64u << 10;
constexpr std::size_t kMaxLineBytes = 64u << 10;
constexpr std::size_t kMaxCommandBytes = std::size_t{1} << 30;

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

void CheckInfo(const DemoInfo& info) {
  const auto check = [](const char* key, double value, double low, double high) {
    if (value >= low && value <= high) return;
    throw std::invalid_argument("\"" + std::string(key) + "\" is " + NumberText(value) +
                                ", expected " + NumberText(low) + " to " + NumberText(high));
  };
  check("meters_per_unit", info.meters_per_unit, 1e-9, 1e9);
  check("frames_per_second", info.frames_per_second, 1e-6, sim::kTicksPerSecond);
  if (info.robot) {
    check("gap_m", info.robot->gap, -100, 100);
    check("height_m", info.robot->height, -100, 100);
  }
  if (!info.eye) return;
  check("width_px", info.eye->intrinsics.width_px, 1, 8192);
  check("height_px", info.eye->intrinsics.height_px, 1, 8192);
}

DemoInfo ReadInfo(const std::filesystem::path& path) {
  const std::string text = ReadFile(path, kMaxInfoBytes);
  try {
    const Json json = ParseJson(text);
    DemoInfo info{.format = json.at("format"), .program = json.at("program")};
    if (info.format != kFormatVersion) {
      throw InputError({path.string(), 1, "",
                        "\"format\" is " + std::to_string(info.format) + ", expected " +
                            std::to_string(kFormatVersion) + " (made by " + info.program + ")"});
    }
    info.scene = json.at("scene");
    info.title = json.at("title");
    info.notes = json.at("notes");
    info.meters_per_unit = json.at("meters_per_unit");
    info.frames_per_second = json.at("frames_per_second");
    if (const Json& robot = json.at("robot"); !robot.is_null()) {
      info.robot = RobotInfo{robot.at("name"), robot.at("gap_m"), robot.at("height_m")};
    }
    if (const Json& eye = json.at("eye"); !eye.is_null()) info.eye = ParseView(eye);
    CheckInfo(info);
    return info;
  } catch (const Json::exception& error) {  // a key is missing or of another type
    throw InputError({path.string(), 1, "", std::string("is not a recording's: ") + error.what()});
  } catch (const std::invalid_argument& error) {
    throw InputError({path.string(), 1, "", error.what()});
  }
}

std::vector<LoggedCommand> ReadCommands(const std::filesystem::path& path, double meters_per_unit,
                                        std::vector<std::string>* cuts) {
  const std::string text = ReadFile(path, kMaxCommandBytes);
  std::vector<LoggedCommand> commands;
  std::vector<Diagnostic> findings;
  std::size_t start = 0;
  for (int line = 1; start < text.size(); ++line) {
    const std::size_t end = text.find('\n', start);
    if (end == std::string::npos) {
      cuts->push_back("the last line of commands.jsonl was cut and is left out");
      break;
    }
    try {
      if (end - start > kMaxLineBytes)
        throw std::invalid_argument("this line is longer than 64 KiB");
      const Json json = ParseJson(std::string_view(text).substr(start, end - start));
      LoggedCommand logged{.command = sim::ParseCommand(json, meters_per_unit)};
      const auto tick = sim::ParseTick(json);
      if (!tick) throw std::invalid_argument("\"tick\" is missing, expected when it was applied");
      logged.tick = *tick;
      if (!commands.empty() && logged.tick < commands.back().tick) {
        throw std::invalid_argument("\"tick\" goes back, expected at least " +
                                    std::to_string(commands.back().tick));
      }
      commands.push_back(std::move(logged));
    } catch (const std::exception& error) {  // of the JSON library or ours
      findings.push_back({path.string(), line, "", error.what()});
    }
    start = end + 1;
  }
  if (!findings.empty()) throw InputError(std::move(findings));
  return commands;
}

}  // namespace

std::string ToJsonText(const DemoInfo& info) {
  Json robot, eye;
  if (info.robot) {
    robot = {
        {"name", info.robot->name}, {"gap_m", info.robot->gap}, {"height_m", info.robot->height}};
  }
  if (info.eye) eye = ToJson(*info.eye);
  const Json json = {{"format", info.format},
                     {"program", info.program.empty() ? ProgramName() : info.program},
                     {"scene", info.scene},
                     {"title", info.title},
                     {"notes", info.notes},
                     {"meters_per_unit", info.meters_per_unit},
                     {"ticks_per_second", sim::kTicksPerSecond},
                     {"frames_per_second", info.frames_per_second},
                     {"robot", robot},
                     {"eye", eye}};
  return ToText(json, 2) + "\n";
}

bool IsRecording(const std::filesystem::path& directory) {
  std::error_code error;
  return std::filesystem::is_directory(directory, error) &&
         std::filesystem::exists(directory / "demo.json", error);
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
    const auto urdf = directory / kRobotFile;
    recording.robot = sim::RobotPlacement{
        .model = robot::ReadRobot(urdf), .urdf = urdf, .gap = robot->gap, .height = robot->height};
  }
  recording.commands =
      ReadCommands(directory / "commands.jsonl", recording.scene.meters_per_unit, &recording.cuts);
  return recording;
}

}  // namespace smile::record
