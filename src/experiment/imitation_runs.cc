#include "experiment/imitation_runs.h"

#include <algorithm>
#include <cstdlib>
#include <thread>
#include <utility>

#include "base/diagnostic.h"
#include "base/wording.h"
#include "experiment/program_pool.h"

namespace smile::experiment {
namespace {

std::size_t AtOnce(const RunSettings& settings) {
  // hardware_concurrency() may return 0 where it does not know.
  return settings.jobs > 0 ? settings.jobs : std::max(1u, std::thread::hardware_concurrency());
}

PoolJob JobOf(const ImitationRun& run, const RunSettings& settings) {
  PoolJob job{.command = {.arguments = {settings.program.string()},
                          .environment = {},
                          .working_directory = std::filesystem::current_path()},
              .log = run.folder / "log.txt",
              .max_seconds = settings.wall_seconds};
  job.command.arguments.insert(job.command.arguments.end(), run.arguments.begin(),
                               run.arguments.end());
  // Software rendering shares cores badly: parallel processes are faster with one thread each.
  // The pictures are the same.
  if (AtOnce(settings) > 1 && std::getenv("LP_NUM_THREADS") == nullptr) {
    job.command.environment.emplace_back("LP_NUM_THREADS", "0");
  }
  return job;
}

report::EvaluatedRun FailedRun(std::uint64_t seed, const PoolEnd& end, double wall_seconds) {
  report::EvaluatedRun run{.seed = seed};
  // `no_result` means that the program ended by itself but left no result, `crashed` that a signal
  // ended it.
  if (end.was_late) {
    run.failure_reason = {"hung",
                          "no end after " + NumberText(wall_seconds) + " s of wall-clock time"};
  } else {
    run.failure_reason = {end.exit_code ? "no_result" : "crashed", end.how};
  }
  if (!end.last_line.empty()) run.failure_reason->text += ": " + end.last_line;
  return run;
}

}  // namespace

bool RunImitations(const std::vector<ImitationRun>& runs, const RunSettings& settings,
                   const RunCalls& calls) {
  // The pool refers to jobs by their index, which is that of `runs`.
  std::vector<PoolJob> jobs;
  for (const ImitationRun& run : runs) jobs.push_back(JobOf(run, settings));
  const auto end_run = [&](std::size_t index, const PoolEnd& end) {
    // Exit codes 0 and 1 mean that a result was written: success and failure of the imitation. A
    // late run may have written a result just before it was ended, but wall-clock time must not
    // decide whether it counts.
    const bool may_have_result = !end.was_late && (end.exit_code == 0 || end.exit_code == 1);
    report::EvaluatedRun run = FailedRun(runs[index].seed, end, settings.wall_seconds);
    if (may_have_result) {
      try {
        run = calls.read(index);
      } catch (const InputError&) {
        // The last line of its output gives the reason.
      }
    }
    calls.on_end(index, std::move(run));
  };
  return RunAll(jobs, AtOnce(settings),
                {.on_start = calls.on_start,
                 .on_end = end_run,
                 .on_wait = calls.on_wait,
                 .is_cancelled = calls.is_cancelled});
}

}  // namespace smile::experiment
