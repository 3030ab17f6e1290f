#pragma once

namespace smile::motion {

/// Cubic Hermite polynomial: given values and derivatives at both ends of a time span.
struct Cubic {
  double from, to, from_derivative, to_derivative, seconds;

  /// Returns the value at the fraction `u` of the span; the next two functions return its
  /// derivatives.
  double At(double u) const {
    const double u2 = u * u, u3 = u2 * u;
    return (2 * u3 - 3 * u2 + 1) * from + (u3 - 2 * u2 + u) * seconds * from_derivative +
           (-2 * u3 + 3 * u2) * to + (u3 - u2) * seconds * to_derivative;
  }
  double DerivativeAt(double u) const {
    const double u2 = u * u;
    return (6 * u2 - 6 * u) * (from - to) / seconds + (3 * u2 - 4 * u + 1) * from_derivative +
           (3 * u2 - 2 * u) * to_derivative;
  }
  /// Linear in u, so its extremes are at the ends.
  double SecondDerivativeAt(double u) const {
    return ((12 * u - 6) * (from - to) / seconds + (6 * u - 4) * from_derivative +
            (6 * u - 2) * to_derivative) /
           seconds;
  }
};

}  // namespace smile::motion
