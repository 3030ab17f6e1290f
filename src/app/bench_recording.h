#pragma once

namespace smile::app {

/// Adds what we claim of recording, undo and replay to the benchmarks.
void RegisterRecordingBenchmarks();

}  // namespace smile::app
