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

struct RerenderOptions {
  std::string demo, out, demonstrator;
  bool no_symbols = false, json = false;
};

/// Copies a recording with another demonstrator in its pictures.
int RerenderRecording(const RerenderOptions& options) {
  const classic::RedrawOptions copy{
      .demonstrator = recording::ParseDemonstratorAppearance(options.demonstrator),
      .has_symbols = !options.no_symbols};
  const recording::Recording recording = OpenAndReport(options.demo);
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

CLI::App* AddNamed(const char* name, CLI::App* program, ExitAnswer answer) {
  auto options = std::make_shared<RerenderOptions>();
  CLI::App* rerender =
      program->add_subcommand(name, "Copy a recording, with another demonstrator in its pictures");
  rerender->add_option("DEMO", options->demo, "directory of a recording")->required();
  AddDemonstratorOption(rerender, &options->demonstrator)->required();
  rerender->add_option("--out", options->out, "new directory")->required()->check(NotEmpty());
  rerender->add_flag("--no-symbols", options->no_symbols, "classic view without texts");
  rerender->add_flag("--json", options->json, "result as one JSON object on stdout");
  rerender->callback([options, answer] { *answer = RerenderRecording(*options); });
  return rerender;
}

}  // namespace

void AddRerender(CLI::App* program, ExitAnswer answer) {
  AddNamed("rerender", program, answer);
  AddNamed("dress", program, answer)->group("");  // the earlier name; --help does not list it
}

}  // namespace smile::app
