#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>

#include "app/commands.h"
#include "app/console_reporter.h"
#include "app/exit_code.h"
#include "app/open_recording.h"
#include "app/options.h"
#include "base/json.h"
#include "experiment/rerender.h"

namespace smile::app {
namespace {

struct DressOptions {
  std::string demo, out, demonstrator;
  bool no_symbols = false, json = false;
};

int DressOne(const DressOptions& options) {
  const classic::RedrawOptions copy{
      .demonstrator = recording::ParseDemonstratorLook(options.demonstrator),
      .has_symbols = !options.no_symbols};
  const recording::Recording recording = OpenAndTell(options.demo);
  ConsoleReporter console;
  const std::size_t num_pictures =
      experiment::Rerender(recording, options.out, copy, console.callbacks());
  console.Clear();
  if (options.json) {
    const Json json = {{"recording", options.out},
                       {"demonstrator", options.demonstrator},
                       {"pictures", num_pictures}};
    std::printf("%s\n", ToText(json, 2).c_str());
  } else {
    std::printf("%s: %zu pictures, demonstrator %s\n", options.out.c_str(), num_pictures,
                options.demonstrator.c_str());
  }
  return kDone;
}

}  // namespace

void AddDress(CLI::App* program, ExitAnswer answer) {
  auto options = std::make_shared<DressOptions>();
  CLI::App* dress = program->add_subcommand(
      "dress", "Copy a recording with another demonstrator in its pictures");
  dress->add_option("DEMO", options->demo, "directory of a recording")->required();
  AddDemonstratorOption(dress, &options->demonstrator)->required();
  dress->add_option("--out", options->out, "directory to make")->required()->check(NotEmpty());
  dress->add_flag("--no-symbols", options->no_symbols, "without the texts of the classic view");
  dress->add_flag("--json", options->json, "print one JSON object on stdout");
  dress->callback([options, answer] { *answer = DressOne(*options); });
}

}  // namespace smile::app
