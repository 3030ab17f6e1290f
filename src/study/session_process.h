#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "process/child_process.h"

namespace smile::study {

/// How a session for one trial is started.
struct SessionPlan {
  std::filesystem::path program;     ///< `smile`
  std::filesystem::path scene;       ///< absolute
  std::filesystem::path recordings;  ///< absolute; exists
  process::ResourceLimits limits;
};

/// `smile studio --participant` in a process of its own, for one trial. Ends with this object.
class SessionProcess {
 public:
  /// @throws process::CannotRun, std::runtime_error if it cannot be started.
  explicit SessionProcess(const SessionPlan& plan);

  /// Reads what the session has printed; to be called often.
  void Update();
  /// Returns the port at 127.0.0.1 at which it serves; nullopt while it starts.
  std::optional<int> port() const { return port_; }
  bool HasEnded() const { return child_.HasEnded(); }
  /// Asks it to end, which finishes its recording.
  void Interrupt() const;
  /// Ends it, and returns how it ended, with the last lines that it printed.
  std::string End();

 private:
  process::ChildProcess child_;
  process::UniqueFd output_;
  std::string printed_;  ///< the last of it
  std::optional<int> port_;
};

}  // namespace smile::study
