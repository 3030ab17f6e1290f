#pragma once

namespace smile::app {

/// Adds the benchmarks of what physics costs and what it is worth.
void RegisterPhysicsBenchmarks();

}  // namespace smile::app
