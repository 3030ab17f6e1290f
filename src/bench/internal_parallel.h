#pragma once

namespace smile::bench {

/// Adds the benchmarks of several simulations in one process.
void RegisterParallelBenchmarks();

}  // namespace smile::bench
