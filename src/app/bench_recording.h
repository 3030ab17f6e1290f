#pragma once

namespace smile::app {

/// Adds the benchmarks of recording, undo and replay.
void RegisterRecordingBenchmarks();

}  // namespace smile::app
