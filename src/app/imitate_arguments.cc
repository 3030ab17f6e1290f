#include "app/imitate_arguments.h"

#include <cmath>

#include "base/wording.h"

namespace smile::app {
namespace {

constexpr std::size_t kMaxJobs = 1024, kMinSlurmShards = 2, kMaxSlurmShards = 1'000'000;

}  // namespace

void AddImitateSettings(CLI::App* command, ImitateSettings* settings) {
  command
      ->add_option("--seconds", settings->max_seconds,
                   "time limit per run in seconds of simulated time")
      ->capture_default_str()
      ->check(NumberBetween(0.0, 86400.0));
  AddTimeoutOption(command, /*brain=*/nullptr, &settings->timeout);
  AddOracleOption(command, &settings->oracle);
  AddRobotOptions(command, /*may_be_absent=*/false, &settings->robot);
  AddPathOption(command, &settings->path);
}

void AddPoolOptions(CLI::App* command, PoolOptions* options) {
  command
      ->add_option("--jobs", options->jobs, "number of concurrent runs (default: number of cores)")
      ->check(CLI::Range(std::size_t{1}, kMaxJobs));
  command
      ->add_option("--wall-seconds", options->wall_seconds,
                   "time limit per run in seconds of wall-clock time; a longer run counts as hung")
      ->capture_default_str()
      ->check(NumberBetween(0.1, 1e6));
  CLI::Option* shard = command->add_option(
      "--shard", options->shard,
      "part of the work to do, as 2/8: the second of eight shards, which `smile merge` joins");
  command
      ->add_option("--slurm", options->slurm_shards,
                   "submit the work to Slurm, in this number of shards of --jobs cores each "
                   "(default: 1), and a job that joins them")
      ->check(CLI::Range(kMinSlurmShards, kMaxSlurmShards))
      ->excludes(shard);
}

std::vector<std::string> ArgumentsOf(const ImitateSettings& settings, const std::string& eye,
                                     const std::string& noise) {
  std::vector<std::string> arguments{"--seconds", NumberText(settings.max_seconds)};
  const auto add = [&arguments](const char* name, const std::string& value) {
    if (!value.empty()) arguments.insert(arguments.end(), {name, value});
  };
  const auto add_flag = [&arguments](const char* name, bool is_set) {
    if (is_set) arguments.emplace_back(name);
  };
  add("--timeout", NumberText(settings.timeout));
  if (eye != EyeOptions().camera) add("--eye", eye);
  add("--size", settings.size);
  add("--noise", noise);
  add("--plan", settings.plan);
  add_flag("--oracle", settings.oracle);
  add("--robot", settings.robot.urdf);
  add("--side-file", settings.robot.side_file);
  add("--gripper", settings.robot.gripper);
  add_flag("--classic", settings.robot.classic);
  add_flag("--kinematic", settings.robot.body.is_kinematic);
  add_flag("--friction-grasp", settings.robot.body.grasps_by_friction);
  for (const std::string& root : settings.path.roots) add("--path", root);
  return arguments;
}

std::string TimeLeftText(double seconds) {
  // In minutes from 90 s on.
  const bool is_long = seconds >= 90;
  return ", about " + NumberText(std::ceil(seconds / (is_long ? 60 : 1))) +
         (is_long ? " min" : " s") + " left";
}

}  // namespace smile::app
