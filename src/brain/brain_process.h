#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <string_view>

#include "brain/brain_values.h"

namespace smile::brain {

/// How an Octave or Matlab program is connected.
enum class BrainTransport {
  kAutomatic,  ///< kMex when it was built, else kPlain
  kMex,        ///< a socket and a small compiled client
  kPlain,      ///< a pair of pipes and a client in plain .m
};

/// Default timeout of a callback [s of wall-clock time]: busy machines are slow.
inline constexpr double kCallbackSeconds = 5;
/// The start, to the end of init, may take so many times as long as a callback.
inline constexpr double kStartFactor = 12;

struct BrainOptions {
  double start_seconds = kStartFactor * kCallbackSeconds;  ///< to the end of init, wall clock
  double callback_seconds = kCallbackSeconds;              ///< for each callback, wall clock
  BrainTransport transport = BrainTransport::kAutomatic;
  /// What the program prints, line by line, cleaned for a terminal and limited in rate. Called on
  /// another thread; must not throw.
  std::function<void(std::string_view line)> on_output;
  /// Asked every 50 ms or so while waiting for the program; true stops it.
  std::function<bool()> is_cancelled;
  /// For debuggers: the program is not started here but by a person, as `on_waiting` is told, and
  /// may take all the time it likes.
  bool is_attached = false;
  /// Told, when attached, what to type in another terminal: several lines; then, who came and was
  /// no brain.
  std::function<void(std::string_view instructions)> on_waiting;
};

/// Options with another timeout of callbacks, and the one of the start that follows from it.
inline BrainOptions WithTimeout(double callback_seconds) {
  return {.start_seconds = kStartFactor * callback_seconds, .callback_seconds = callback_seconds};
}

/// A robot program, running in a process of its own.
///
/// A brain is a folder with `agentBehavior.m` (run by GNU Octave or Matlab), a Python file, or an
/// executable file that speaks the protocol of docs/brain-protocol.md (smile::agent does, for
/// C++). It works in its folder's parent, in a process group of its own, and whatever it does
/// (crash, endless loop, nonsense, floods of output) becomes a BrainError in bounded time. After an
/// error the process is gone; it is never started again by itself. The wall clock is used by the
/// watchdog only: answers do not depend on it.
///
/// The process dies with the thread that called Init(), so that nothing outlives a crash: call from
/// the thread that runs the simulation, or see BrainThread.
class BrainProcess {
 public:
  /// Looks at the brain; starts nothing yet.
  /// @throws InputError when there is no such brain or it is of no known kind.
  /// @throws std::runtime_error when what runs it is not installed.
  explicit BrainProcess(const std::filesystem::path& brain, BrainOptions options = {});
  BrainProcess(BrainProcess&&) noexcept;
  BrainProcess& operator=(BrainProcess&&) noexcept;
  /// Says goodbye, waits a second, then kills: the whole group.
  ~BrainProcess();

  /// Starts the program and runs its init script.
  /// @throws std::logic_error when it was started before.
  /// @throws std::runtime_error when the machine gives no process, pipe or folder.
  OrError<InitReply> Init(const Aux& aux);

  /// Runs its callback script once.
  /// @throws std::logic_error unless is_running().
  OrError<StepReply> Step(const Sensor& sensor);

  /// Init() or Step(), whatever is asked for.
  BrainAnswer Answer(const BrainQuestion& question);

  /// Ends the program as the destructor does.
  void Stop();

  /// From a successful Init() until an error, a step with `exit`, or Stop().
  bool is_running() const;

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace smile::brain
