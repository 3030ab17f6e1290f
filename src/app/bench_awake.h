#pragma once

namespace smile::app {

/// Adds the benchmarks of scenes in which no object sleeps, with what their physics is worth.
void RegisterAwakeBenchmarks();

}  // namespace smile::app
