#pragma once

#include <chrono>
#include <deque>

namespace smile::studio {

/// Frame timer: synchronizes simulated time with wall-clock time, 60 frames per second. When ticks
/// take longer than the time they simulate, late ticks are dropped: simulated time slows down, and
/// speed() reports it.
class FrameTimer {
 public:
  using Time = std::chrono::steady_clock::time_point;
  static constexpr int kFramesPerSecond = 60;
  static constexpr std::chrono::nanoseconds kFramePeriod{1'000'000'000 / kFramesPerSecond};

  explicit FrameTimer(Time now) : next_frame_(now) {}

  /// Sets the requested ratio of simulated to wall-clock time.
  void SetFactor(double factor) { factor_ = factor; }
  /// Begins a frame.
  /// @returns the number of ticks due in it; the caller does as many as fit into kFramePeriod.
  int BeginFrame(Time now);
  /// Ends a frame.
  /// @param done     number of ticks that were done.
  /// @param waiting  number of ticks that could not be done yet: they are due in the next frame as
  ///                 well, and dropped when they are too late.
  void EndFrame(int done, int waiting, Time now);
  Time next_frame() const { return next_frame_; }
  /// Returns the ratio of simulated to wall-clock time over the last second; 0 at first.
  double speed() const;

 private:
  struct Sample {
    Time time;
    long ticks = 0;
  };

  Time next_frame_;
  double factor_ = 1;
  double owed_ticks_ = 0;
  long ticks_ = 0;
  std::deque<Sample> samples_;  ///< one per frame, of the last second
};

}  // namespace smile::studio
