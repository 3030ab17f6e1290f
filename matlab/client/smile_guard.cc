// SMILE_GUARD  Lets SIGUSR2 raise an ordinary error in the running Octave code.
//
// A signal arriving in the middle of `while true, end` or `pause(30)` becomes an error that can be
// caught, with file and line, and every variable stays. Octave looks at octave_signal_caught where
// it is safe to stop and then calls octave_signal_hook (octave/quit.h). Octave only.

#include <octave/error.h>
#include <octave/oct.h>
#include <octave/quit.h>

#include <csignal>

namespace {

volatile std::sig_atomic_t is_asked = 0;
void (*previous_hook)() = nullptr;

void OnSignal(int) {
  is_asked = 1;
  octave_signal_caught = 1;
}

void RaiseWhenAsked() {
  if (previous_hook) previous_hook();
  if (!is_asked) return;
  is_asked = 0;
  error_with_id("smile:timeout", "this took too long and was stopped");
}

}  // namespace

DEFUN_DLD(smile_guard, , , "From now on SIGUSR2 raises the error smile:timeout.") {
  if (octave_signal_hook != RaiseWhenAsked) {
    previous_hook = octave_signal_hook;
    octave_signal_hook = RaiseWhenAsked;
  }
  struct sigaction action = {};
  action.sa_handler = OnSignal;
  sigaction(SIGUSR2, &action, nullptr);
  return octave_value_list();
}
