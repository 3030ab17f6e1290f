// smile-supervisor FD PROGRAM ARGUMENTS...: runs a program and leaves nothing of it behind.
//
// Whatever the program starts becomes a child of this process when its parent ends, also what left
// the program's process group. So all of it can be found and ended: when the program ends, at
// SIGHUP, and at SIGTERM, which comes when the simulator dies. SIGINT and SIGUSR2 are handed on to
// the program's group. FD receives the error number when the program cannot be run, and is closed
// otherwise. Ends as the program ended.

#include <fcntl.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <system_error>

namespace {

// A process that waits for a device cannot be killed before the device answers; ending must not
// wait for that.
constexpr auto kKillTime = std::chrono::milliseconds(1500);

// These are blocked at all times and fetched one by one with sigwaitinfo(): no handlers, hence no
// code that runs at arbitrary points.
sigset_t KeptSignals() {
  sigset_t signals;
  sigemptyset(&signals);
  for (const int number : {SIGCHLD, SIGTERM, SIGHUP, SIGINT, SIGUSR2}) sigaddset(&signals, number);
  return signals;
}

// A group of its own for the program, so that SIGINT and SIGUSR2 reach all of it but not the
// supervisor. The program dies with its supervisor; the check of the parent covers a supervisor
// that died before prctl().
[[noreturn]] void BecomeProgram(char** command, pid_t supervisor, int failure) {
  ::setpgid(0, 0);
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  sigset_t none;
  sigemptyset(&none);
  ::sigprocmask(SIG_SETMASK, &none, nullptr);
  if (::getppid() == supervisor) ::execv(command[0], command);
  const int error = errno;
  (void)!::write(failure, &error, sizeof error);
  ::_exit(127);
}

/// Collects ended orphans. The program itself is not collected: until it is, no other process gets
/// its number, which is that of its group.
/// @returns whether the program has ended.
bool CollectUpTo(pid_t program) {
  for (;;) {
    // Looks without collecting (WNOWAIT), then collects unless it is the program.
    siginfo_t info = {};
    if (::waitid(P_ALL, 0, &info, WEXITED | WNOHANG | WNOWAIT) != 0) return true;
    if (info.si_pid == 0 || info.si_pid == program) return info.si_pid == program;
    ::waitpid(info.si_pid, nullptr, 0);
  }
}

/// @returns SIGCHLD when the program has ended, else SIGHUP or SIGTERM.
int WaitForTheEnd(pid_t program) {
  const sigset_t signals = KeptSignals();
  for (;;) {
    const int number = ::sigwaitinfo(&signals, nullptr);
    if (number == SIGTERM || number == SIGHUP) return number;
    // Several SIGCHLD may merge into one, so CollectUpTo() collects all that have ended.
    if (number == SIGCHLD && CollectUpTo(program)) return number;
    if (number == SIGINT || number == SIGUSR2) ::kill(-program, number);
  }
}

// /proc lists children by the thread that made them; the supervisor has one thread, whose id is
// that of the process. Orphans are adopted by it, too.
void KillChildren() {
  const std::string self = std::to_string(::getpid());
  std::ifstream children("/proc/self/task/" + self + "/children");
  for (pid_t child = 0; children >> child;) ::kill(child, SIGKILL);
}

/// Kills and collects everything, down to the last orphan.
/// @returns how the program ended, as wait() reports it.
int EndAll(pid_t program) {
  int status = SIGKILL;
  const auto deadline = std::chrono::steady_clock::now() + kKillTime;
  ::kill(-program, SIGKILL);
  // Repeated: each process that dies turns its own children into children of this one. ECHILD means
  // that none is left.
  while (std::chrono::steady_clock::now() < deadline) {
    KillChildren();
    int ended_status = 0;
    pid_t ended = 0;
    while ((ended = ::waitpid(-1, &ended_status, WNOHANG)) > 0) {
      if (ended == program) status = ended_status;
    }
    if (ended < 0 && errno == ECHILD) break;
    ::usleep(500);
  }
  return status;
}

/// A simulator that was killed could not.
void RemoveScratch() {
  const char* named = std::getenv("SMILE_BRAIN_SCRATCH");
  const std::filesystem::path folder = named ? named : "";
  std::error_code ignored;
  if (folder.filename().string().starts_with("smile-brain-")) {
    std::filesystem::remove_all(folder, ignored);
  }
}

[[noreturn]] void ExitWithStatus(int status) {
  if (!WIFSIGNALED(status)) ::_exit(WEXITSTATUS(status));
  const rlimit no_core{0, 0};
  ::setrlimit(RLIMIT_CORE, &no_core);
  // To die of the same signal: without a core file of the supervisor, unblocked, with the default
  // action.
  sigset_t none;
  sigemptyset(&none);
  ::sigprocmask(SIG_SETMASK, &none, nullptr);
  // The default handler must run, not that of a sanitizer.
  ::signal(WTERMSIG(status), SIG_DFL);
  ::raise(WTERMSIG(status));
  ::_exit(128 + WTERMSIG(status));
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 3) return 2;
  const int failure = std::atoi(argv[1]);
  // The program must not inherit it: the simulator waits until all copies are closed.
  ::fcntl(failure, F_SETFD, FD_CLOEXEC);
  // From now on, orphaned descendants become children of this process instead of init's.
  ::prctl(PR_SET_CHILD_SUBREAPER, 1);
  const sigset_t signals = KeptSignals();
  ::sigprocmask(SIG_BLOCK, &signals, nullptr);

  const pid_t supervisor = ::getpid();
  const pid_t program = ::fork();
  if (program == 0) BecomeProgram(argv + 2, supervisor, failure);
  if (program < 0) {
    const int error = errno;
    (void)!::write(failure, &error, sizeof error);
    return 127;
  }
  ::setpgid(program, program);  // the program does the same; either may come first
  ::close(failure);

  const int reason = WaitForTheEnd(program);
  const int status = EndAll(program);
  // SIGTERM means that the simulator died; otherwise, it removes the folder itself.
  if (reason == SIGTERM) RemoveScratch();
  ExitWithStatus(status);
}
