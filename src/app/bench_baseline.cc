// Comparison of two builds. All benchmarks are measured in rounds; in a round each benchmark runs
// in both programs, one right after the other, and the program that is first alternates. Each
// measurement is a process of its own, so that a lucky layout of its memory does not last for all
// rounds. Benchmarks that seem to differ are measured in as many rounds again.

#include "app/bench_baseline.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <optional>
#include <regex>
#include <span>
#include <stdexcept>
#include <variant>
#include <vector>

#include "app/exit_code.h"
#include "app/interrupt.h"
#include "app/progress.h"
#include "base/json.h"
#include "bench/measured_program.h"
#include "report/paired_comparison.h"

namespace smile::app {
namespace {

using bench::MeasuredProgram;
using report::SpeedDifference;
using report::TimePair;

/// Benchmark that both programs have.
struct SharedBenchmark {
  std::string name;
  std::vector<TimePair> rounds;  ///< [ns]; empty once it could not be measured
  std::string error;             ///< the reason why not
  report::PairedComparison comparison;
};

/// Benchmarks by the programs that have them.
struct SharedBenchmarks {
  std::vector<SharedBenchmark> both;
  std::vector<std::string> only_baseline, only_current;
};

SharedBenchmarks MatchBenchmarks(const MeasuredProgram& baseline, const MeasuredProgram& current,
                                 const std::string& filter) {
  std::regex expression;
  try {
    expression = std::regex(filter, std::regex::extended);
  } catch (const std::regex_error&) {
    throw std::invalid_argument("--filter: '" + filter + "' is not a regular expression");
  }
  const auto has = [](const MeasuredProgram& program, const std::string& name) {
    return std::ranges::find(program.names(), name) != program.names().end();
  };
  SharedBenchmarks rows;
  for (const std::string& name : current.names()) {
    if (!std::regex_search(name, expression)) continue;
    if (has(baseline, name)) {
      rows.both.push_back({.name = name});
    } else {
      rows.only_current.push_back(name);
    }
  }
  for (const std::string& name : baseline.names()) {
    if (std::regex_search(name, expression) && !has(current, name))
      rows.only_baseline.push_back(name);
  }
  if (rows.both.empty())
    throw std::invalid_argument("the two programs share no benchmark with a name like '" + filter +
                                "'");
  return rows;
}

/// Measures rows in rounds, and shows how far it is.
class RoundRunner {
 public:
  RoundRunner(const MeasuredProgram& baseline, const MeasuredProgram& current,
              const BaselineOptions& options)
      : baseline_(baseline), current_(current), options_(options), progress_("bench") {}

  /// Adds options.rounds rounds to each row.
  void Run(std::span<SharedBenchmark* const> rows, const char* step) {
    const auto start = std::chrono::steady_clock::now();
    const double total = static_cast<double>(options_.rounds * rows.size());
    double done = 0;
    for (std::size_t round = 0; round < options_.rounds; ++round) {
      for (SharedBenchmark* row : rows) {
        const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - start;
        Show(step, round, *row, done > 0 ? passed.count() * (total - done) / done : NAN);
        if (row->error.empty()) AddRound(round, row);
        ++done;
      }
    }
  }

 private:
  void Show(const char* step, std::size_t round, const SharedBenchmark& row, double seconds_left) {
    std::string words = std::string(step) + ", round " + std::to_string(round + 1) + " of " +
                        std::to_string(options_.rounds);
    if (std::isfinite(seconds_left))
      words += ", about " + std::to_string(std::lround(seconds_left)) + " s left";
    progress_.Say(words + ": " + row.name);
  }

  void AddRound(std::size_t round, SharedBenchmark* row) {
    const bool is_baseline_first = round % 2 == 0;
    const MeasuredProgram& first = is_baseline_first ? baseline_ : current_;
    const MeasuredProgram& second = is_baseline_first ? current_ : baseline_;
    std::variant<double, std::string> times[2];
    times[0] = first.Measure(row->name, options_.min_time);
    if (std::holds_alternative<double>(times[0]))
      times[1] = second.Measure(row->name, options_.min_time);
    for (const auto& time : times) {
      if (const auto* error = std::get_if<std::string>(&time)) {
        row->error = *error;
        row->rounds.clear();
        return;
      }
    }
    const double a = std::get<double>(times[0]), b = std::get<double>(times[1]);
    row->rounds.push_back(is_baseline_first ? TimePair{a, b} : TimePair{b, a});
  }

  const MeasuredProgram& baseline_;
  const MeasuredProgram& current_;
  const BaselineOptions& options_;
  ProgressLine progress_;
};

/// Measures all rows, and again those that seem to differ.
void Compare(RoundRunner* runner, std::size_t num_rounds, std::vector<SharedBenchmark>* rows) {
  std::vector<SharedBenchmark*> all, suspects;
  for (SharedBenchmark& row : *rows) all.push_back(&row);
  runner->Run(all, "all benchmarks");
  for (SharedBenchmark* row : all) {
    if (!row->error.empty()) continue;
    row->comparison = report::ComparePairs(row->rounds);
    if (row->comparison.difference != SpeedDifference::kWithinNoise) suspects.push_back(row);
  }
  runner->Run(suspects, "differences again");
  for (SharedBenchmark* row : suspects) {
    if (!row->error.empty()) continue;
    const std::span<const TimePair> rounds(row->rounds);
    row->comparison =
        report::ConfirmDifference(rounds.first(num_rounds), rounds.subspan(num_rounds));
  }
}

const char* WordOf(SpeedDifference difference) {
  if (difference == SpeedDifference::kSlower) return "slower beyond noise";
  if (difference == SpeedDifference::kFaster) return "faster beyond noise";
  return "no difference";
}

/// Returns a duration in the unit that gives it one to three digits before the point.
std::string DurationText(double ns) {
  char text[32];
  const auto [divisor, unit] = ns < 1e3   ? std::pair(1.0, "ns")
                               : ns < 1e6 ? std::pair(1e3, "us")
                               : ns < 1e9 ? std::pair(1e6, "ms")
                                          : std::pair(1e9, "s");
  std::snprintf(text, sizeof text, "%.4g %s", ns / divisor, unit);
  return text;
}

void PrintNames(const char* title, const std::vector<std::string>& names) {
  if (names.empty()) return;
  std::printf("\n%s:\n", title);
  for (const std::string& name : names) std::printf("  %s\n", name.c_str());
}

void PrintTable(const SharedBenchmarks& rows) {
  std::size_t width = 9;
  for (const SharedBenchmark& row : rows.both) width = std::max(width, row.name.size());
  const int columns = static_cast<int>(width);
  std::printf("%-*s  %10s  %10s  %6s  %s\n", columns, "benchmark", "baseline", "this", "ratio",
              "between");
  std::vector<std::string> errors;
  int num_slower = 0, num_faster = 0, num_equal = 0;
  for (const SharedBenchmark& row : rows.both) {
    if (!row.error.empty()) {
      errors.push_back(row.name + ": " + row.error);
      continue;
    }
    const report::PairedComparison& result = row.comparison;
    (result.difference == SpeedDifference::kSlower   ? num_slower
     : result.difference == SpeedDifference::kFaster ? num_faster
                                                     : num_equal) += 1;
    std::printf("%-*s  %10s  %10s  %6.3f  %.3f..%.3f  %s\n", columns, row.name.c_str(),
                DurationText(result.baseline).c_str(), DurationText(result.current).c_str(),
                result.ratio, result.interval.low, result.interval.high, WordOf(result.difference));
  }
  PrintNames("not measured", errors);
  PrintNames("only in the baseline", rows.only_baseline);
  PrintNames("only in this program", rows.only_current);
  std::printf("\n%d slower beyond noise, %d faster, %d without a difference\n", num_slower,
              num_faster, num_equal);
}

void PrintJson(const MeasuredProgram& baseline, const BaselineOptions& options,
               const SharedBenchmarks& rows) {
  Json benchmarks = Json::array();
  for (const SharedBenchmark& row : rows.both) {
    const report::PairedComparison& result = row.comparison;
    if (!row.error.empty()) {
      benchmarks.push_back({{"name", row.name}, {"error", row.error}});
      continue;
    }
    benchmarks.push_back({{"name", row.name},
                          {"baseline_ns", result.baseline},
                          {"this_ns", result.current},
                          {"ratio", result.ratio},
                          {"interval", {result.interval.low, result.interval.high}},
                          {"rounds", row.rounds.size()},
                          {"verdict", WordOf(result.difference)}});
  }
  const Json result{{"baseline", baseline.program().string()},
                    {"rounds", options.rounds},
                    {"min_time", options.min_time},
                    {"benchmarks", benchmarks},
                    {"only_in_the_baseline", rows.only_baseline},
                    {"only_in_this_program", rows.only_current}};
  std::printf("%s\n", ToText(result, 2).c_str());
}

}  // namespace

int CompareWithBaseline(const BaselineOptions& options) {
  const MeasuredProgram baseline(options.baseline, &IsInterrupted);
  const MeasuredProgram current(std::filesystem::read_symlink("/proc/self/exe"), &IsInterrupted);
  SharedBenchmarks rows = MatchBenchmarks(baseline, current, options.filter);
  RoundRunner runner(baseline, current, options);
  Compare(&runner, options.rounds, &rows.both);
  if (options.json) {
    PrintJson(baseline, options, rows);
  } else {
    PrintTable(rows);
  }
  const bool is_slower = std::ranges::any_of(rows.both, [](const SharedBenchmark& row) {
    return row.comparison.difference == SpeedDifference::kSlower;
  });
  return is_slower ? kInputWrong : kDone;
}

}  // namespace smile::app
