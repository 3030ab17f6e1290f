// fork() and exec() with all the care that a program with threads needs: between the two, the child
// calls only async-signal-safe functions on memory that the parent prepared. The chain is simulator
// -> smile-supervisor -> program (see supervisor/supervisor.cc).

#include "process/child_process.h"

#include <fcntl.h>
#include <linux/close_range.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <stdexcept>
#include <system_error>

#include "base/library_folder.h"

extern char** environ;

namespace smile::process {
namespace {

constexpr int kFirstOwnFd = 3;
// Sleeping and looking is simple, and a program's end that is noticed 2 ms late does not matter.
constexpr int kPollSliceMs = 2;
// Longer than the supervisor's own limit (kKillTime), so that it ends by itself.
constexpr double kSupervisorSeconds = 2;  ///< for ending all that it keeps; a busy machine is slow

[[noreturn]] void Fail(const std::string& program, const char* what, int error) {
  throw std::runtime_error(program + ": " + what + ": " + std::strerror(error));
}

struct Pipe {
  UniqueFd read_end, write_end;
};

Pipe MakePipe(const std::string& program) {
  int ends[2];
  if (::pipe2(ends, O_CLOEXEC) != 0) Fail(program, "no pipe", errno);
  return {UniqueFd(ends[0]), UniqueFd(ends[1])};
}

/// Data that the child needs between fork and exec, prepared by the parent: the child must not
/// allocate.
struct Launch {
  std::vector<char*> arguments;
  std::vector<char*> environment;
  const char* working_directory;
  int input;
  int output;
  int failure;
  pid_t parent;
  ResourceLimits limits;
};

/// Returns the path of `smile-supervisor`: next to the running program, in the Python package that
/// this code was installed with, or where it was built.
/// @throws std::runtime_error if it is in none of these places.
std::string FindSupervisor() {
  std::error_code error;
  // Beside the program after installation; tests and tools of the build run from other folders.
  const auto self = std::filesystem::read_symlink("/proc/self/exe", error);
  const std::filesystem::path places[] = {self.parent_path() / "smile-supervisor",
                                          LibraryFolder() / "bin" / "smile-supervisor",
                                          SMILE_SUPERVISOR};
  std::string looked_at;
  for (const auto& place : places) {
    if (place.is_absolute() && std::filesystem::exists(place, error)) return place.string();
    looked_at += "\n  " + place.string();
  }
  throw std::runtime_error("smile-supervisor: not found; looked at" + looked_at);
}

/// Sets a limit, which the program cannot raise again.
/// @returns false with errno if the system refuses.
bool SetLimit(decltype(RLIMIT_CPU) resource, const std::optional<std::uint64_t>& limit) {
  if (!limit) return true;
  const rlimit values{*limit, *limit};
  return ::setrlimit(resource, &values) == 0;
}

/// Runs in the child; calls only async-signal-safe functions, since the parent has threads.
[[noreturn]] void RunChild(const Launch& launch) {
  // A group of its own: Ctrl+C in the terminal reaches the simulator only, which then ends the
  // brain properly.
  ::setpgid(0, 0);
  ::prctl(PR_SET_PDEATHSIG, SIGTERM);            // by which a supervisor ends all it keeps
  bool is_ready = ::getppid() == launch.parent;  // else the parent has died already

  // Handlers and masks of the parent must not be inherited by the program.
  struct sigaction plain = {};
  plain.sa_handler = SIG_DFL;
  for (int number = 1; number < NSIG; ++number) ::sigaction(number, &plain, nullptr);
  sigset_t none;
  sigemptyset(&none);
  ::sigprocmask(SIG_SETMASK, &none, nullptr);

  is_ready = is_ready && ::dup2(launch.input, STDIN_FILENO) >= 0 &&
             ::dup2(launch.output, STDOUT_FILENO) >= 0 &&
             ::dup2(launch.output, STDERR_FILENO) >= 0 && ::chdir(launch.working_directory) == 0 &&
             SetLimit(RLIMIT_CPU, launch.limits.cpu_seconds) &&
             SetLimit(RLIMIT_DATA, launch.limits.memory_bytes) &&
             SetLimit(RLIMIT_FSIZE, launch.limits.file_bytes);
  if (is_ready) {
    // Only the standard streams and the failure pipe survive exec.
    ::close_range(kFirstOwnFd, ~0u, CLOSE_RANGE_CLOEXEC);
    ::fcntl(launch.failure, F_SETFD, 0);  // the supervisor reports on it, too
    ::execve(launch.arguments[0], launch.arguments.data(), launch.environment.data());
  }
  // The failure pipe reports errno to the parent. Without failure it closes on exec, and the parent
  // reads end of file.
  const int error = errno;
  (void)!::write(launch.failure, &error, sizeof error);
  ::_exit(127);
}

std::vector<char*> Pointers(std::vector<std::string>& texts) {
  std::vector<char*> pointers;
  for (std::string& text : texts) pointers.push_back(text.data());
  pointers.push_back(nullptr);
  return pointers;
}

/// Returns the environment of this process with variables added or replaced.
std::vector<std::string> EnvironmentWith(
    const std::vector<std::pair<std::string, std::string>>& added) {
  std::vector<std::string> lines;
  for (char** line = environ; *line; ++line) {
    const std::string_view inherited(*line);
    // A name must not occur twice: which of two values getenv() returns is not specified.
    bool is_replaced = false;
    for (const auto& [name, value] : added) is_replaced |= inherited.starts_with(name + "=");
    if (!is_replaced) lines.emplace_back(inherited);
  }
  for (const auto& [name, value] : added) lines.push_back(name + "=" + value);
  return lines;
}

/// fork() with all signals blocked, so that none of the parent's handlers runs in the child.
pid_t ForkQuietly(const Launch& launch) {
  // All signals, in the calling thread only: fork() copies just this thread, with its mask.
  // RunChild() resets handlers before it unblocks.
  sigset_t all, before;
  sigfillset(&all);
  ::pthread_sigmask(SIG_SETMASK, &all, &before);
  const pid_t pid = ::fork();
  if (pid == 0) RunChild(launch);
  const int error = errno;
  ::pthread_sigmask(SIG_SETMASK, &before, nullptr);
  errno = error;
  return pid;
}

std::string DescribeEnd(int status) {
  // The supervisor ends the way its program ended, so this is the status of the program.
  if (WIFSIGNALED(status)) {
    return "it was ended by signal " + std::to_string(WTERMSIG(status)) + " (" +
           ::strsignal(WTERMSIG(status)) + ")";
  }
  return "it ended with exit code " + std::to_string(WEXITSTATUS(status));
}

}  // namespace

ChildProcess::ChildProcess(const ChildCommand& command) {
  const std::string& program = command.arguments.at(0);
  std::vector<std::string> environment = EnvironmentWith(command.environment);
  const std::string directory = command.working_directory.string();

  UniqueFd input(::open("/dev/null", O_RDONLY | O_CLOEXEC));
  if (!input) Fail(program, "/dev/null", errno);
  Pipe output = MakePipe(program);
  Pipe failure = MakePipe(program);
  // Everything that allocates happens before the fork, including the check that the supervisor
  // exists.
  std::vector<std::string> arguments{FindSupervisor(), std::to_string(failure.write_end.get())};
  arguments.insert(arguments.end(), command.arguments.begin(), command.arguments.end());
  pid_ = ForkQuietly({.arguments = Pointers(arguments),
                      .environment = Pointers(environment),
                      .working_directory = directory.c_str(),
                      .input = input.get(),
                      .output = output.write_end.get(),
                      .failure = failure.write_end.get(),
                      .parent = ::getpid(),
                      .limits = command.limits});
  if (pid_ < 0) Fail(program, "cannot be started", errno);
  ::setpgid(pid_, pid_);  // parent and child both do it, so it is done whichever runs first

  // Blocks until the pipe closes, that is until both programs have been executed, or one reports
  // its failure. The parent's copy must be closed, or the read would wait for itself.
  failure.write_end.Close();
  int error = 0;
  ssize_t count = 0;
  do {
    count = ::read(failure.read_end.get(), &error, sizeof error);
  } while (count < 0 && errno == EINTR);
  if (count > 0) {
    End();
    throw CannotRun(program + ": cannot be started: " + std::strerror(error), error);
  }
  ::fcntl(output.read_end.get(), F_SETFL, O_NONBLOCK);
  output_ = std::move(output.read_end);
}

bool ChildProcess::HasEnded() const {
  if (pid_ < 0) return true;
  siginfo_t info = {};
  // WNOWAIT leaves the child in place, so that its number is not reused.
  const int result = ::waitid(P_PID, static_cast<id_t>(pid_), &info, WEXITED | WNOHANG | WNOWAIT);
  // With WNOHANG and no change of state, waitid() succeeds and leaves si_pid at 0.
  return result == 0 ? info.si_pid == pid_ : errno == ECHILD;
}

bool ChildProcess::WaitForEnd(const WaitLimit& limit) const {
  while (!HasEnded()) {
    if (limit.HasPassed() || limit.IsCancelled()) return false;
    const timespec slice{.tv_sec = 0, .tv_nsec = kPollSliceMs * 1'000'000L};
    ::nanosleep(&slice, nullptr);
  }
  return true;
}

void ChildProcess::SignalGroup(int signal_number) const {
  if (pid_ > 0) ::kill(pid_, signal_number);  // the supervisor hands it on
}

const std::string& ChildProcess::End() {
  if (pid_ < 0) return how_it_ended_;
  // Until the child is collected, its number is not reused, so no other process is hit. SIGHUP
  // asks the supervisor to end all its descendants and then itself. Only a supervisor that does not
  // manage this in time is killed, and its program with it (parent-death signal).
  ::kill(pid_, SIGHUP);
  ::kill(pid_, SIGCONT);  // a program may have stopped its supervisor
  if (!WaitForEnd(WaitLimit(kSupervisorSeconds))) ::kill(pid_, SIGKILL);
  int status = 0;
  pid_t collected = -1;
  do {
    collected = ::waitpid(pid_, &status, 0);
  } while (collected < 0 && errno == EINTR);
  how_it_ended_ = collected == pid_ ? DescribeEnd(status) : "it ended";
  if (collected == pid_ && WIFEXITED(status)) exit_code_ = WEXITSTATUS(status);
  pid_ = -1;
  return how_it_ended_;
}

}  // namespace smile::process
