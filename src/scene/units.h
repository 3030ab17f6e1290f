#pragma once

#include "math/rigid_transform.h"

namespace smile::scene {

// Commands, the classic recording, brains and results speak the scene's unit (0.1 m unless it says
// otherwise); C++ speaks metres. These are the conversions between the two. (Scene files have their
// own, with more digits: any scene must come back from its file to the last bit.)

/// A length [units] in metres. Divides by 10 rather than multiplying by 0.1, which no double is: 12
/// units are exactly 1.2 m.
inline double FromFileUnits(double length, double meters_per_unit) {
  return length / (1.0 / meters_per_unit);
}
inline Vector3 FromFileUnits(const Vector3& p, double meters_per_unit) {
  return p / (1.0 / meters_per_unit);
}

/// A length [m] in units, chosen so that FromFileUnits() gives the same bits again whenever
/// `length` itself came out of FromFileUnits(): what was read, simulated and logged reads the same.
double ToFileUnits(double length, double meters_per_unit);
Vector3 ToFileUnits(const Vector3& p, double meters_per_unit);

/// The nearest length that survives being written and read.
inline double OnFileGrid(double length, double meters_per_unit) {
  return FromFileUnits(ToFileUnits(length, meters_per_unit), meters_per_unit);
}
inline Vector3 OnFileGrid(const Vector3& p, double meters_per_unit) {
  return FromFileUnits(ToFileUnits(p, meters_per_unit), meters_per_unit);
}

}  // namespace smile::scene
