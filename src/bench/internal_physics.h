#pragma once

namespace smile::bench {

/// Adds the benchmarks of what physics costs and what it is worth.
void RegisterPhysicsBenchmarks();

}  // namespace smile::bench
