#pragma once

#include <chrono>
#include <deque>

namespace smile::studio {

/// Keeps the simulation's time in step with the clock on the wall, 60 beats a second. When ticks
/// take longer than they last, what is late is dropped: time goes slower, and speed() says so.
class Pacer {
 public:
  using Time = std::chrono::steady_clock::time_point;
  static constexpr int kBeatsPerSecond = 60;
  static constexpr std::chrono::nanoseconds kBeat{1'000'000'000 / kBeatsPerSecond};

  explicit Pacer(Time now) : next_beat_(now) {}

  /// Of simulated to real time.
  void SetFactor(double factor) { factor_ = factor; }
  /// A beat begins.
  /// @returns how many ticks are to be done in it, as many as can be within a kBeat.
  int BeginBeat(Time now);
  /// So many were done. So many others wait for somebody: they are due again, with what is due
  /// then; what waits for longer than a moment is dropped.
  void EndBeat(int done, int waiting, Time now);
  Time next_beat() const { return next_beat_; }
  /// Simulated per real second, over the last second; 0 in the beginning.
  double speed() const;

 private:
  struct Mark {
    Time time;
    long ticks = 0;
  };

  Time next_beat_;
  double factor_ = 1;
  double owed_ticks_ = 0;
  long ticks_ = 0;
  std::deque<Mark> marks_;  ///< one a beat, of the last second
};

}  // namespace smile::studio
