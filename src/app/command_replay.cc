#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>
#include <stdexcept>

#include "app/commands.h"
#include "app/exit_code.h"
#include "app/interrupt.h"
#include "app/progress.h"
#include "base/json.h"
#include "base/version.h"
#include "record/replay.h"

namespace smile::app {
namespace {

struct ReplayOptions {
  std::string demo;
  bool verify = false, json = false;
};

Json ToJson(const record::ReplayReport& report) {
  Json difference;
  if (const auto& first = report.first_difference) {
    difference = {{"tick", first->tick},
                  {"object", first->object},
                  {"quantity", first->quantity},
                  {"recorded", first->recorded},
                  {"replayed", first->replayed}};
  }
  return {{"identical", !report.first_difference},
          {"ticks", report.ticks},
          {"first_difference", difference}};
}

int ReplayDemo(const ReplayOptions& options) {
  const record::Recording recording = record::OpenRecording(options.demo);
  for (const std::string& cut : recording.cuts) {
    std::fprintf(stderr, "%s: %s\n", options.demo.c_str(), cut.c_str());
  }
  if (recording.info.program != ProgramName()) {
    std::fprintf(stderr, "%s: was made by %s, this is %s\n", options.demo.c_str(),
                 recording.info.program.c_str(), ProgramName().c_str());
  }
  record::ReplayReport report;
  {
    ProgressLine progress("replaying");
    report = record::Replay(recording, [&progress](std::uint64_t ticks) {
      progress.Show(static_cast<double>(ticks) / sim::kTicksPerSecond, 0);
      return !IsInterrupted();
    });
  }
  if (IsInterrupted()) throw std::runtime_error("interrupted");
  if (report.is_cut) {
    std::fprintf(stderr, "%s: the last tick of trace.bin was cut and is left out\n",
                 options.demo.c_str());
  }
  if (options.json) {
    std::printf("%s\n", ToText(ToJson(report), 2).c_str());
  } else if (!report.first_difference) {
    std::printf("%s: identical, %llu ticks\n", options.demo.c_str(),
                static_cast<unsigned long long>(report.ticks));
  } else {
    const record::Difference& first = *report.first_difference;
    std::printf("%s: differs at tick %llu: %s: %s: recorded %s, replayed %s\n",
                options.demo.c_str(), static_cast<unsigned long long>(first.tick),
                first.object.c_str(), first.quantity.c_str(), first.recorded.c_str(),
                first.replayed.c_str());
  }
  return options.verify && report.first_difference ? kInputWrong : kDone;
}

}  // namespace

void AddReplay(CLI::App* program, ExitAnswer answer) {
  auto options = std::make_shared<ReplayOptions>();
  CLI::App* replay = program->add_subcommand(
      "replay", "Run a recording again and compare it with what was recorded, tick by tick");
  replay->add_option("DEMO", options->demo, "directory of a recording")->required();
  replay->add_flag("--verify", options->verify, "exit 1 on a difference");
  replay->add_flag("--json", options->json, "print one JSON object on stdout");
  replay->callback([options, answer] { *answer = ReplayDemo(*options); });
}

}  // namespace smile::app
