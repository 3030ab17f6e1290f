#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "recording/progress.h"
#include "recording/recording.h"
#include "recording/trace_reader.h"
#include "replay/event_collector.h"
#include "replay/log_player.h"
#include "sim/simulation.h"

namespace smile::recorder {

/// Throws InputError about a recording.
[[noreturn]] void Fail(const recording::Recording& recording, const std::string& message);

/// Result of a replay up to a point of the history.
struct Reached {
  recording::TracePlace place = 0;  ///< in the trace
  /// Events of the last tick that the log implies and the trace lacks, since the program ended
  /// between writing the two.
  std::vector<sim::Event> untold;
};

/// Replays a recording in a fresh simulation up to a point of its history, and checks that each
/// tick is the same as recorded.
class ReplayAlong {
 public:
  /// @param path  the commands up to the point.
  ReplayAlong(const recording::Recording& recording, std::vector<recording::LoggedCommand> path,
              const recording::HistoryPoint& until, sim::Simulation* simulation);
  ~ReplayAlong() { simulation_->RemoveListener(&collector_); }
  ReplayAlong(const ReplayAlong&) = delete;
  ReplayAlong& operator=(const ReplayAlong&) = delete;

  /// @param on_start  called when the demonstration begins.
  /// @throws InputError if the recording does not lead there, or not as recorded;
  ///         std::runtime_error if `progress` returns false.
  Reached Go(const recording::Progress& progress, const std::function<void()>& on_start = {});

 private:
  [[noreturn]] void FailAsDifferent() const;
  /// Replays one tick; returns false after the last one.
  bool Step();
  /// Checks that the replay reached its end. The trace may lack events of the last tick.
  void CheckEnd() const;

  const recording::Recording& recording_;
  std::vector<recording::LoggedCommand> path_;
  recording::HistoryPoint until_;
  sim::Simulation* simulation_;
  replay::LogPlayer player_;
  recording::TraceReader trace_;
  replay::EventCollector collector_;
  std::optional<recording::TraceTick> last_;
  std::ptrdiff_t num_actions_ = 0;
};

}  // namespace smile::recorder
