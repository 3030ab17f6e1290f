#include "scene/units.h"

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>

namespace smile::scene {

double ToFileUnits(double length, double meters_per_unit) {
  const double quotient = length / meters_per_unit;
  // What people write has few digits: 3 rather than 3.0000000000000004, if both mean `length`.
  for (int digits : {6, 12, 15, 16}) {
    char text[32];
    std::snprintf(text, sizeof text, "%.*g", digits, quotient);
    const double rounded = std::strtod(text, nullptr);
    if (rounded * meters_per_unit == length) return rounded;
  }
  // Division and multiplication round; one of the quotient's neighbours may be the number wanted.
  constexpr int kNeighbours = 4;
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  double below = quotient, above = quotient;
  for (int i = 0; i <= kNeighbours; ++i) {
    if (below * meters_per_unit == length) return below;
    if (above * meters_per_unit == length) return above;
    below = std::nextafter(below, -kInfinity);
    above = std::nextafter(above, kInfinity);
  }
  return quotient;
}

Vector3 ToFileUnits(const Vector3& p, double meters_per_unit) {
  return {ToFileUnits(p.x(), meters_per_unit), ToFileUnits(p.y(), meters_per_unit),
          ToFileUnits(p.z(), meters_per_unit)};
}

}  // namespace smile::scene
