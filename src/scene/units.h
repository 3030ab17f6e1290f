#pragma once

#include "math/rigid_transform.h"

namespace smile::scene {

// Conversions between meters and the scene's unit (0.1 m unless it says otherwise). Commands,
// classic recordings, brains and results use the unit; C++ uses meters. Scene files have
// conversions of their own, with more digits: any scene must come back from its file to the last
// bit.

/// Returns a length [units] in meters. Divides by 10 and does not multiply by 0.1, which is not
/// representable: 12 units are exactly 1.2 m.
inline double FromFileUnits(double length, double meters_per_unit) {
  return length / (1.0 / meters_per_unit);
}
inline Vector3 FromFileUnits(const Vector3& p, double meters_per_unit) {
  return p / (1.0 / meters_per_unit);
}

/// Returns a length [m] in units, chosen so that FromFileUnits() returns the same bits again if
/// `length` itself came from FromFileUnits(): values that were read, simulated and logged read the
/// same.
double ToFileUnits(double length, double meters_per_unit);
Vector3 ToFileUnits(const Vector3& p, double meters_per_unit);

/// Returns the nearest length that survives being written and read.
inline double OnFileGrid(double length, double meters_per_unit) {
  return FromFileUnits(ToFileUnits(length, meters_per_unit), meters_per_unit);
}
inline Vector3 OnFileGrid(const Vector3& p, double meters_per_unit) {
  return FromFileUnits(ToFileUnits(p, meters_per_unit), meters_per_unit);
}

}  // namespace smile::scene
