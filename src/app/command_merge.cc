// `smile merge`: joins the shards of a generation or an evaluation.

#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include "app/commands.h"
#include "app/console_reporter.h"
#include "app/exit_code.h"
#include "app/open_recording.h"
#include "app/options.h"
#include "experiment/merge.h"

namespace smile::app {
namespace {

struct MergeOptions {
  std::vector<std::string> shards;
  std::string out;
};

int MergeShards(const MergeOptions& options) {
  RequireOutsideOfRecordings(options.out);
  ConsoleReporter console;
  const std::string text = experiment::Merge({options.shards.begin(), options.shards.end()},
                                             options.out, console.callbacks());
  console.Clear();
  std::printf("%s%s\n", text.c_str(), options.out.c_str());
  return kDone;
}

}  // namespace

void AddMerge(CLI::App* program, ExitAnswer answer) {
  auto options = std::make_shared<MergeOptions>();
  CLI::App* merge = program->add_subcommand(
      "merge", "Join all shards of a generation or an evaluation, as if one process had made it");
  merge
      ->add_option("SHARD", options->shards,
                   "directories that `generate --shard` or `evaluate --shard` wrote")
      ->required();
  merge->add_option("--out", options->out, "directory to make")->required()->check(NotEmpty());
  merge->callback([options, answer] { *answer = MergeShards(*options); });
}

}  // namespace smile::app
