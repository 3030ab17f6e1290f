#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>
#include <stdexcept>

#include "app/commands.h"
#include "app/exit_code.h"
#include "app/interrupt.h"
#include "app/open_recording.h"
#include "app/progress.h"
#include "base/json.h"
#include "base/version.h"
#include "replay/replay.h"

namespace smile::app {
namespace {

struct ReplayCommandOptions {
  std::string demo;
  recording::TimeRange range;
  bool verify = false, json = false;
};

/// Maximal number of printed lines of a kind; more of them are for programs (--json).
constexpr std::size_t kMaxLines = 10;

Json ToJson(const replay::Difference& difference) {
  return {{"tick", difference.tick},
          {"object", difference.object},
          {"quantity", difference.quantity},
          {"recorded", difference.recorded},
          {"replayed", difference.replayed}};
}

Json ToJson(const replay::Deviation& deviation) {
  const auto& end = deviation.end;
  return {{"object", deviation.object},
          {"largest_mm", deviation.largest.millimeters()},
          {"largest_degrees", deviation.largest.degrees()},
          {"at_tick", deviation.tick},
          {"end_mm", end ? Json(end->millimeters()) : Json()},
          {"end_degrees", end ? Json(end->degrees()) : Json()}};
}

Json ToJson(const replay::RefusedCommand& command) {
  return {{"tick", command.tick}, {"line", command.line}, {"reason", command.reason}};
}

template <typename T>
Json ArrayOf(const std::vector<T>& all) {
  Json array = Json::array();
  for (const T& one : all) array.push_back(ToJson(one));
  return array;
}

Json ToJson(const replay::ReplayReport& report, const recording::Recording& recording) {
  const auto& first = report.first_difference;
  return {{"identical", !first},
          {"ticks", report.ticks()},
          {"from", SecondsInto(recording, report.compared.first)},
          {"to", SecondsInto(recording, report.compared.last)},
          {"first_difference", first ? ToJson(*first) : Json()},
          {"differences", ArrayOf(report.deviations)},
          {"state_differences", ArrayOf(report.state_differences)},
          {"refused", ArrayOf(report.refused)}};
}

/// Returns a difference of poses, with three significant digits.
std::string GapText(const recording::PoseGap& gap) {
  char text[64];
  std::snprintf(text, sizeof text, "%.3g mm and %.3g degrees", gap.millimeters(), gap.degrees());
  return text;
}

std::string LineOf(const replay::Deviation& deviation) {
  return deviation.object + ": " + GapText(deviation.largest) + " apart at tick " +
         std::to_string(deviation.tick) + ", " +
         (deviation.end ? GapText(*deviation.end) + " at the end" : "missing at the end");
}
std::string LineOf(const replay::Difference& difference) {
  return difference.object + ": " + difference.quantity + ": ends as " + difference.replayed +
         ", recorded " + difference.recorded;
}
std::string LineOf(const replay::RefusedCommand& command) {
  return "commands.jsonl:" + std::to_string(command.line) + ": at tick " +
         std::to_string(command.tick) + ": " + command.reason;
}

template <typename T>
/// Prints the first lines of a list, and the number of the others.
void PrintSome(const std::vector<T>& all) {
  for (std::size_t i = 0; i < all.size() && i < kMaxLines; ++i) {
    std::printf("  %s\n", LineOf(all[i]).c_str());
  }
  if (all.size() > kMaxLines) std::printf("  and %zu more\n", all.size() - kMaxLines);
}

void Print(const replay::ReplayReport& report, const recording::Recording& recording,
           const ReplayCommandOptions& options) {
  const auto ticks = static_cast<unsigned long long>(report.ticks());
  if (!report.first_difference) {
    std::printf("%s: identical, %llu ticks", options.demo.c_str(), ticks);
    if (options.range != recording::TimeRange()) {
      std::printf(" from %.2f s to %.2f s", SecondsInto(recording, report.compared.first),
                  SecondsInto(recording, report.compared.last));
    }
    std::printf("\n");
    return;
  }
  const replay::Difference& first = *report.first_difference;
  std::printf("%s: differs at tick %llu: %s: %s: recorded %s, replayed %s\n", options.demo.c_str(),
              static_cast<unsigned long long>(first.tick), first.object.c_str(),
              first.quantity.c_str(), first.recorded.c_str(), first.replayed.c_str());
  std::printf("compared from %.2f s to %.2f s, %llu ticks\n",
              SecondsInto(recording, report.compared.first),
              SecondsInto(recording, report.compared.last), ticks);
  PrintSome(report.refused);
  PrintSome(report.state_differences);
  PrintSome(report.deviations);
}

/// Replays with a progress line.
replay::ReplayReport ReplayIt(const recording::Recording& recording,
                              const ReplayCommandOptions& options) {
  // Recordings of other versions are expected to differ, so the replay continues and shows by how
  // much.
  const bool is_ours = recording.info.program == ProgramName();
  ProgressLine progress("replaying");
  return replay::Replay(recording,
                        {.range = options.range, .stops_at_difference = options.verify && is_ours},
                        [&progress](double done, double total) {
                          progress.Show(done, total);
                          return !IsInterrupted();
                        });
}

int ReplayDemo(const ReplayCommandOptions& options) {
  const recording::Recording recording = OpenAndReport(options.demo);
  const replay::ReplayReport report = ReplayIt(recording, options);
  if (IsInterrupted()) throw std::runtime_error("interrupted");
  // A program that was killed while it recorded leaves an incomplete last tick.
  if (report.is_cut) {
    std::fprintf(stderr, "%s: the last tick of trace.bin was cut and is skipped\n",
                 options.demo.c_str());
  }
  if (options.json) {
    std::printf("%s\n", ToText(ToJson(report, recording), 2).c_str());
  } else {
    Print(report, recording, options);
  }
  return options.verify && report.first_difference ? kInputWrong : kDone;
}

}  // namespace

void AddReplay(CLI::App* program, ExitAnswer answer) {
  auto options = std::make_shared<ReplayCommandOptions>();
  CLI::App* replay = program->add_subcommand(
      "replay", "Replay a recording and compare it with the recorded states, tick by tick");
  replay->add_option("DEMO", options->demo, "directory of a recording")->required();
  replay->add_flag("--verify", options->verify,
                   "stop at the first visible difference; exit code 1 on any difference");
  replay->add_option("--from", options->range.from,
                     "start of the comparison [s] (default: the start of the recording)");
  replay->add_option("--to", options->range.to,
                     "end of the comparison [s] (default: the end of the recording)");
  replay->add_flag("--json", options->json, "result as one JSON object on stdout");
  replay->callback([options, answer] { *answer = ReplayDemo(*options); });
}

}  // namespace smile::app
