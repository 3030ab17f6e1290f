#include "recording/command_log.h"

#include <algorithm>
#include <array>
#include <stdexcept>

#include "base/diagnostic.h"
#include "base/files.h"
#include "sim/command_json.h"

// The log is a tree in a sequential file. Most lines follow the line before them; a return (undo,
// redo, checkout) makes the next line follow an earlier one. A path is therefore read backwards,
// from its end to the start.

namespace smile::recording {
namespace {

// Bounds the memory for a damaged or hostile file.
constexpr std::size_t kMaxLogBytes = std::size_t{1} << 30;

constexpr std::array kReturnKinds = {ReturnKind::kUndo, ReturnKind::kRedo, ReturnKind::kCheckout};

/// Returns the kind of a line that is a return; nullopt for all other lines.
std::optional<ReturnKind> ParseReturnKind(const Json& json) {
  if (!json.is_object() || !json.contains("do")) return std::nullopt;
  // As commands, undo and redo have the same words; in a log they have a target.
  for (ReturnKind kind : kReturnKinds) {
    if (json.at("do") == ToString(kind)) return kind;
  }
  return std::nullopt;
}

/// Returns a member of a return's target; throws std::invalid_argument if it is no whole number
/// from 0.
std::uint64_t ParseNumber(const Json& json, const char* key) {
  if (!json.is_object() || !json.contains(key) || !json.at(key).is_number_unsigned()) {
    throw std::invalid_argument("\"to\" is " + ToText(json) +
                                ", expected {\"line\": L, \"tick\": T}, whole numbers from 0");
  }
  return json.at(key).get<std::uint64_t>();
}

/// Parses one line; throws std::invalid_argument if it is malformed or cannot be in a log.
LogLine ParseLogLine(std::string_view text, double meters_per_unit) {
  const Json json = sim::ParseLineJson(text);
  const auto tick = sim::ParseTick(json);
  if (!tick) throw std::invalid_argument("\"tick\" is missing, expected the tick of execution");
  if (const auto kind = ParseReturnKind(json)) {
    const Json to = json.value("to", Json());
    return {
        .tick = *tick,
        .what = Return{.kind = *kind,
                       .to = {.line = ParseNumber(to, "line"), .tick = ParseNumber(to, "tick")}}};
  }
  // Commands that control recording or replace the scene end or begin a recording and are never
  // part of one.
  sim::Command command = sim::ParseCommand(json, meters_per_unit);
  if (std::holds_alternative<sim::StartRecording>(command) ||
      std::holds_alternative<sim::FinishRecording>(command) ||
      std::holds_alternative<sim::Load>(command)) {
    throw std::invalid_argument("\"do\" is " + ToText(json.at("do")) +
                                ", which never appears in a log");
  }
  return {.tick = *tick, .what = std::move(command)};
}

}  // namespace

std::string_view ToString(ReturnKind kind) {
  switch (kind) {
    case ReturnKind::kUndo:
      return "undo";
    case ReturnKind::kRedo:
      return "redo";
    case ReturnKind::kCheckout:
      return "checkout";
  }
  return "";
}

void CommandLog::Add(LogLine line) {
  // Ticks do not decrease along a path; after a return they are compared to the point it leads to.
  const HistoryPoint last = After(lines_.size());
  if (line.tick < last.tick) {
    throw std::invalid_argument("\"tick\" decreases, expected at least " +
                                std::to_string(last.tick));
  }
  // A return leads to a line that exists and to a tick not earlier than that line.
  if (const auto* back = std::get_if<Return>(&line.what)) {
    if (back->to.line > lines_.size()) {
      throw std::invalid_argument("\"line\" is " + std::to_string(back->to.line) +
                                  ", expected one of those before");
    }
    if (back->to.tick < After(back->to.line).tick) {
      throw std::invalid_argument("\"to\" is tick " + std::to_string(back->to.tick) +
                                  ", expected at least that of its line, " +
                                  std::to_string(After(back->to.line).tick));
    }
  }
  lines_.push_back(std::move(line));
}

HistoryPoint CommandLog::After(std::size_t line) const {
  if (line == 0) return {};
  const LogLine& last = lines_[line - 1];
  if (const auto* back = std::get_if<Return>(&last.what)) return back->to;
  return {.line = line, .tick = last.tick};
}

std::size_t CommandLog::LineBefore(std::size_t line) const {
  // A return is not part of any path: it stands for the point it leads to. Lines decrease strictly,
  // so this ends.
  std::size_t before = line - 1;
  while (before > 0) {
    const auto* back = std::get_if<Return>(&lines_[before - 1].what);
    if (back == nullptr) break;
    before = back->to.line;
  }
  return before;
}

std::vector<LoggedCommand> CommandLog::PathTo(std::size_t line) const {
  std::vector<LoggedCommand> path;
  // Starts one line later: the predecessor of `line + 1` is the line itself, or the point it leads
  // to if it is a return.
  for (line = LineBefore(line + 1); line > 0; line = LineBefore(line)) {
    const LogLine& logged = lines_[line - 1];
    path.push_back({line, logged.tick, std::get<sim::Command>(logged.what)});
  }
  std::reverse(path.begin(), path.end());
  return path;
}

std::string ToJsonLine(const LogLine& line, double meters_per_unit) {
  Json json = {{"tick", line.tick}};
  if (const auto* back = std::get_if<Return>(&line.what)) {
    json["do"] = ToString(back->kind);
    json["to"] = {{"line", back->to.line}, {"tick", back->to.tick}};
  } else {
    json.update(sim::ToJson(std::get<sim::Command>(line.what), meters_per_unit));
  }
  return ToText(json) + "\n";
}

CommandLog ReadCommandLog(const std::filesystem::path& path, double meters_per_unit,
                          std::optional<std::string>* cut) {
  const std::string text = ReadFile(path, kMaxLogBytes);
  CommandLog log;
  std::size_t start = 0;
  for (int number = 1; start < text.size(); ++number) {
    // A line is complete only with its newline: a killed program may leave the last one unfinished.
    const std::size_t end = text.find('\n', start);
    if (end == std::string::npos) {
      *cut = "the last line of commands.jsonl was cut and is skipped";
      break;
    }
    try {
      log.Add(ParseLogLine(std::string_view(text).substr(start, end - start), meters_per_unit));
    } catch (const std::exception& error) {  // of the JSON library or ours
      // Later lines refer to lines by number and to the state after this one; findings about them
      // would be misleading.
      throw InputError({path.string(), number, "", error.what()});
    }
    start = end + 1;
  }
  return log;
}

}  // namespace smile::recording
