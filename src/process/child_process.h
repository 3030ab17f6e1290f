#pragma once

#include <sys/types.h>

#include <cstdint>
#include <filesystem>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "process/unique_fd.h"
#include "process/wait_limit.h"

namespace smile::process {

/// Limits of the system on resources of a program and each process that it starts; nullopt: as for
/// this process. See setrlimit(2).
struct ResourceLimits {
  std::optional<std::uint64_t> cpu_seconds;   ///< RLIMIT_CPU: then it is killed
  std::optional<std::uint64_t> memory_bytes;  ///< RLIMIT_DATA: then it gets no more
  std::optional<std::uint64_t> file_bytes;    ///< RLIMIT_FSIZE, of each file: then writing fails
};

struct ChildCommand {
  std::vector<std::string> arguments;                            ///< the program's path first
  std::vector<std::pair<std::string, std::string>> environment;  ///< added to that of this process
  std::filesystem::path working_directory;
  ResourceLimits limits = {};
};

/// Error: the system could not execute a program.
class CannotRun : public std::runtime_error {
 public:
  CannotRun(const std::string& message, int error_number)
      : std::runtime_error(message), error_number_(error_number) {}
  int error_number() const { return error_number_; }

 private:
  int error_number_;
};

/// Program in a process group of its own, with empty standard input and its output in a pipe. It
/// ends with the thread that started it, and with this object; so does every process that it
/// started, wherever it is: `smile-supervisor` runs between this process and the program, and all
/// its descendants are reparented to it.
class ChildProcess {
 public:
  /// @throws CannotRun with the program and the reason, std::runtime_error if resources for a
  ///         process are exhausted.
  explicit ChildProcess(const ChildCommand& command);
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;
  ~ChildProcess() { End(); }

  /// Returns the pipe of standard output and standard error; non-blocking; to be taken once, and
  /// read continuously.
  UniqueFd TakeOutput() { return std::move(output_); }

  /// Returns true if the program has ended, and its own children with it.
  bool HasEnded() const;
  /// Waits for the end of the program.
  /// @returns HasEnded(), at the latest when the limit has passed.
  bool WaitForEnd(const WaitLimit& limit) const;

  /// Sends SIGUSR2 or SIGINT to the program's group.
  void SignalGroup(int signal_number) const;

  /// Kills remaining processes, collects the child, and returns how it ended: `it ended with exit
  /// code 3`.
  const std::string& End();
  /// Returns the program's exit code, after End() was called; nullopt if a signal ended it.
  std::optional<int> exit_code() const { return exit_code_; }

 private:
  pid_t pid_ = -1;  ///< of its supervisor
  std::optional<int> exit_code_;
  UniqueFd output_;
  std::string how_it_ended_;
};

}  // namespace smile::process
