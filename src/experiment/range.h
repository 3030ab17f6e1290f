#pragma once

namespace smile::experiment {

/// Interval from which a value is drawn, uniformly.
struct Range {
  double low = 0, high = 0;

  bool operator==(const Range&) const = default;
};

}  // namespace smile::experiment
