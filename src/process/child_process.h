#pragma once

#include <sys/types.h>

#include <filesystem>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "process/unique_fd.h"
#include "process/wait_limit.h"

namespace smile::process {

struct ChildCommand {
  std::vector<std::string> arguments;                            ///< the program's path first
  std::vector<std::pair<std::string, std::string>> environment;  ///< beside our own
  std::filesystem::path working_directory;
};

/// The system would not run a program.
class CannotRun : public std::runtime_error {
 public:
  CannotRun(const std::string& message, int error_number)
      : std::runtime_error(message), error_number_(error_number) {}
  int error_number() const { return error_number_; }

 private:
  int error_number_;
};

/// A program in a process group of its own, with nothing on its standard input and its output in a
/// pipe. It dies with the thread that started it, and with this object; so does every process that
/// it started, wherever that hid: between us and the program stands `smile-keeper`, which all of
/// them become children of.
class ChildProcess {
 public:
  /// @throws CannotRun naming the program and the reason, std::runtime_error when the machine has
  ///         no room for one more.
  explicit ChildProcess(const ChildCommand& command);
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;
  ~ChildProcess() { End(); }

  /// Standard output and standard error; non-blocking; to be taken once, and read without pause.
  UniqueFd TakeOutput() { return std::move(output_); }

  /// Whether the program has ended, and its own children with it.
  bool HasEnded() const;
  /// @returns HasEnded(), at the latest when the limit has passed.
  bool WaitForEnd(const WaitLimit& limit) const;

  /// Sends SIGUSR2 or SIGINT to the program's group.
  void SignalGroup(int signal_number) const;

  /// Kills what is left, collects the child, and says how it ended: `it ended with exit code 3`.
  const std::string& End();
  /// Of the program, once End() was called; nullopt when a signal ended it.
  std::optional<int> exit_code() const { return exit_code_; }

 private:
  pid_t pid_ = -1;  ///< of its keeper
  std::optional<int> exit_code_;
  UniqueFd output_;
  std::string how_it_ended_;
};

}  // namespace smile::process
