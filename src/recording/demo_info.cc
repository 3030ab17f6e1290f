#include "recording/demo_info.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <stdexcept>
#include <string_view>
#include <vector>

#include "base/diagnostic.h"
#include "base/files.h"
#include "base/json_node.h"
#include "base/version.h"
#include "base/wording.h"
#include "recording/append_file.h"

// `demo.json`: the facts about a recording, in formats of several versions. Unknown members are
// refused, since a program that does not know one could misread the recording.

namespace smile::recording {
namespace {

// The notes are the largest member, 8 kB.
constexpr std::size_t kMaxInfoBytes = 64u << 10;
/// Limits on the start of a recording, about a month of simulated time, to bound the work that a
/// damaged file can cause.
constexpr std::uint64_t kMaxStartTick = 31ull * 86400 * sim::kTicksPerSecond;
constexpr std::uint64_t kMaxStartLine = 1'000'000'000;
constexpr double kMaxSeconds = kMaxStartTick / static_cast<double>(sim::kTicksPerSecond);

constexpr std::array<std::string_view, 3> kOriginNames{"recorded", "edited", "imported"};

constexpr std::array<std::string_view, 16> kMembers{"format",
                                                    "program",
                                                    "scene",
                                                    "title",
                                                    "notes",
                                                    "meters_per_unit",
                                                    "ticks_per_second",
                                                    "physics",
                                                    "origin",
                                                    "start",
                                                    "frames_per_second",
                                                    "has_symbols",
                                                    "robot",
                                                    "eye",
                                                    "demonstrator",
                                                    "corrects"};
constexpr std::array<std::string_view, 2> kCorrectsMembers{"recording", "seconds"};
constexpr std::array<std::string_view, 2> kStartMembers{"line", "tick"};
constexpr std::array<std::string_view, 7> kRobotMembers{
    "name", "gap_m", "height_m", "urdf", "gripper", "kinematic", "friction_grasp"};
constexpr std::array<std::string_view, 9> kEyeMembers{
    "width_px", "height_px", "fx", "fy", "cx", "cy", "position_m", "rotation_wxyz", "camera"};

// Limit on the sides of pictures.
constexpr int kMaxSizePx = 8192;

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

/// Writes body options only if they are set, as files of older programs do.
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

Origin ReadOrigin(const JsonNode& node) {
  const std::string name = node.String();
  for (std::size_t i = 0; i < kOriginNames.size(); ++i) {
    // Names are in the order of the enumeration.
    if (name == kOriginNames[i]) return static_cast<Origin>(i);
  }
  node.Fail("found " + Quoted(name) + ", expected " + OneOf(kOriginNames));
}

CameraView ReadView(const JsonNode& node) {
  CameraView view;
  CameraIntrinsics& intrinsics = view.intrinsics;
  intrinsics.width_px = static_cast<int>(node.Member("width_px").Whole(1, kMaxSizePx));
  intrinsics.height_px = static_cast<int>(node.Member("height_px").Whole(1, kMaxSizePx));
  // Focal lengths are positive and finite; the principal point lies within the picture.
  intrinsics.fx = node.Member("fx").Number(1e-3, 1e9);
  intrinsics.fy = node.Member("fy").Number(1e-3, 1e9);
  intrinsics.cx = node.Member("cx").Number(0, intrinsics.width_px);
  intrinsics.cy = node.Member("cy").Number(0, intrinsics.height_px);
  const std::vector<JsonNode> p = node.Member("position_m").Items(3);
  const std::vector<JsonNode> q = node.Member("rotation_wxyz").Items(4);
  // A quaternion that is not of unit length is no rotation; rejected here, as normalizing would
  // hide a damaged file. The comparison is written so that NaN fails.
  const Quaternion q_WC(q[0].Number(-1, 1), q[1].Number(-1, 1), q[2].Number(-1, 1),
                        q[3].Number(-1, 1));
  if (!(std::abs(q_WC.norm() - 1) < 1e-6)) {
    node.Member("rotation_wxyz").Fail("its length is " + NumberText(q_WC.norm()) + ", expected 1");
  }
  view.X_WC = RigidTransform(
      q_WC.normalized(),
      Vector3(p[0].Number(-1e4, 1e4), p[1].Number(-1e4, 1e4), p[2].Number(-1e4, 1e4)));
  return view;
}

/// Returns the camera of the pictures. Files of old formats lack the member: they had only the
/// fixed eye.
std::string ReadEyeCamera(const JsonNode& eye) {
  if (!eye.Has("camera")) return sim::kEyeCamera;
  const std::string camera = eye.Member("camera").String();
  if (camera == sim::kEyeCamera || camera == sim::kHeadCamera) return camera;
  eye.Member("camera").Fail("found " + Quoted(camera) + ", expected eye or head");
}

/// Returns the path of the robot file relative to the recording; it must lie directly in the robot
/// folder, so that a recording cannot refer to files elsewhere.
std::string ReadUrdfName(const JsonNode& node) {
  // Recordings of old programs have the file at another place, kOldRobotFile.
  const std::filesystem::path urdf = node.String();
  const bool is_inside = urdf == kOldRobotFile || (urdf.parent_path() == kRobotFolder &&
                                                   urdf.has_filename() && urdf.filename() != "..");
  if (is_inside) return urdf;
  node.Fail("found " + Quoted(urdf.string()) + ", expected a file in " + kRobotFolder + "/");
}

RobotInfo ReadRobotInfo(const JsonNode& node) {
  node.ExpectMembers(kRobotMembers);
  RobotInfo info{.name = node.Member("name").String(),
                 .gap = node.Member("gap_m").Number(-100, 100),
                 .height = node.Member("height_m").Number(-100, 100)};
  if (node.Has("urdf")) info.urdf = ReadUrdfName(node.Member("urdf"));
  if (node.Has("gripper")) info.gripper = node.Member("gripper").String();
  const auto is_set = [&node](const char* flag) {
    return node.Has(flag) && node.Member(flag).Flag();
  };
  info.body = {.is_kinematic = is_set("kinematic"), .grasps_by_friction = is_set("friction_grasp")};
  if (info.body.is_kinematic && info.body.grasps_by_friction) {
    node.Fail("found both kinematic and friction_grasp, expected one at most");
  }
  return info;
}

/// Reads the members that format 2 introduced.
void ReadBeginning(const JsonNode& root, DemoInfo* info) {
  info->origin = ReadOrigin(root.Member("origin"));
  const JsonNode start = root.Member("start");
  start.ExpectMembers(kStartMembers);
  info->start = {.line = start.Member("line").Whole(0, kMaxStartLine),
                 .tick = start.Member("tick").Whole(0, kMaxStartTick)};
  info->has_symbols = root.Member("has_symbols").Flag();
}

Correction ReadCorrection(const JsonNode& node) {
  node.ExpectMembers(kCorrectsMembers);
  Correction correction{.recording = node.Member("recording").String(),
                        .seconds = node.Member("seconds").Number(0, kMaxSeconds)};
  // It is looked for beside the recording, so it must not lead elsewhere.
  const std::filesystem::path name = correction.recording;
  if (!name.has_filename() || name.filename() != name || name == "." || name == "..") {
    node.Member("recording").Fail("found " + Quoted(name.string()) + ", expected a name");
  }
  return correction;
}

DemonstratorAppearance ReadDemonstrator(const JsonNode& node) {
  try {
    return ParseDemonstratorAppearance(node.String());
  } catch (const std::invalid_argument& error) {
    node.Fail(error.what());
  }
}

DemoInfo ReadInfo(const JsonNode& root) {
  const JsonNode format = root.Member("format");
  const std::string program = root.Member("program").String();
  DemoInfo info{.format = static_cast<int>(format.Whole(0, 1'000'000)), .program = program};
  // The format is checked before any other member, since other formats may have other members.
  if (info.format < kOldestFormatVersion || info.format > kFormatVersion) {
    format.Fail("found " + std::to_string(info.format) + ", expected " +
                std::to_string(kOldestFormatVersion) + " to " + std::to_string(kFormatVersion) +
                " (made by " + Printable(program) + ")");
  }
  root.ExpectMembers(kMembers);
  info.scene = root.Member("scene").String();
  info.title = root.Member("title").String();
  info.notes = root.Member("notes").String();
  info.meters_per_unit = root.Member("meters_per_unit").Number(1e-9, 1e9);
  // The simulation has one tick rate; the member exists for readers of the file.
  if (root.Has("ticks_per_second")) {
    (void)root.Member("ticks_per_second").Number(sim::kTicksPerSecond, sim::kTicksPerSecond);
  }
  // Absent in recordings from before the physics had versions.
  info.physics_version =
      root.Has("physics")
          ? static_cast<int>(root.Member("physics").Whole(1, scene::kPhysicsVersion))
          : 1;
  info.frames_per_second = root.Member("frames_per_second").Number(1e-6, sim::kTicksPerSecond);
  // Recordings of format 1 begin with their simulation: line 0, tick 0.
  if (info.format >= 2) ReadBeginning(root, &info);
  if (const JsonNode robot = root.Member("robot"); !robot.IsNull()) {
    info.robot = ReadRobotInfo(robot);
  }
  if (const JsonNode eye = root.Member("eye"); !eye.IsNull()) {
    eye.ExpectMembers(kEyeMembers);
    info.eye = ReadView(eye);
    info.eye_camera = ReadEyeCamera(eye);
    if (info.eye_camera == sim::kHeadCamera && !info.robot) {
      eye.Member("camera").Fail("found head and no robot, expected eye");
    }
    if (root.Has("demonstrator")) info.demonstrator = ReadDemonstrator(root.Member("demonstrator"));
  } else if (root.Has("demonstrator")) {
    root.Member("demonstrator").Fail("found in a recording without pictures");
  }
  if (root.Has("corrects")) info.corrects = ReadCorrection(root.Member("corrects"));
  return info;
}

/// Throws std::invalid_argument if a text is longer than allowed.
void CheckLength(const char* key, const std::string& text, std::size_t max_bytes) {
  if (text.size() <= max_bytes) return;
  throw std::invalid_argument("\"" + std::string(key) + "\" has " + std::to_string(text.size()) +
                              " bytes, expected at most " + std::to_string(max_bytes));
}

}  // namespace

std::string_view ToString(DemonstratorAppearance appearance) {
  return kDemonstratorAppearances[static_cast<std::size_t>(appearance)];
}

DemonstratorAppearance ParseDemonstratorAppearance(std::string_view text) {
  const auto found = std::ranges::find(kDemonstratorAppearances, text);
  if (found != kDemonstratorAppearances.end()) {
    return static_cast<DemonstratorAppearance>(found - kDemonstratorAppearances.begin());
  }
  throw std::invalid_argument("demonstrator is " + Quoted(std::string(text)) + ", expected " +
                              OneOf(kDemonstratorAppearances));
}

std::string ToJsonText(const DemoInfo& info) {
  Json robot, eye;
  if (info.robot) robot = ToJson(*info.robot);
  if (info.eye) {
    eye = ToJson(*info.eye);
    eye["camera"] = info.eye_camera;
  }
  Json json = {{"format", info.format},
               {"program", info.program.empty() ? ProgramName() : info.program},
               {"scene", info.scene},
               {"title", info.title},
               {"notes", info.notes},
               {"meters_per_unit", info.meters_per_unit},
               {"ticks_per_second", sim::kTicksPerSecond},
               {"physics", info.physics_version},
               {"origin", kOriginNames[static_cast<std::size_t>(info.origin)]},
               {"start", {{"line", info.start.line}, {"tick", info.start.tick}}},
               {"frames_per_second", info.frames_per_second},
               {"has_symbols", info.has_symbols},
               {"robot", robot},
               {"eye", eye}};
  if (info.demonstrator != DemonstratorAppearance::kInvisible) {
    json["demonstrator"] = ToString(info.demonstrator);
  }
  if (info.corrects) {
    json["corrects"] = {{"recording", info.corrects->recording},
                        {"seconds", info.corrects->seconds}};
  }
  return ToText(json, 2) + "\n";
}

DemoInfo ReadDemoInfo(const std::filesystem::path& path) {
  const std::string file = path.string(), text = ReadFile(path, kMaxInfoBytes);
  try {
    const Json json = ParseJson(text);
    return ReadInfo(JsonNode(json, file, ""));
  } catch (const std::invalid_argument& error) {
    throw InputError({file, 0, "", error.what()});
  }
}

texts::UserMessage BlankTitle() { return texts::Say("recorder.blankTitle"); }

bool IsBlank(std::string_view title) {
  const auto is_space = [](unsigned char c) { return std::isspace(c) != 0; };
  return !title.empty() && std::ranges::all_of(title, is_space);
}

void CheckTitle(const std::string& title) {
  CheckLength("title", title, kMaxTitleBytes);
  if (IsBlank(title)) throw std::invalid_argument(BlankTitle());
}

void Retitle(const std::filesystem::path& directory, const std::optional<std::string>& title,
             const std::optional<std::string>& notes) {
  const std::filesystem::path path = directory / "demo.json";
  // Validates the file and then locks the log, so that a recording in progress cannot be changed.
  // The JSON is edited as it is, which keeps members of newer formats and their order.
  (void)ReadDemoInfo(path);
  const AppendFile hold(directory / "commands.jsonl", AppendFile::kExisting);
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

}  // namespace smile::recording
