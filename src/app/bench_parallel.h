#pragma once

namespace smile::app {

/// Adds the benchmarks of several simulations in one process.
void RegisterParallelBenchmarks();

}  // namespace smile::app
