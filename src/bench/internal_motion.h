#pragma once

namespace smile::bench {

/// Adds the benchmarks of kinematics and planned motions.
void RegisterMotionBenchmarks();

}  // namespace smile::bench
