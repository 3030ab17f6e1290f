#include "studio/internal_frame_timer.h"

#include <algorithm>

namespace smile::studio {
namespace {

using namespace std::chrono_literals;

/// Later ticks are dropped. Covers the time of rendering a large picture.
constexpr auto kMaxLateness = 100ms;
constexpr double kMaxLateFrames = 6;  // kMaxLateness in frames

}  // namespace

int FrameTimer::BeginFrame(Time now) {
  next_frame_ = std::max(next_frame_, now - kMaxLateness) + kFramePeriod;
  owed_ticks_ += factor_;
  const int ticks = static_cast<int>(owed_ticks_);
  owed_ticks_ -= ticks;
  return ticks;
}

void FrameTimer::EndFrame(int done, int waiting, Time now) {
  owed_ticks_ = std::min(owed_ticks_ + waiting, kMaxLateFrames * std::max(factor_, 1.0));
  ticks_ += done;
  samples_.push_back({now, ticks_});
  while (samples_.size() > 2 && now - samples_.front().time > 1s) samples_.pop_front();
}

double FrameTimer::speed() const {
  if (samples_.size() < 2) return 0;
  const std::chrono::duration<double> passed = samples_.back().time - samples_.front().time;
  if (passed.count() <= 0) return 0;
  return static_cast<double>(samples_.back().ticks - samples_.front().ticks) /
         (kFramesPerSecond * passed.count());
}

}  // namespace smile::studio
