#include "scene/units.h"

#include <cmath>
#include <limits>

// Lengths in SI to numbers in the unit of a file such that reading returns the same bits. Unlike
// for scene files, which use extended precision (scene_xml/internal_units.h), doubles suffice here:
// values are rounded to the file grid before they are used.

namespace smile::scene {

double ToFileUnits(double length, double meters_per_unit) {
  // Rounding may make the product miss the number that converts back to `length`; one of its
  // neighbors may be that number.
  constexpr int kNeighbours = 4;
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  const double product = length * (1.0 / meters_per_unit);
  double below = product, above = product;
  for (int i = 0; i <= kNeighbours; ++i) {
    if (FromFileUnits(below, meters_per_unit) == length) return below;
    if (FromFileUnits(above, meters_per_unit) == length) return above;
    below = std::nextafter(below, -kInfinity);
    above = std::nextafter(above, kInfinity);
  }
  return product;
}

Vector3 ToFileUnits(const Vector3& p, double meters_per_unit) {
  return {ToFileUnits(p.x(), meters_per_unit), ToFileUnits(p.y(), meters_per_unit),
          ToFileUnits(p.z(), meters_per_unit)};
}

}  // namespace smile::scene
