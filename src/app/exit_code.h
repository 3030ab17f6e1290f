#pragma once

namespace smile::app {

/// What the program answers with; docs and scripts rely on it.
enum ExitCode {
  kDone = 0,
  kInputWrong = 1,   ///< a scene, script, recording or brain is wrong
  kUsedWrongly = 2,  ///< options make no sense
  kMachineNo = 3,    ///< a file, a disk, a graphics driver refused
};

}  // namespace smile::app
