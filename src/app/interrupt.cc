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
  // Writing to a program that has ended is an error to report, and does not end this program.
  std::signal(SIGPIPE, SIG_IGN);
}

bool IsInterrupted() { return g_interrupted != 0; }

}  // namespace smile::app
