#include "bench/measured_program.h"

#include <unistd.h>

#include <optional>
#include <regex>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "base/files.h"
#include "base/json.h"
#include "bench/scratch_folder.h"
#include "process/child_process.h"

namespace smile::bench {
namespace {

constexpr std::size_t kMaxOutputBytes = 1 << 24;
constexpr double kMaxSeconds = 3600;  ///< of one measurement

struct Output {
  std::optional<int> exit_code;
  std::string how_it_ended, out, err;
};

/// Runs `smile bench` to its end. A shell keeps its two outputs apart, in files.
Output RunBench(const std::filesystem::path& program, const std::vector<std::string>& arguments,
                std::vector<std::pair<std::string, std::string>> environment,
                const std::function<bool()>& is_interrupted) {
  const ScratchFolder folder;
  std::vector<std::string> words{"/bin/sh", "-c", R"(exec "$0" bench "$@" >out 2>err)",
                                 program.string()};
  words.insert(words.end(), arguments.begin(), arguments.end());
  process::ChildProcess child({.arguments = std::move(words),
                               .environment = std::move(environment),
                               .working_directory = folder.path()});
  const bool has_ended = child.WaitForEnd(process::WaitLimit(kMaxSeconds, is_interrupted));
  Output output{.how_it_ended = child.End()};
  if (is_interrupted()) throw std::runtime_error("interrupted");
  if (!has_ended) output.how_it_ended = "it was still running after an hour";
  if (has_ended) output.exit_code = child.exit_code();
  output.out = ReadFile(folder.path() / "out", kMaxOutputBytes);
  output.err = ReadFile(folder.path() / "err", kMaxOutputBytes);
  return output;
}

/// Returns what went wrong, with the first line of what the program printed on stderr.
std::string FailureOf(const Output& output) {
  const std::string line = output.err.substr(0, output.err.find('\n'));
  return line.empty() ? output.how_it_ended : output.how_it_ended + ": " + line;
}

/// Returns a regular expression that matches only this name.
std::string ExactFilter(const std::string& name) {
  return "^" + std::regex_replace(name, std::regex(R"([.\[\](){}*+?^$|\\])"), R"(\$&)") + "$";
}

double NanosecondsOf(const std::string& unit) {
  if (unit == "ns") return 1;
  if (unit == "us") return 1e3;
  if (unit == "ms") return 1e6;
  return 1e9;
}

}  // namespace

MeasuredProgram::MeasuredProgram(const std::filesystem::path& program,
                                 std::function<bool()> is_interrupted)
    : program_(std::filesystem::absolute(program)), is_interrupted_(std::move(is_interrupted)) {
  if (!std::filesystem::is_regular_file(program_) || ::access(program_.c_str(), X_OK) != 0)
    throw std::invalid_argument(program.string() +
                                ": no such program, expected the program `smile` of a build");
  const Output output = RunBench(program_, {}, {{"BENCHMARK_LIST_TESTS", "true"}}, is_interrupted_);
  std::istringstream lines(output.out);
  for (std::string line; std::getline(lines, line);) names_.push_back(line);
  if (output.exit_code != 0 || names_.empty())
    throw std::invalid_argument(program.string() + ": `bench` lists no benchmarks (" +
                                FailureOf(output) + "), expected the program `smile` of a build");
}

std::variant<double, std::string> MeasuredProgram::Measure(const std::string& name,
                                                           double min_time) const {
  const Output output =
      RunBench(program_, {"--json", "--filter", ExactFilter(name)},
               {{"BENCHMARK_MIN_TIME", std::to_string(min_time)}}, is_interrupted_);
  const auto fail = [&](const std::string& what) {
    throw std::runtime_error(program_.string() + ": benchmark '" + name + "': " + what);
  };
  if (output.exit_code != 0) fail(FailureOf(output));
  Json row;
  try {
    row = ParseJson(output.out).at("benchmarks").at(0);
    if (row.value("error_occurred", false)) return row.value("error_message", std::string());
    // Names of benchmarks that do not measure CPU time end with what they measure instead.
    const bool is_wall_clock = name.ends_with("/real_time") || name.ends_with("/manual_time");
    const double time = row.at(is_wall_clock ? "real_time" : "cpu_time").get<double>() *
                        NanosecondsOf(row.at("time_unit").get<std::string>());
    if (time > 0) return time;
    return "it takes no measurable time";
  } catch (const std::exception& error) {
    fail(std::string("its result cannot be read: ") + error.what());
  }
  return std::string();
}

}  // namespace smile::bench
