#pragma once

#include <algorithm>
#include <chrono>
#include <functional>

namespace smile::process {

/// Limit on waiting: a timeout and a cancellation. Waiting happens in slices, so that both are
/// noticed soon.
class WaitLimit {
 public:
  using Clock = std::chrono::steady_clock;

  explicit WaitLimit(double seconds, std::function<bool()> is_cancelled = {})
      : deadline_(Clock::now() + std::chrono::duration_cast<Clock::duration>(
                                     std::chrono::duration<double>(std::clamp(seconds, 0.0, 1e6)))),
        is_cancelled_(std::move(is_cancelled)) {}

  bool HasPassed() const { return Clock::now() >= deadline_; }
  bool IsCancelled() const { return is_cancelled_ && is_cancelled_(); }
  /// Returns the next slice for poll() [ms], 0 to `longest_ms`.
  int SliceMs(int longest_ms) const {
    const auto left = std::chrono::ceil<std::chrono::milliseconds>(deadline_ - Clock::now());
    return static_cast<int>(std::clamp<long long>(left.count(), 0, longest_ms));
  }

 private:
  Clock::time_point deadline_;
  std::function<bool()> is_cancelled_;
};

}  // namespace smile::process
