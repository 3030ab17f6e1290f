#pragma once

namespace smile::bench {

/// Adds the benchmarks of recording, undo and replay.
void RegisterRecordingBenchmarks();

}  // namespace smile::bench
