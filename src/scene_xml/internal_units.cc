#include "scene_xml/internal_units.h"

#include <charconv>
#include <limits>

#include "base/demand.h"
#include "scene_xml/internal_values.h"

namespace smile::scene_xml {
namespace {

static_assert(std::numeric_limits<long double>::digits >= 64,
              "units are read with more bits than a double has");

/// Inverse of the unit. Lengths are divided by 10 and not multiplied by 0.1, which is not
/// representable: 12 units are exactly 1.2 m.
long double UnitsPerMeter(double meters_per_unit) { return 1.0 / meters_per_unit; }

}  // namespace

double MetersFromUnits(long double units, double meters_per_unit) {
  return static_cast<double>(units / UnitsPerMeter(meters_per_unit));
}

std::string UnitsText(double meters, double meters_per_unit) {
  // Nearly exact: the text is what must read back, so the loop tries and does not trust.
  const long double units = meters * UnitsPerMeter(meters_per_unit);
  std::string text;
  // The fewest digits that read back to the same meters, bit by bit; 15 are enough for most.
  for (int num_digits = 15; num_digits <= std::numeric_limits<long double>::max_digits10;
       ++num_digits) {
    char buffer[64];
    const auto result = std::to_chars(buffer, buffer + sizeof buffer, units,
                                      std::chars_format::general, num_digits);
    text.assign(buffer, result.ptr);
    if (MetersFromUnits(*ParseNumber<long double>(text), meters_per_unit) == meters) return text;
  }
  SMILE_DEMAND(false && "a long double reaches every double of metres");
  return text;
}

}  // namespace smile::scene_xml
