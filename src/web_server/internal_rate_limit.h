#pragma once

#include <algorithm>
#include <chrono>

namespace smile::web_server {

/// Token bucket: allows a number of units per second, and as many at once after a quiet second.
class RateLimit {
 public:
  using Time = std::chrono::steady_clock::time_point;

  RateLimit(double per_second, Time now) : per_second_(per_second), left_(per_second), last_(now) {}

  /// Counts `count` units; returns false if they came too fast.
  [[nodiscard]] bool Allow(double count, Time now) {
    const std::chrono::duration<double> passed = now - last_;
    last_ = now;
    left_ = std::min(per_second_, left_ + passed.count() * per_second_) - count;
    return left_ >= 0;
  }

 private:
  double per_second_, left_;
  Time last_;
};

}  // namespace smile::web_server
