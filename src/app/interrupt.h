#pragma once

namespace smile::app {

/// Makes Ctrl-C, SIGTERM and SIGHUP end the program cleanly instead of killing it. A second one
/// kills it.
void CatchInterrupts();

/// Returns true once the user has interrupted the program.
bool IsInterrupted();

}  // namespace smile::app
