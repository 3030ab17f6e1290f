#include "sim/script.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "base/diagnostic.h"
#include "base/files.h"
#include "sim/command_json.h"

namespace smile::sim {
namespace {

constexpr std::size_t kMaxBytes = 256u << 20;
constexpr std::size_t kMaxLineBytes = 64u << 10;
constexpr std::size_t kMaxFindings = 100;
constexpr double kMaxWaitSeconds = 86400;
/// Things count as still after a quarter of a second without motion.
constexpr int kStillTicks = kTicksPerSecond / 4;

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

ScriptLine ParseLine(std::string_view text, int line, double meters_per_unit) {
  if (text.size() > kMaxLineBytes) throw std::invalid_argument("this line is longer than 64 KiB");
  const Json json = ParseJson(text);
  if (json.is_object() && json.contains("do") && json.at("do") == "wait") {
    return {.line = line, .tick = ParseTick(json), .what = ParseWait(json)};
  }
  Command command = ParseCommand(json, meters_per_unit);
  return {.line = line, .tick = ParseTick(json), .what = std::move(command)};
}

}  // namespace

Script ParseScript(std::string_view text, std::string file, double meters_per_unit) {
  Script script{.file = std::move(file)};
  std::vector<Diagnostic> findings;
  for (int line = 1; !text.empty(); ++line) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    std::string_view content = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    const std::size_t first = content.find_first_not_of(" \t\r");
    if (first == std::string_view::npos || content[first] == '#') continue;
    try {
      script.lines.push_back(ParseLine(content, line, meters_per_unit));
    } catch (const std::invalid_argument& error) {
      findings.push_back({script.file, line, "", error.what()});
      if (findings.size() == kMaxFindings) break;
    }
  }
  if (!findings.empty()) throw InputError(std::move(findings));
  return script;
}

Script ReadScript(const std::filesystem::path& path, double meters_per_unit) {
  return ParseScript(ReadFile(path, kMaxBytes), path.string(), meters_per_unit);
}

void ScriptPlayer::Advance(Simulation* simulation) {
  for (; !is_finished(); ++next_) {
    const ScriptLine& line = script_.lines[next_];
    if (line.tick && *line.tick > simulation->tick()) return;
    if (const auto* wait = std::get_if<Wait>(&line.what)) {
      if (!IsOver(*wait, line, *simulation)) return;
      wait_start_.reset();
      continue;
    }
    if (auto refusal = simulation->Apply(std::get<Command>(line.what))) Fail(line, *refusal);
  }
}

bool ScriptPlayer::IsOver(const Wait& wait, const ScriptLine& line, const Simulation& simulation) {
  if (!wait_start_) {
    wait_start_ = simulation.tick();
    still_ticks_ = 0;
  }
  const auto waited = static_cast<double>(simulation.tick() - *wait_start_);
  const bool is_time_up = waited >= std::round(wait.seconds * kTicksPerSecond);
  if (wait.until == Wait::Until::kSeconds) return is_time_up;

  bool is_over = false;
  if (wait.until == Wait::Until::kArrived) {
    is_over = simulation.demonstrator().has_arrived();
  } else {
    still_ticks_ = simulation.is_still() ? still_ticks_ + 1 : 0;
    is_over = still_ticks_ > kStillTicks;
  }
  if (!is_over && is_time_up) {
    Fail(line, std::string("waited ") + std::to_string(static_cast<int>(wait.seconds)) +
                   (wait.until == Wait::Until::kArrived
                        ? " s, but a hand has not arrived: something is in its way"
                        : " s, but something still moves"));
  }
  return is_over;
}

void ScriptPlayer::Fail(const ScriptLine& line, const std::string& message) const {
  throw InputError({script_.file, line.line, "", message});
}

}  // namespace smile::sim
