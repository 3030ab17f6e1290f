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
#include "sim/duplicate.h"
#include "sim/simulation.h"

namespace smile::sim {

/// Pause between two lines of a script. Not a command: it does not appear in logs.
struct Wait {
  enum class Until { kSeconds, kArrived, kStill };
  Until until = Until::kSeconds;
  double seconds = 10;  ///< duration; for the other two the maximum duration

  bool operator==(const Wait&) const = default;
};

/// One line of a script.
struct ScriptLine {
  int line = 0;                       ///< line number in the file, from 1
  std::optional<std::uint64_t> tick;  ///< earliest tick
  std::variant<Command, Drag, Add, Duplicate, Wait> what;
};

/// A demonstration or a test as a file: one command per line as JSON, with blank lines and comments
/// that begin with #. Lines without a `tick` follow one another.
struct Script {
  std::string file;  ///< name as the user wrote it, for messages
  std::vector<ScriptLine> lines;
};

/// Parses a script that is not a file; its trajectories are inline.
/// @throws InputError with all findings.
Script ParseScript(std::string_view text, std::string file, double meters_per_unit);
/// Reads a script file.
/// @param roots  folders that may contain the trajectory files that the script names, directly or
///               below, after its own folder.
/// @throws InputError with all findings; std::runtime_error if a file cannot be read.
Script ReadScript(const std::filesystem::path& path, double meters_per_unit,
                  const std::vector<std::filesystem::path>& roots = {});

/// Returns a script that plays a trajectory to its end.
Script ScriptOf(motion::JointTrajectory trajectory, std::string file);

/// Plays a script in a simulation, line by line.
class ScriptPlayer {
 public:
  explicit ScriptPlayer(Script script) : script_(std::move(script)) {}

  /// Applies all lines that are due. Call before each tick.
  /// @throws InputError with the line if a command is refused or a wait takes too long.
  void Advance(Simulation* simulation);

  bool is_finished() const { return next_ == script_.lines.size(); }
  /// Returns the file and line of the next command; only while not finished.
  std::string place() const {
    return script_.file + ":" + std::to_string(script_.lines[next_].line);
  }

 private:
  /// Executes a line of the script as a command.
  /// @returns the reason if it was refused; nullopt if it was executed.
  static std::optional<Refusal> Execute(const Command& command, Simulation* simulation);
  static std::optional<Refusal> Execute(const Drag& drag, Simulation* simulation);
  static std::optional<Refusal> Execute(const Add& add, Simulation* simulation);
  static std::optional<Refusal> Execute(const Duplicate& duplicate, Simulation* simulation);
  bool IsOver(const Wait& wait, const ScriptLine& line, const Simulation& simulation);
  [[noreturn]] void Fail(const ScriptLine& line, const std::string& message) const;

  Script script_;
  std::size_t next_ = 0;
  std::optional<std::uint64_t> wait_start_;  ///< tick at which the current wait began
  int still_ticks_ = 0;
};

}  // namespace smile::sim
