#pragma once

#include <optional>
#include <string>

namespace smile::bench {

/// Choice of benchmarks.
struct BenchOptions {
  std::string filter;              ///< regular expression of names; empty: all
  std::optional<double> min_time;  ///< of a measurement [s]; nullopt: the default of the library
  bool json = false;               ///< JSON on stdout in place of a table
};

/// Runs the benchmarks of this program, and prints their results.
/// @throws std::invalid_argument if none has such a name.
void RunBenchmarks(const BenchOptions& options);

}  // namespace smile::bench
