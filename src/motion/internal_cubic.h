#pragma once

namespace smile::motion {

/// The cubic with these values and slopes at both ends of a span of time.
struct Cubic {
  double from, to, from_slope, to_slope, seconds;

  /// At the share `u` of its length, as the other two.
  double At(double u) const {
    const double u2 = u * u, u3 = u2 * u;
    return (2 * u3 - 3 * u2 + 1) * from + (u3 - 2 * u2 + u) * seconds * from_slope +
           (-2 * u3 + 3 * u2) * to + (u3 - u2) * seconds * to_slope;
  }
  double SlopeAt(double u) const {
    const double u2 = u * u;
    return (6 * u2 - 6 * u) * (from - to) / seconds + (3 * u2 - 4 * u + 1) * from_slope +
           (3 * u2 - 2 * u) * to_slope;
  }
  /// How fast the slope changes; a straight line over time.
  double CurveAt(double u) const {
    return ((12 * u - 6) * (from - to) / seconds + (6 * u - 4) * from_slope +
            (6 * u - 2) * to_slope) /
           seconds;
  }
};

}  // namespace smile::motion
