#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <variant>
#include <vector>

namespace smile::bench {

/// A `smile` program, this one or one of another build, whose benchmarks run in processes of their
/// own.
///
/// Uses only what every version of `smile bench` understands: `--filter`, `--json`, and the
/// environment variables from which Google Benchmark reads its other options (its user guide,
/// "Command Line"). Therefore any earlier build can be measured.
class MeasuredProgram {
 public:
  /// Reads which benchmarks the program has.
  /// @param is_interrupted  whether the user has interrupted this program.
  /// @throws std::invalid_argument if it is no such program, with what it printed.
  MeasuredProgram(const std::filesystem::path& program, std::function<bool()> is_interrupted);

  const std::filesystem::path& program() const { return program_; }
  /// Returns the names of its benchmarks, in its order.
  const std::vector<std::string>& names() const { return names_; }

  /// Returns the time of one iteration [ns]: CPU time, or wall-clock time if the benchmark measures
  /// that; or the reason why there is none, such as a missing interpreter.
  /// @param min_time  shortest duration of the measurement [s].
  /// @throws std::runtime_error if the program fails or the user interrupts.
  std::variant<double, std::string> Measure(const std::string& name, double min_time) const;

 private:
  std::filesystem::path program_;
  std::function<bool()> is_interrupted_;
  std::vector<std::string> names_;
};

}  // namespace smile::bench
