#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "base/json.h"
#include "brain/brain_driver.h"
#include "studio/console.h"

namespace smile::studio {

/// A robot program that may be started.
struct BrainChoice {
  std::string name;  ///< of its folder or file
  std::string kind;  ///< `octave`, `python` or `program`
  std::filesystem::path path;
};

/// All there are in some folders, each in its order by name. Where two have one name, the first
/// folder's counts. A folder that is not there has none.
std::vector<BrainChoice> BrainsIn(const std::vector<std::filesystem::path>& folders);

/// A robot program at work in a simulation, watched by people. Belongs to the thread that runs the
/// simulation.
class LiveBrain {
 public:
  /// @param is_ending  asked while the program is waited for; true stops it.
  explicit LiveBrain(std::function<bool()> is_ending) : is_ending_(std::move(is_ending)) {}

  /// Instead of what ran before.
  /// @throws InputError, std::invalid_argument or std::runtime_error if it cannot be started: see
  ///         brain::BrainProcess and brain::BrainDriver.
  void Start(const BrainChoice& choice, const brain::BrainDriverOptions& options,
             sim::Simulation* simulation);
  /// To be called before each tick.
  void Drive(sim::Simulation* simulation);
  /// The program ends, and the robot stops.
  void Stop(sim::Simulation* simulation);
  /// The program ends with the world it was in.
  void Leave();

  bool is_running() const { return driver_ && driver_->status() == brain::BrainStatus::kRunning; }
  /// `brain` of a state message.
  Json Describe() const;
  /// What was printed since this was last asked.
  std::vector<ConsoleLine> TakeLines() { return console_.Take(); }

 private:
  void NoteError();

  std::function<bool()> is_ending_;
  Console console_;  ///< written to by the process's thread, which ends before it
  std::string name_;
  bool was_stopped_ = false;
  std::optional<brain::BrainProcess> process_;
  std::optional<brain::BrainDriver> driver_;
};

}  // namespace smile::studio
