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

/// A moment of a recording's history: what the log up to its `line` says is done, and the world has
/// run on to `tick`. A line that leads back stands for what it leads to.
struct Moment {
  std::size_t line = 0;  ///< 1 is the first; 0: nothing is done yet
  std::uint64_t tick = 0;

  bool operator==(const Moment&) const = default;
};

enum class ReturnKind { kUndo, kRedo, kCheckout };
std::string_view ToString(ReturnKind kind);

/// From here on the recording goes on from another moment of its history.
struct Return {
  ReturnKind kind = ReturnKind::kUndo;
  Moment to;

  bool operator==(const Return&) const = default;
};

/// One line of `commands.jsonl`.
struct LogLine {
  std::uint64_t tick = 0;  ///< at which it was written
  std::variant<sim::Command, Return> what;
};

struct LoggedCommand {
  std::size_t line = 0;  ///< of the log
  std::uint64_t tick = 0;
  sim::Command command;
};

/// `commands.jsonl`, the source of truth: everything that was commanded, in order. An undo, redo or
/// checkout takes nothing out: it leads back to another moment, from where the log goes on. So the
/// log is a tree, and each of its lines is the end of one way from the start.
class CommandLog {
 public:
  /// @throws std::invalid_argument if the line cannot follow those before it.
  void Add(LogLine line);
  void RemoveLast() { lines_.pop_back(); }

  const std::vector<LogLine>& lines() const { return lines_; }
  /// The moment a line leads to, from where the next one goes on.
  Moment After(std::size_t line) const;
  /// The line that came before a line, on its own way; 0 for the start.
  std::size_t LineBefore(std::size_t line) const;
  /// The commands on the way to a moment after `line`, in order.
  std::vector<LoggedCommand> WayTo(std::size_t line) const;

 private:
  std::vector<LogLine> lines_;
};

/// The written form of a line, with its end.
std::string ToJsonLine(const LogLine& line, double meters_per_unit);

/// Reads a log. A last line without its end is left out, and `cut` says so.
/// @throws InputError with the first line that is wrong.
CommandLog ReadCommandLog(const std::filesystem::path& path, double meters_per_unit,
                          std::optional<std::string>* cut);

}  // namespace smile::recording
