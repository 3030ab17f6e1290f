#pragma once

#include "process/child_process.h"

namespace smile::brain {

/// Returns the command that starts Python as for brains, with the shipped modules on its path:
/// arguments are to be added. The interpreter is that of `SMILE_PYTHON`, of the active virtual
/// environment, or the system's.
/// @throws std::runtime_error if there is none.
process::ChildCommand PythonCommand();

}  // namespace smile::brain
