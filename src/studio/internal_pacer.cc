#include "studio/internal_pacer.h"

#include <algorithm>

namespace smile::studio {
namespace {

using namespace std::chrono_literals;

/// So much is made up for, as after a picture that took long.
constexpr auto kMostLate = 100ms;
constexpr double kMostLateBeats = 6;  // the same

}  // namespace

int Pacer::BeginBeat(Time now) {
  next_beat_ = std::max(next_beat_, now - kMostLate) + kBeat;
  owed_ticks_ += factor_;
  const int ticks = static_cast<int>(owed_ticks_);
  owed_ticks_ -= ticks;
  return ticks;
}

void Pacer::EndBeat(int done, int waiting, Time now) {
  owed_ticks_ = std::min(owed_ticks_ + waiting, kMostLateBeats * std::max(factor_, 1.0));
  ticks_ += done;
  marks_.push_back({now, ticks_});
  while (marks_.size() > 2 && now - marks_.front().time > 1s) marks_.pop_front();
}

double Pacer::speed() const {
  if (marks_.size() < 2) return 0;
  const std::chrono::duration<double> passed = marks_.back().time - marks_.front().time;
  if (passed.count() <= 0) return 0;
  return static_cast<double>(marks_.back().ticks - marks_.front().ticks) /
         (kBeatsPerSecond * passed.count());
}

}  // namespace smile::studio
