#pragma once

namespace smile::app {

/// Exit codes of the program; documentation and scripts rely on them.
enum ExitCode {
  kDone = 0,
  kInputWrong = 1,   ///< a scene, script, recording or brain is invalid, or a check failed
  kUsedWrongly = 2,  ///< invalid options
  kMachineNo = 3,    ///< error of a file, disk or graphics driver
};

}  // namespace smile::app
