#include "sim/script.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <stdexcept>
#include <system_error>

#include "base/diagnostic.h"
#include "base/files.h"
#include "base/overloaded.h"
#include "base/wording.h"
#include "motion/trajectory_files.h"
#include "scene_xml/scene_reader.h"
#include "sim/command_json.h"
#include "sim/spawning.h"

// Scripts are lines of JSON, one command each, and three things that are no commands: waits,
// questions (`drag`, `add`), and names of files in place of inline content. All lines are read and
// checked before the first one runs.

namespace smile::sim {
namespace {

// Limits of input: size of a script, findings reported at once, and a day as the longest wait.
constexpr std::size_t kMaxBytes = 256u << 20;
constexpr std::size_t kMaxFindings = 100;
constexpr double kMaxWaitSeconds = 86400;
/// Limit for all trajectories from files together: each line that names a file keeps its points.
constexpr std::size_t kMaxPointsFromFiles = 1'000'000;
/// Ticks without motion, a quarter of a second, after which objects count as still.
constexpr int kStillTicks = kTicksPerSecond / 4;

/// Reads a wait line.
/// @throws std::invalid_argument with what was found and expected.
Wait ParseWait(const Json& json) {
  Wait wait;
  for (const auto& [key, value] : json.items()) {
    if (key != "do" && key != "tick" && key != "seconds" && key != "until") {
      throw std::invalid_argument("\"wait\" has an unknown key \"" + key + "\"");
    }
  }
  if (!json.contains("seconds") && !json.contains("until")) {
    throw std::invalid_argument("\"wait\" lacks \"seconds\" or \"until\"");
  }
  if (json.contains("seconds")) {
    const Json& seconds = json.at("seconds");
    if (!seconds.is_number() || !(seconds.get<double>() >= 0) ||
        seconds.get<double>() > kMaxWaitSeconds) {
      throw std::invalid_argument("\"seconds\" is " + ToText(seconds) +
                                  ", expected a number from 0 to 86400");
    }
    wait.seconds = seconds.get<double>();
  }
  if (json.contains("until")) {
    const Json& until = json.at("until");
    if (until == "arrived") {
      wait.until = Wait::Until::kArrived;
    } else if (until == "still") {
      wait.until = Wait::Until::kStill;
    } else {
      throw std::invalid_argument("\"until\" is " + ToText(until) +
                                  ", expected \"arrived\" or \"still\"");
    }
  }
  return wait;
}

/// Returns the names of objects that touch a held object or its assembly.
std::vector<std::string> NamesOfTouching(const Simulation& simulation, physics::BodyId held) {
  const physics::World& physics = simulation.physics();
  const std::vector<physics::BodyId> assembly = physics.Assembly(held);
  std::vector<physics::BodyId> touching;
  for (physics::BodyId member : assembly) {
    std::ranges::copy(physics.BodiesTouching(member), std::back_inserter(touching));
  }
  // Sorted by body, so that the message is the same in each run, and without duplicates.
  std::ranges::sort(touching);
  touching.erase(std::unique(touching.begin(), touching.end()), touching.end());
  std::vector<std::string> names;
  for (physics::BodyId body : touching) {
    if (std::ranges::binary_search(assembly, body)) continue;
    const world::Object* object = simulation.tabletop().Find(body);
    names.push_back(object != nullptr ? world::Named(object->id()) : "the table");
  }
  const world::RobotBody* robot = simulation.robot();
  if (robot != nullptr && robot->IsTouching(assembly)) names.push_back("the robot");
  return names;
}

/// Returns the reason why the first hand that has not arrived is delayed.
std::string WhyNotArrived(const Simulation& simulation) {
  const demonstrator::Demonstrator& demonstrator = simulation.demonstrator();
  // Called only if one has not arrived, so there is one.
  const auto hand = std::ranges::find_if(
      demonstrator::kHandNames, [&](HandName name) { return !demonstrator.has_arrived(name); });
  const physics::BodyId held = demonstrator.hand(*hand).held;
  const std::string object = world::Named(simulation.tabletop().Find(held)->id());
  const std::vector<std::string> names = NamesOfTouching(simulation, held);
  if (names.empty()) return object + " is still moving, and no object touches it";
  std::string all;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (i > 0) all += i + 1 < names.size() ? ", " : " and ";
    all += names[i];
  }
  return all + (names.size() == 1 ? " is" : " are") + " in the way of " + object;
}

/// Returns the reason why a wait is not over.
std::string WhyNotOver(const Wait& wait, const Simulation& simulation) {
  if (wait.until == Wait::Until::kStill) return "something still moves";
  if (!simulation.demonstrator().has_arrived()) {
    return "a hand has not arrived: " + WhyNotArrived(simulation);
  }
  return "the robot is still moving: its trajectory takes longer";
}

/// Returns the canonical path of a file that a script names: in one of these folders or below it,
/// after following links.
/// @throws std::invalid_argument if there is no such file.
std::filesystem::path FindFile(const std::string& name,
                               const std::vector<std::filesystem::path>& folders) {
  for (const std::filesystem::path& folder : folders) {
    std::error_code error;
    const auto file = std::filesystem::canonical(folder / name, error);
    if (!error && IsWithin(file, folder)) return file;
  }
  throw std::invalid_argument("\"file\" is " + Quoted(name) +
                              ", expected a file in the folder of the script, in a --path folder "
                              "or below these");
}

/// Reads the lines of one script.
class LineReader {
 public:
  /// @param folders  folders of files that the script may name; empty: it may name none.
  LineReader(double meters_per_unit, std::vector<std::filesystem::path> folders)
      : meters_per_unit_(meters_per_unit), folders_(std::move(folders)) {}

  ScriptLine Read(std::string_view text, int line) {
    const Json json = ParseLineJson(text);
    ScriptLine read{.line = line, .tick = ParseTick(json), .what = Wait()};
    // From the special forms to the general one, whose messages list the kinds of commands.
    const bool has_do = json.is_object() && json.contains("do");
    if (has_do && json.at("do") == "wait") {
      read.what = ParseWait(json);
    } else if (IsDrag(json)) {
      read.what = ParseDrag(json, meters_per_unit_);
    } else if (IsAdd(json)) {
      read.what = ParseAdd(json, meters_per_unit_);
    } else if (IsDuplicate(json)) {
      read.what = ParseDuplicate(json, meters_per_unit_);
    } else if (has_do && json.at("do") == "trajectory" && json.contains("file")) {
      read.what = ReadTrajectoryOf(json);
    } else if (has_do && json.at("do") == "load" && json.contains("file")) {
      read.what = ReadLoadOf(json);
    } else {
      read.what = ParseCommand(json, meters_per_unit_);
    }
    if (const auto* command = std::get_if<Command>(&read.what)) CheckUnit(*command);
    return read;
  }

 private:
  /// Checks a scene's unit: the lengths of all lines are in the unit of the scene that the script
  /// was read for.
  void CheckUnit(const Command& command) const {
    const auto* load = std::get_if<Load>(&command);
    if (load == nullptr || load->scene->meters_per_unit == meters_per_unit_) return;
    throw std::invalid_argument(
        "the scene to load has " + NumberText(load->scene->meters_per_unit) +
        " meters per unit, expected those of the script's scene, " + NumberText(meters_per_unit_));
  }

  Command ReadLoadOf(const Json& json) {
    const std::filesystem::path file = FileNamedBy(json, "load");
    // The same limits as for a scene inside a command, since the log will contain its text.
    scene_xml::SceneReaderOptions options{.search_roots = folders_, .limits = kCommandSceneLimits};
    return Load{std::make_shared<const scene::SceneSpec>(scene_xml::LoadScene(file, options))};
  }

  Command ReadTrajectoryOf(const Json& json) {
    return FollowTrajectory{TrajectoryIn(FileNamedBy(json, "trajectory"))};
  }

  /// Returns the file that a line names instead of inline content.
  std::filesystem::path FileNamedBy(const Json& json, const std::string& name) const {
    for (const auto& item : json.items()) {
      if (item.key() != "do" && item.key() != "tick" && item.key() != "file") {
        throw std::invalid_argument("\"" + name + "\" with a \"file\" has an unknown key \"" +
                                    item.key() + "\"");
      }
    }
    const Json& file = json.at("file");
    if (!file.is_string() || folders_.empty()) {
      throw std::invalid_argument("\"file\" is " + ToText(file) +
                                  ", expected the name of a file, in a script file");
    }
    return FindFile(file.get<std::string>(), folders_);
  }

  /// Returns the trajectory of a file, read once.
  /// @param file  canonical path.
  const motion::JointTrajectory& TrajectoryIn(const std::filesystem::path& file) {
    auto known = trajectories_.find(file);
    if (known == trajectories_.end()) {
      known = trajectories_.emplace(file, motion::ReadTrajectory(file)).first;
    }
    // Counted for each line, not for each file: every line has a copy.
    num_points_ += known->second.points.size();
    if (num_points_ > kMaxPointsFromFiles) {
      throw std::invalid_argument("the trajectories of the script have more than " +
                                  std::to_string(kMaxPointsFromFiles) + " points together");
    }
    return known->second;
  }

  double meters_per_unit_;
  std::vector<std::filesystem::path> folders_;
  std::map<std::filesystem::path, motion::JointTrajectory> trajectories_;  ///< that were read
  std::size_t num_points_ = 0;  ///< of the lines that name files
};

/// Reads all lines and collects findings, so that one run reports as many as possible.
Script ParseWith(LineReader reader, std::string_view text, std::string file) {
  Script script{.file = std::move(file)};
  std::vector<Diagnostic> findings;
  for (int line = 1; !text.empty() && findings.size() < kMaxFindings; ++line) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    std::string_view content = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    const std::size_t first = content.find_first_not_of(" \t\r");
    // Empty lines and comments still count, as line numbers are those of the file.
    if (first == std::string_view::npos || content[first] == '#') continue;
    try {
      script.lines.push_back(reader.Read(content, line));
    } catch (const std::invalid_argument& error) {
      findings.push_back({script.file, line, "", error.what()});
    } catch (const InputError& error) {  // of a file that it names
      std::ranges::copy(error.diagnostics(), std::back_inserter(findings));
    }
  }
  if (!findings.empty()) throw InputError(std::move(findings));
  return script;
}

}  // namespace

Script ParseScript(std::string_view text, std::string file, double meters_per_unit) {
  return ParseWith(LineReader(meters_per_unit, {}), text, std::move(file));
}

Script ReadScript(const std::filesystem::path& path, double meters_per_unit,
                  const std::vector<std::filesystem::path>& roots) {
  std::vector<std::filesystem::path> folders = roots;
  folders.insert(folders.begin(), path.has_parent_path() ? path.parent_path() : ".");
  return ParseWith(LineReader(meters_per_unit, std::move(folders)), ReadFile(path, kMaxBytes),
                   path.string());
}

Script ScriptOf(motion::JointTrajectory trajectory, std::string file) {
  // A following robot stops at the end of its trajectory, even if it is blocked.
  const Wait to_the_end{.until = Wait::Until::kArrived, .seconds = kMaxWaitSeconds};
  return {
      .file = std::move(file),
      .lines = {{.what = Command(FollowTrajectory{std::move(trajectory)})}, {.what = to_the_end}}};
}

void ScriptPlayer::Advance(Simulation* simulation) {
  // All lines that are due now are executed within the same tick.
  for (; !is_finished(); ++next_) {
    const ScriptLine& line = script_.lines[next_];
    // Lines are in order: a later one waits for this one.
    if (line.tick && *line.tick > simulation->tick()) return;
    if (const auto* wait = std::get_if<Wait>(&line.what)) {
      if (!IsOver(*wait, line, *simulation)) return;
      wait_start_.reset();
      continue;
    }
    const auto refusal =
        std::visit(Overloaded{[](const Wait&) -> std::optional<Refusal> { return std::nullopt; },
                              [&](const auto& what) { return Execute(what, simulation); }},
                   line.what);
    if (refusal) Fail(line, *refusal);
  }
}

std::optional<Refusal> ScriptPlayer::Execute(const Command& command, Simulation* simulation) {
  return simulation->Apply(command);
}

std::optional<Refusal> ScriptPlayer::Execute(const Add& add, Simulation* simulation) {
  Refusal refusal;
  const auto spawn = SpawnOf(add, *simulation, &refusal);
  return spawn ? simulation->Apply(*spawn) : refusal;
}

std::optional<Refusal> ScriptPlayer::Execute(const Duplicate& duplicate, Simulation* simulation) {
  Refusal refusal;
  const auto spawn = SpawnOf(duplicate, *simulation, &refusal);
  return spawn ? simulation->Apply(*spawn) : refusal;
}

std::optional<Refusal> ScriptPlayer::Execute(const Drag& drag, Simulation* simulation) {
  Refusal refusal;
  const auto move = MoveOf(drag, *simulation, &refusal);
  return move ? simulation->Apply(*move) : refusal;
}

bool ScriptPlayer::IsOver(const Wait& wait, const ScriptLine& line, const Simulation& simulation) {
  // The wait begins when its line is reached.
  if (!wait_start_) {
    wait_start_ = simulation.tick();
    still_ticks_ = 0;
  }
  const auto waited = static_cast<double>(simulation.tick() - *wait_start_);
  const bool is_time_up = waited >= std::round(wait.seconds * kTicksPerSecond);
  // A wait for a condition fails if its time is up.
  if (wait.until == Wait::Until::kSeconds) return is_time_up;

  bool is_over = false;
  if (wait.until == Wait::Until::kArrived) {
    is_over = simulation.demonstrator().has_arrived() && !simulation.is_robot_following();
  } else {
    still_ticks_ = simulation.is_still() ? still_ticks_ + 1 : 0;
    // A body may be slow for a moment at the top of its path, so one still tick is not enough.
    is_over = still_ticks_ > kStillTicks;
  }
  if (!is_over && is_time_up) {
    Fail(line, "waited " + std::to_string(static_cast<int>(wait.seconds)) + " s, but " +
                   WhyNotOver(wait, simulation));
  }
  return is_over;
}

void ScriptPlayer::Fail(const ScriptLine& line, const std::string& message) const {
  throw InputError({script_.file, line.line, "", message});
}

}  // namespace smile::sim
