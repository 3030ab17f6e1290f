#pragma once

namespace smile::app {

/// Adds the benchmarks of cost against the number of objects.
void RegisterGrowthBenchmarks();

}  // namespace smile::app
