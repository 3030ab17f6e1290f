#pragma once

namespace smile::app {

/// From now on Ctrl-C, SIGTERM and SIGHUP ask the program to end cleanly instead of killing it. A
/// second one kills it all the same.
void CatchInterrupts();

/// True once the user has asked to end.
bool IsInterrupted();

}  // namespace smile::app
