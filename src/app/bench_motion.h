#pragma once

namespace smile::app {

/// Adds what we claim of kinematics and of planned motions to the benchmarks.
void RegisterMotionBenchmarks();

}  // namespace smile::app
