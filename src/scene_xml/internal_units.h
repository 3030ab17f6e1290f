#pragma once

#include <string>

namespace smile::scene_xml {

// Conversion between lengths of scene files and meters; the only place for it.
//
// A recording keeps its scene as a file and replays from it, so meters must survive writing and
// reading to the last bit. With `double` on both sides they cannot: times 0.1, the doubles of [1,
// 1.25) units fall on [0.1, 0.125) m, where doubles lie denser, and miss some. Units are therefore
// read as `long double`, whose 11 further bits reach every double of metres, and written with as
// many digits as that takes: 15 for nearly all, never more than 21.

/// @param units            a length in the file.
/// @param meters_per_unit  of the file [m]; positive.
double MetersFromUnits(long double units, double meters_per_unit);

/// Returns the shortest exact text: ParseNumber<long double>() and MetersFromUnits() make exactly
/// `meters` of it.
std::string UnitsText(double meters, double meters_per_unit);

}  // namespace smile::scene_xml
