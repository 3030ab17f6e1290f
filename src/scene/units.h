#pragma once

#include "math/rigid_transform.h"

namespace smile::scene {

// Files, the classic recording and brains speak the scene's unit (0.1 m unless it says otherwise);
// C++ speaks metres. These are the only conversions of lengths that may be written down and read
// again.

/// A length from a file [units] in metres.
inline double FromFileUnits(double length, double meters_per_unit) {
  return length * meters_per_unit;
}
inline Vector3 FromFileUnits(const Vector3& p, double meters_per_unit) {
  return p * meters_per_unit;
}

/// A length [m] in the file's unit, chosen so that FromFileUnits() gives the same bits again
/// whenever `length` itself came out of FromFileUnits(): what was read, simulated and logged reads
/// the same.
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
