#pragma once

namespace smile::app {

/// Adds the benchmarks of kinematics and planned motions.
void RegisterMotionBenchmarks();

}  // namespace smile::app
