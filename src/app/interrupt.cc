#include "app/interrupt.h"

#include <csignal>

namespace smile::app {
namespace {

volatile std::sig_atomic_t g_interrupted = 0;

void OnSignal(int) { g_interrupted = 1; }

}  // namespace

void CatchInterrupts() {
  struct sigaction action = {};
  action.sa_handler = &OnSignal;
  action.sa_flags = SA_RESETHAND;
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
  sigaction(SIGHUP, &action, nullptr);
  // Writing to a program that went away is an error to report, not a reason to die.
  std::signal(SIGPIPE, SIG_IGN);
}

bool IsInterrupted() { return g_interrupted != 0; }

}  // namespace smile::app
