#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "base/json.h"
#include "sim/command.h"

namespace smile::recording {

/// Point of a recording's history: the commands of the log up to `line` are executed, and the
/// simulation has run to `tick`. A line that is a return stands for the point it leads to.
struct HistoryPoint {
  std::size_t line = 0;  ///< 1 is the first; 0: before the first
  std::uint64_t tick = 0;

  bool operator==(const HistoryPoint&) const = default;
};

enum class ReturnKind { kUndo, kRedo, kCheckout };
std::string_view ToString(ReturnKind kind);

/// Undo, redo or checkout: the recording continues from another point of its history.
struct Return {
  ReturnKind kind = ReturnKind::kUndo;
  HistoryPoint to;

  bool operator==(const Return&) const = default;
};

/// One line of `commands.jsonl`.
struct LogLine {
  std::uint64_t tick = 0;  ///< of the simulation when the line was written
  std::variant<sim::Command, Return> what;
};

struct LoggedCommand {
  std::size_t line = 0;  ///< of the log
  std::uint64_t tick = 0;
  sim::Command command;
};

/// `commands.jsonl`, the source of truth: all commands in order. An undo, redo or checkout removes
/// nothing: it leads to another point, from where the log continues. So the log is a tree, and each
/// of its lines is the end of one path from the root.
class CommandLog {
 public:
  /// @throws std::invalid_argument if the line cannot follow those before it.
  void Add(LogLine line);
  void RemoveLast() { lines_.pop_back(); }

  const std::vector<LogLine>& lines() const { return lines_; }
  /// Returns the point that a line leads to, from where the next one continues.
  HistoryPoint After(std::size_t line) const;
  /// Returns the predecessor of a line on its path; 0 for the start.
  std::size_t LineBefore(std::size_t line) const;
  /// Returns the commands on the path to the point after `line`, in order.
  std::vector<LoggedCommand> PathTo(std::size_t line) const;

 private:
  std::vector<LogLine> lines_;
};

/// Returns a line as JSON, with its newline.
std::string ToJsonLine(const LogLine& line, double meters_per_unit);

/// Reads a log. An incomplete last line is skipped and reported in `cut`.
/// @throws InputError with the first line that is wrong.
CommandLog ReadCommandLog(const std::filesystem::path& path, double meters_per_unit,
                          std::optional<std::string>* cut);

}  // namespace smile::recording
