#include "studio/internal_frame_timer.h"

#include <algorithm>

// Ticks are owed as a fraction, since the requested speed need not be a whole number of ticks per
// frame. The timer reads no clock: its caller passes the time, so that tests can.

namespace smile::studio {
namespace {

using namespace std::chrono_literals;

/// Later ticks are dropped. Covers the time of rendering a large picture.
constexpr auto kMaxLateness = 100ms;
constexpr double kMaxLateFrames = 6;  // kMaxLateness in frames

}  // namespace

int FrameTimer::BeginFrame(Time now) {
  // After a long interruption the schedule restarts near `now`, so that frames do not catch up in a
  // burst.
  next_frame_ = std::max(next_frame_, now - kMaxLateness) + kFramePeriod;
  // Fractional ticks accumulate: at factor 0.5, every second frame has a tick.
  owed_ticks_ += factor_;
  const int ticks = static_cast<int>(owed_ticks_);
  owed_ticks_ -= ticks;
  return ticks;
}

void FrameTimer::EndFrame(int done, int waiting, Time now) {
  // Ticks that could not be done yet remain due, up to the limit; ticks for which there was no time
  // are lost.
  owed_ticks_ = std::min(owed_ticks_ + waiting, kMaxLateFrames * std::max(factor_, 1.0));
  ticks_ += done;
  samples_.push_back({now, ticks_});
  // A sliding window of about one second for the measured speed.
  while (samples_.size() > 2 && now - samples_.front().time > 1s) samples_.pop_front();
}

double FrameTimer::speed() const {
  if (samples_.size() < 2) return 0;
  // The window shrinks to what has passed since the start, so the first values come early.
  const std::chrono::duration<double> passed = samples_.back().time - samples_.front().time;
  if (passed.count() <= 0) return 0;
  return static_cast<double>(samples_.back().ticks - samples_.front().ticks) /
         (kFramesPerSecond * passed.count());
}

}  // namespace smile::studio
