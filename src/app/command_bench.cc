// `smile bench`: measures the documented performance on the machine at hand.

#include <CLI/CLI.hpp>
#include <memory>

#include "app/bench_baseline.h"
#include "app/commands.h"
#include "app/exit_code.h"
#include "app/options.h"
#include "bench/benchmarks.h"
#include "report/paired_comparison.h"

namespace smile::app {
namespace {

constexpr double kSecondsPerRound = 0.1;  ///< duration of a measurement beside a baseline

struct BenchCommandOptions {
  bench::BenchOptions bench;
  std::string baseline;
  std::size_t rounds = 8;
};

int BenchOrCompare(const BenchCommandOptions& options) {
  if (!options.baseline.empty()) {
    return CompareWithBaseline({.baseline = options.baseline,
                                .filter = options.bench.filter,
                                .min_time = options.bench.min_time.value_or(kSecondsPerRound),
                                .rounds = options.rounds,
                                .json = options.bench.json});
  }
  bench::RunBenchmarks(options.bench);
  return kDone;
}

}  // namespace

void AddBench(CLI::App* program, ExitAnswer answer) {
  auto options = std::make_shared<BenchCommandOptions>();
  CLI::App* command = program->add_subcommand(
      "bench", "Measure the performance figures of the documentation on this machine");
  command->add_option("--filter", options->bench.filter,
                      "regular expression; only benchmarks with a matching name (default: all)");
  CLI::Option* baseline =
      command
          ->add_option("--baseline", options->baseline,
                       "program `smile` of another build: measure both in turns, and report what "
                       "differs beyond noise; exit code 1 if anything is slower in this build")
          ->check(NotEmpty());
  command
      ->add_option("--rounds", options->rounds,
                   "measurements of each benchmark in each program (default 8)")
      ->check(CLI::Range(static_cast<int>(report::kMinRounds), 1000))
      ->needs(baseline);
  command
      ->add_option("--min-time", options->bench.min_time,
                   "shortest duration of a measurement in seconds (default 0.5; 0.1 with "
                   "--baseline)")
      ->check(NumberBetween(0.001, 3600));
  command->add_flag("--json", options->bench.json, "result as JSON on stdout");
  command->callback([options, answer] { *answer = BenchOrCompare(*options); });
}

}  // namespace smile::app
