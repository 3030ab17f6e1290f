#pragma once

#include <filesystem>
#include <string>

namespace smile::app {

struct BaselineOptions {
  std::filesystem::path baseline;  ///< the `smile` program of another build
  std::string filter;              ///< regular expression; empty: all benchmarks
  double min_time = 0;             ///< shortest duration of a measurement [s]
  std::size_t rounds = 0;          ///< at least report::kMinRounds
  bool json = false;
};

/// Measures this program and another build of it in turns, and prints which benchmarks differ
/// beyond the noise; see report/paired_comparison.h.
/// @returns kDone, or kInputWrong if a benchmark is slower in this program.
/// @throws std::invalid_argument if an option is invalid, std::runtime_error if the other program
///         cannot be measured or the user interrupts.
int CompareWithBaseline(const BaselineOptions& options);

}  // namespace smile::app
