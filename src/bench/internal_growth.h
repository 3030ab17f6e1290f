#pragma once

namespace smile::bench {

/// Adds the benchmarks of cost against the number of objects.
void RegisterGrowthBenchmarks();

}  // namespace smile::bench
