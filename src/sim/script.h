#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "sim/add.h"
#include "sim/command.h"
#include "sim/drag.h"
#include "sim/simulation.h"

namespace smile::sim {

/// Lets time pass between two lines of a script; not a command: it reaches no log.
struct Wait {
  enum class Until { kSeconds, kArrived, kStill };
  Until until = Until::kSeconds;
  double seconds = 10;  ///< how long; for the other two how long at most

  bool operator==(const Wait&) const = default;
};

struct ScriptLine {
  int line = 0;                       ///< in the file, 1 is the first
  std::optional<std::uint64_t> tick;  ///< not before this tick
  std::variant<Command, Drag, Add, Wait> what;
};

/// A demonstration or a test, written down: one command per line as JSON, blank lines and lines
/// that begin with # between them. Lines without a `tick` follow one another.
struct Script {
  std::string file;  ///< as the user named it, for messages
  std::vector<ScriptLine> lines;
};

/// A script that is in no file; its trajectories have their points with them.
/// @throws InputError with all findings.
Script ParseScript(std::string_view text, std::string file, double meters_per_unit);
/// @param roots  folders in which, or below which, the trajectory files may lie that the script
///               names, after its own folder.
/// @throws InputError with all findings; std::runtime_error if a file cannot be read.
Script ReadScript(const std::filesystem::path& path, double meters_per_unit,
                  const std::vector<std::filesystem::path>& roots = {});

/// A script that plays a trajectory, from now to its end.
Script ScriptOf(motion::JointTrajectory trajectory, std::string file);

/// Speaks a script to a simulation, line by line, at its pace.
class ScriptPlayer {
 public:
  explicit ScriptPlayer(Script script) : script_(std::move(script)) {}

  /// Applies what is due now. To be called before each tick.
  /// @throws InputError naming the line when a command is refused or a wait takes too long.
  void Advance(Simulation* simulation);

  bool is_finished() const { return next_ == script_.lines.size(); }
  /// Where it stands: the file and line of what comes next; only while not finished.
  std::string place() const {
    return script_.file + ":" + std::to_string(script_.lines[next_].line);
  }

 private:
  /// Executes a line of the script as a command.
  /// @returns why it was refused; nullopt if it was executed.
  static std::optional<Refusal> Execute(const Command& command, Simulation* simulation);
  static std::optional<Refusal> Execute(const Drag& drag, Simulation* simulation);
  static std::optional<Refusal> Execute(const Add& add, Simulation* simulation);
  bool IsOver(const Wait& wait, const ScriptLine& line, const Simulation& simulation);
  [[noreturn]] void Fail(const ScriptLine& line, const std::string& message) const;

  Script script_;
  std::size_t next_ = 0;
  std::optional<std::uint64_t> wait_start_;  ///< tick at which the current wait began
  int still_ticks_ = 0;
};

}  // namespace smile::sim
